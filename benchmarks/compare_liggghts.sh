#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Our time steps against those of LIGGGHTS on the same bed, in turn on one core, by wall time.
#
#   benchmarks/compare_liggghts.sh BED [ROUNDS]      BED: b2k, b18k, s18k, b223k, b1m
#
# Needs LIGGGHTS (apt-get install --no-install-recommends liggghts, or LIGGGHTS=/path/to/it) and our programs
# (./packbed benchmark builds them). STEP [s], WARM, COUNT and REPEATS may be set; CORE is the core used.
# Both by their own clocks of wall time, medians of blocks of COUNT steps: needs a quiet core. Ours tells the
# processor time too: if the two differ, others were on the core.
set -euo pipefail

here=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")" && pwd)
bed=${1:?a bed: b2k, b18k, s18k, b223k or b1m}
rounds=${2:-5}
programs=${PROGRAMS:-$here/../build/benchmark/benchmarks}
liggghts=${LIGGGHTS:-liggghts}
export PACKBED_BEDS=${PACKBED_BEDS:-$here/../build/beds}
step=${STEP:-1e-6} core=${CORE:-0}
case $bed in
  b2k) warm=2000 count=2000 ;;
  b18k | s18k) warm=1000 count=300 ;;
  b223k) warm=100 count=40 ;;
  b1m) warm=20 count=10 ;;
  *) echo "no bed called $bed" >&2; exit 1 ;;
esac
warm=${WARM:-$warm} count=${COUNT:-$count} repeats=${REPEATS:-3}
mkdir -p "$PACKBED_BEDS"
file=$PACKBED_BEDS/$bed.data
[[ -f $file ]] || "$programs/write_bed" "$bed" "$file"
xb=p xw=0
grep -q '^bed, walls in x' "$file" && xb=f xw=1
lx=$(awk '/xlo/ { print $2 }' "$file")
beads=$(awk '/ atoms/ { print $1 }' "$file")

# LIGGGHTS leaves restart files where it runs if it is stopped.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
file=$(readlink -f -- "$file")

run_liggghts() (
  cd "$scratch"
  taskset -c "$core" "$liggghts" -in "$here/in.liggghts" -var bed "$file" -var xb $xb -var xw $xw \
    -var lx "$lx" -var dt "$step" -var warm "$warm" -var n "$count" -var rep "$repeats" -log none |
    awk -v n="$beads" '/^Loop time/ && ++block > 1 { print 1e-6 * n * $9 / $4 }' | median
)

median() { sort -g | awk '{ v[NR] = $1 } END { print (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2 }'; }

ours=() theirs=() ratios=()
for ((round = 1; round <= rounds; ++round)); do
  ran=$(taskset -c "$core" "$programs/time_steps" "$bed" "$step" "$warm" "$count" "$repeats")
  a=$(awk '/by wall time/ { print $4 }' <<<"$ran" | median)
  cpu=$(awk '/by wall time/ { print $4 / $9 }' <<<"$ran" | median)
  b=$(run_liggghts)
  ratio=$(awk -v a="$a" -v b="$b" 'BEGIN { print a / b }')
  ours+=("$a") theirs+=("$b") ratios+=("$ratio")
  echo "$bed round $round: packbed $a, LIGGGHTS $b million bead-steps/s, ratio $ratio (cpu/wall $cpu)"
done
echo "$bed median: packbed $(printf '%s\n' "${ours[@]}" | median)," \
  "LIGGGHTS $(printf '%s\n' "${theirs[@]}" | median), ratio $(printf '%s\n' "${ratios[@]}" | median)"
