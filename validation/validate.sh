#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs validations piece by piece and compares them with their references; validation/README.md.
#
#   validation/validate.sh PROGRAMS RESULTS [NAME...]
#
# PROGRAMS: folder with one program per validation. RESULTS: folder for their tables. A piece whose
# table is there and was written by the same program is not run again.
set -euo pipefail

programs=$(cd -- "$1" && pwd) results=$2
shift 2
jobs=${PACKBED_JOBS:-$(nproc)}
limit=${PACKBED_PIECE_LIMIT:-45m}

say() { printf 'validate: %s\n' "$*" >&2; }

mapfile -t known < <(find "$programs" -maxdepth 1 -type f -perm -u+x -printf '%f\n' | LC_ALL=C sort)
names=("$@")
((${#names[@]})) || names=("${known[@]}")
for name in "${names[@]}"; do
  [[ -n $name && -x $programs/$name ]] && continue
  say "there is no validation \"$name\"; there are: ${known[*]}"
  exit 1
done

# The content of all that a validation depends on: the program, which holds the libraries of packbed,
# and the files that it names.
fingerprint() {
  local files file
  files=$("$programs/$1" files)
  {
    sha256sum <"$programs/$1"
    while read -r file; do [[ -z $file ]] || sha256sum <"$file"; done <<<"$files"
  } | sha256sum | cut -d ' ' -f 1
}

# run_piece NAME PIECE FINGERPRINT: its table is there at the end, or nothing is.
run_piece() {
  local table=$results/$1/$2.csv began=$SECONDS
  if [[ -f $table && $(head -n 1 "$table") == "# program $3" ]]; then
    say "$1 $2: done before"
    return 0
  fi
  rm -f "$table"
  printf '# program %s\n' "$3" >"$table.part"
  if ! timeout "$limit" nice -n 10 "$programs/$1" run "$2" >>"$table.part" 2>"$results/$1/$2.log"; then
    rm -f "$table.part"
    tail -n 3 "$results/$1/$2.log" >&2
    say "$1 $2: broke off or took longer than $limit; see $results/$1/$2.log"
    return 1
  fi
  if [[ $(fingerprint "$1") != "$3" ]]; then
    rm -f "$table.part"
    say "$1 $2: the program changed while it ran; call again"
    return 1
  fi
  mv "$table.part" "$table"
  say "$1 $2: $((SECONDS - began)) s"
}
export -f fingerprint run_piece say
export programs results limit

failed=0
plan=()
for name in "${names[@]}"; do
  mkdir -p "$results/$name"
  print=$(fingerprint "$name")
  pieces=$("$programs/$name" pieces)
  while read -r piece; do plan+=("$name" "$piece" "$print"); done <<<"$pieces"
done
printf '%s\0' "${plan[@]}" |
  xargs -0 -n 3 -P "$jobs" bash -c 'run_piece "$@"' run_piece || failed=1

for name in "${names[@]}"; do
  printf '\n%s\n' "$name"
  "$programs/$name" judge "$results/$name" || failed=1
done
((failed)) && say "FAILED: a figure is outside its limits, or a piece is missing"
exit "$failed"
