#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Our time steps against those of LIGGGHTS on the same bed, in turn on one core, by processor time.
#
#   benchmarks/compare_liggghts.sh BED [ROUNDS]      BED: b2k, b18k, s18k, b223k, b1m
#
# Needs our programs (./packbed benchmark builds them), a C compiler, and LIGGGHTS: the variable names one
# binary or more, LIGGGHTS="liggghts /path/to/another" (default: that of apt-get install
# --no-install-recommends liggghts). STEP [s], WARM, COUNT and REPEATS may be set; CORE is the core used.
# Medians of blocks of COUNT steps, without start-up. Processor time does not count others on the core, but
# they take cache and memory all the same: cpu/wall tells how many there were.
set -euo pipefail

here=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")" && pwd)
bed=${1:?a bed: b2k, b18k, s18k, b223k or b1m}
rounds=${2:-5}
programs=${PROGRAMS:-$here/../build/benchmark/benchmarks}
read -ra others <<<"${LIGGGHTS:-liggghts}"
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
"${CC:-cc}" -O1 -shared -fPIC -o "$scratch/clock.so" "$here/processor_clock.c"

median() { sort -g | awk '{ v[NR] = $1 } END { print (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2 }'; }
ratio() { awk -v a="$1" -v b="$2" 'BEGIN { print a / b }'; }
median_of() { awk -v p="$1" '$1 == p { print $2 }' "$scratch/$2" | median; }

run_liggghts() (
  cd "$scratch"
  LD_PRELOAD=$scratch/clock.so taskset -c "$core" "$1" -in "$here/in.liggghts" -var bed "$file" -var xb $xb \
    -var xw $xw -var lx "$lx" -var dt "$step" -var warm "$warm" -var n "$count" -var rep "$repeats" -log none |
    awk -v n="$beads" '/^Loop time/ && ++block > 1 { print 1e-6 * n * $9 / $4 }' | median
)

for ((round = 1; round <= rounds; ++round)); do
  ran=$(taskset -c "$core" "$programs/time_steps" "$bed" "$step" "$warm" "$count" "$repeats" | grep 'by wall time')
  ours=$(awk '{ print $9 }' <<<"$ran" | median)
  share=$(awk '{ print $4 / $9 }' <<<"$ran" | median)
  echo "packbed $ours" >>"$scratch/speeds"
  echo "$bed round $round: packbed $ours million bead-steps/s (cpu/wall $share)"
  for other in "${others[@]}"; do
    theirs=$(run_liggghts "$other")
    times=$(ratio "$ours" "$theirs")
    echo "$other $theirs" >>"$scratch/speeds"
    echo "$other $times" >>"$scratch/ratios"
    echo "$bed round $round: $other $theirs, ratio $times"
  done
done
echo "$bed median: packbed $(median_of packbed speeds)"
for other in "${others[@]}"; do
  echo "$bed median: $other $(median_of "$other" speeds), ratio $(median_of "$other" ratios)"
done
