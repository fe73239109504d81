#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The driver of the validations with a program of two pieces: runs, skips what is done, runs anew
# what has changed, keeps no half table, and fails when it should.
#
#   validate_test.sh DRIVER
set -uo pipefail
driver=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/programs"
cat >"$folder/programs/fake" <<'PROGRAM'
#!/usr/bin/env bash
here=$(dirname "$0")/..
case $1 in
  pieces) printf 'one\ntwo\n' ;;
  files) echo "$here/input" ;;
  run)
    echo "$2" >>"$here/runs"
    echo "value"
    [[ ! -e $here/break-$2 ]] || exit 1
    cat "$here/input"
    ;;
  judge) [[ $(tail -n 1 "$2/one.csv") == 1 && $(tail -n 1 "$2/two.csv") == 1 ]] ;;
esac
PROGRAM
chmod +x "$folder/programs/fake"

wrong=0
# expect WHAT CODE RUNS [ARGUMENT...]: runs the driver; RUNS pieces must have run.
expect() {
  local what=$1 code=$2 runs=$3
  shift 3
  : >"$folder/runs"
  "$driver" "$folder/programs" "$folder/results" "$@" >"$folder/out" 2>&1
  local got=$? ran
  ran=$(wc -l <"$folder/runs")
  [[ $got == "$code" && $ran == "$runs" ]] && return
  printf '%s: code %s, %s pieces run; expected %s, %s\n' "$what" "$got" "$ran" "$code" "$runs"
  cat "$folder/out"
  wrong=1
}

echo 1 >"$folder/input"
expect 'first call' 0 2
expect 'second call' 0 0
rm "$folder/results/fake/two.csv"
expect 'a table lost' 0 1
echo '# changed' >>"$folder/programs/fake"
expect 'another program' 0 2 fake
echo 2 >"$folder/input"
expect 'another input, and a figure outside' 1 2
echo 1 >"$folder/input"
touch "$folder/break-two"
expect 'a piece that breaks' 1 2
[[ ! -e $folder/results/fake/two.csv ]] || { echo 'a half table was kept'; wrong=1; }
rm "$folder/break-two"
expect 'resumed' 0 1
expect 'no such validation' 1 0 nothing
exit "$wrong"
