#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Format, static checks and include check.
#
#   tools/check.sh          format and tidy of the files changed since the last commit of main
#   tools/check.sh --all    of all files (minutes)
#   tools/check.sh --fix    also rewrites the format of those files
set -uo pipefail
cd "$(dirname "$0")/.."

all=no fix=no
for option in "$@"; do
  case $option in
    --all) all=yes ;;
    --fix) fix=yes ;;
    *)
      printf 'usage: tools/check.sh [--all] [--fix]\n' >&2
      exit 1
      ;;
  esac
done
packages=(clang-format-14 clang-tidy-14 cppcheck python3-minimal)
for tool in clang-format-14 clang-tidy-14 cppcheck python3; do
  command -v "$tool" >/dev/null && continue
  printf 'check: %s is missing; apt-get install -y --no-install-recommends %s\n' "$tool" "${packages[*]}" >&2
  exit 3
done

changed() {
  if [[ $all == yes ]]; then
    git ls-files -- 'src/*.[hc]pp' 'tests/*.[hc]pp' 'benchmarks/*.[hc]pp'
  else
    local base
    base=$(git merge-base HEAD origin/main 2>/dev/null || git rev-parse HEAD)
    { git diff --name-only --diff-filter=d "$base"; git ls-files --others --exclude-standard; } |
      grep -E '^(src|tests|benchmarks)/.*\.[hc]pp$' | sort -u
  fi
}
mapfile -t files < <(changed)
mapfile -t sources < <(printf '%s\n' "${files[@]}" | grep '\.cpp$' | grep -v '^benchmarks/')
failed=0
run() {
  printf 'check: %s\n' "$1" >&2
  shift
  "$@" 2> >(grep -v -e 'warnings generated' -e 'Suppressed' -e 'Use -header-filter' >&2) || failed=1
}

if ((${#files[@]})); then
  [[ $fix == yes ]] && clang-format-14 -i "${files[@]}"
  run format clang-format-14 --dry-run --Werror "${files[@]}"
fi
if ((${#sources[@]})); then
  [[ -f build/tidy/compile_commands.json ]] ||
    cmake -S . -B build/tidy -G Ninja -DCMAKE_BUILD_TYPE=Debug -DPACKBED_ARCH= >/dev/null
  # Each file by itself: one crash of the tool must not hide the findings of the others.
  run tidy sh -c 'printf "%s\n" "$@" | xargs -P "$(nproc)" -n 1 clang-tidy-14 -p build/tidy --quiet' tidy "${sources[@]}"
fi
# missingReturn: cppcheck 2.10 does not know [[noreturn]] members; the compiler does.
# ctuArrayIndex: it takes vector registers that a function fills for arrays out of bounds.
run cppcheck cppcheck --std=c++20 --enable=warning,performance,portability --inline-suppr \
  --error-exitcode=1 --quiet --suppress=missingReturn --suppress=ctuArrayIndex:src/dem/lanes.hpp -I src src
run includes python3 tools/check_includes.py src
((failed)) && printf 'check: FAILED\n' >&2
exit "$failed"
