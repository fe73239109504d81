#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The liquid on one and on two ranks, in turn, on 35 280 and 301 056 cells: speed, and growth of iterations.
#
#   benchmarks/fluid_ranks.sh [ROUNDS]
#
# By wall time: needs two quiet cores. TOLERANCE and STEPS may be set. Both meshes make as many steps: iterations fall as
# the flow develops.
set -euo pipefail

here=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")" && pwd)
rounds=${1:-5}
programs=${PROGRAMS:-$here/../build/benchmark/benchmarks}
tolerance=${TOLERANCE:-1e-8}
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

median() { sort -g | awk '{ v[NR] = $1 } END { print (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2 }'; }
seconds() { sed 's/.*ranks: \([^ ]*\) s per step.*/\1/' <<<"$1"; }

for cells in "21 28 60 ${STEPS:-20}" "42 56 128 ${STEPS:-20}"; do
  ratios=()
  for ((round = 1; round <= rounds; ++round)); do
    # shellcheck disable=SC2086
    one=$(taskset -c 0 "$programs/fluid_steps" $cells "$tolerance")
    # shellcheck disable=SC2086
    two=$(mpiexec --bind-to core -n 2 "$programs/fluid_steps" $cells "$tolerance")
    ratios+=("$(awk -v a="$(seconds "$one")" -v b="$(seconds "$two")" 'BEGIN { print a / b }')")
    echo "$one"
    echo "$two"
  done
  echo "two ranks over one: $(printf '%s\n' "${ratios[@]}" | median)"
done
