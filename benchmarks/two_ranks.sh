#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# One bed on two ranks against two independent copies, each on a core of its own, in turn.
#
#   benchmarks/two_ranks.sh [BED [ROUNDS]]           BED: b223k unless named
#
# Both by wall time: needs two quiet cores. Efficiency is bead-steps per second of the bed on two ranks over
# the sum of those of the two copies.
set -euo pipefail

here=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")" && pwd)
bed=${1:-b223k}
rounds=${2:-5}
programs=${PROGRAMS:-$here/../build/benchmark/benchmarks}
export PACKBED_BEDS=${PACKBED_BEDS:-$here/../build/beds}
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
step=${STEP:-1e-6} warm=${WARM:-100} count=${COUNT:-40} repeats=${REPEATS:-3}
mkdir -p "$PACKBED_BEDS"

median() { sort -g | awk '{ v[NR] = $1 } END { print (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2 }'; }
time_steps() { "$@" "$programs/time_steps" "$bed" "$step" "$warm" "$count" "$repeats"; }
speed() { awk '/by wall time/ { print $4 }' | median; }

ratios=()
for ((round = 1; round <= rounds; ++round)); do
  shared=$(time_steps mpiexec --bind-to core -n 2 | speed)
  other=$(mktemp)
  time_steps taskset -c 1 >"$other" &
  first=$(time_steps taskset -c 0 | speed)
  wait
  second=$(speed <"$other")
  rm "$other"
  ratio=$(awk -v s="$shared" -v a="$first" -v b="$second" 'BEGIN { print s / (a + b) }')
  ratios+=("$ratio")
  echo "$bed round $round: two ranks $shared, two copies $first + $second million bead-steps/s, efficiency $ratio"
done
echo "$bed median efficiency: $(printf '%s\n' "${ratios[@]}" | median)"
