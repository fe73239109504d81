#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Time per step of the liquid against OpenFOAM's pisoFoam on the same box, in turn on one core.
#
#   benchmarks/compare_openfoam.sh [ROUNDS]
#
# 35 280 cells (21 x 28 x 60, 10 x 10 x 70 mm), water, 1 mm/s from the top, no-slip walls, steps of 1 ms, two correctors,
# Crank-Nicolson 0.3, MUSCL. pisoFoam: PCG/DIC, tolerance 1e-6 of its normalized residual. Ours: the tolerance is that of
# continuity over what passes the cells; 1e-6, and 2e-9 (TIGHT), at which both leave the same continuity error.
# Needs OpenFOAM (apt-get install --no-install-recommends openfoam) and our programs (./packbed benchmark builds
# them). CORE is the core used. By processor time, medians over the second half of the steps.
set -euo pipefail

here=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")" && pwd)
rounds=${1:-5}
programs=${PROGRAMS:-$here/../build/benchmark/benchmarks}
core=${CORE:-0} steps=${STEPS:-40} tight=${TIGHT:-2e-9}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
control=$(dpkg -L openfoam libopenfoam 2>/dev/null | grep 'openfoam/etc/controlDict$' | head -n 1)
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-${control%/etc/controlDict}}

# dictionary FILE CLASS OBJECT: its text from standard input.
dictionary() {
  { printf 'FoamFile { version 2.0; format ascii; class %s; object %s; }\n' "$2" "$3"; cat; } >"$work/$1"
}

write_case() {
  mkdir -p "$work"/{0,constant,system}
  dictionary system/blockMeshDict dictionary blockMeshDict <<'X'
scale 1;
vertices ((0 0 0) (0.01 0 0) (0.01 0.01 0) (0 0.01 0) (0 0 0.07) (0.01 0 0.07) (0.01 0.01 0.07) (0 0.01 0.07));
blocks (hex (0 1 2 3 4 5 6 7) (21 28 60) simpleGrading (1 1 1));
boundary (inlet { type patch; faces ((4 5 6 7)); } outlet { type patch; faces ((0 3 2 1)); }
  walls { type wall; faces ((0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7)); });
X
  dictionary system/controlDict dictionary controlDict <<X
application pisoFoam; startFrom startTime; startTime 0; stopAt endTime; deltaT 0.001;
endTime $(awk -v n="$steps" 'BEGIN { print 0.001 * n }'); writeControl runTime; writeInterval 1000;
timePrecision 8; writeFormat binary; runTimeModifiable no;
X
  dictionary system/fvSchemes dictionary fvSchemes <<'X'
ddtSchemes { default CrankNicolson 0.3; } gradSchemes { default Gauss linear; }
divSchemes { default none; div(phi,U) Gauss MUSCL; div((nuEff*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear orthogonal; } interpolationSchemes { default linear; }
snGradSchemes { default orthogonal; }
X
  dictionary system/fvSolution dictionary fvSolution <<'X'
solvers { p { solver PCG; preconditioner DIC; tolerance 1e-6; relTol 0.1; }
  pFinal { solver PCG; preconditioner DIC; tolerance 1e-6; relTol 0; }
  "(U|UFinal)" { solver PBiCGStab; preconditioner DILU; tolerance 1e-5; relTol 0; } }
PISO { nCorrectors 2; nNonOrthogonalCorrectors 0; }
X
  dictionary constant/transportProperties dictionary transportProperties <<<'transportModel Newtonian; nu 1e-6;'
  dictionary constant/turbulenceProperties dictionary turbulenceProperties <<<'simulationType laminar;'
  dictionary 0/U volVectorField U <<'X'
dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 -0.001);
boundaryField { inlet { type fixedValue; value uniform (0 0 -0.001); } outlet { type zeroGradient; }
  walls { type noSlip; } }
X
  dictionary 0/p volScalarField p <<'X'
dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
boundaryField { inlet { type zeroGradient; } outlet { type fixedValue; value uniform 0; } walls { type zeroGradient; } }
X
}

median() { sort -g | awk '{ v[NR] = $1 } END { print (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2 }'; }
ours() { taskset -c "$core" "$programs/fluid_steps" 21 28 60 "$steps" "$1" | sed 's/.*wall time, \([^ ]*\) by.*/\1/'; }
theirs() {
  (cd "$work" && taskset -c "$core" pisoFoam >log 2>&1)
  awk '/^ExecutionTime/ { t[++n] = $3 } END { for (k = int(n / 2) + 1; k <= n; ++k) print t[k] - t[k - 1] }' \
    "$work/log" | awk '{ s += $1 } END { print s / NR }'
}

write_case
(cd "$work" && blockMesh >mesh.log 2>&1)
a=() b=() c=()
for ((round = 1; round <= rounds; ++round)); do
  a+=("$(ours 1e-6)") b+=("$(ours "$tight")") c+=("$(theirs)")
  echo "round $round: packbed ${a[-1]} s (tolerance 1e-6), ${b[-1]} s ($tight), pisoFoam ${c[-1]} s per step"
done
echo "medians: packbed $(printf '%s\n' "${a[@]}" | median) s, $(printf '%s\n' "${b[@]}" | median) s," \
  "pisoFoam $(printf '%s\n' "${c[@]}" | median) s"
