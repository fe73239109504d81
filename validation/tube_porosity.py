#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""P6: porosity of beds of nearly equal spheres in round columns of 8 to 24 diameters, as they settle in water.

With the friction of the resin, and with the same friction but no resistance to rolling, like smooth hard spheres. Zou
and Yu, Chem. Eng. Sci. 50 (1995) 1504, loose packing (constants as quoted by others, the paper itself was not read);
Benyahia and O'Neill, Part. Sci. Technol. 23 (2005) 169, all packings, beside it. The porosity far from walls is a
matter of friction; what the wall adds to that of the widest column is judged apart from it.
"""
import math
import sys

sys.dont_write_bytecode = True
import runs  # noqa: E402

WORK = runs.BUILD / "tube_porosity"
DIAMETER = 0.3  # [mm]
BEDS = {8: 3, 12: 2, 16: 1, 24: 1}  # random beds of each width in diameters
WIDEST = max(BEDS)
PIECES = {f"{kind}-{ratio}": (kind, ratio) for kind in ("width", "smooth") for ratio in BEDS}
CASE = """
[column]
shape = "cylinder"
inner_diameter = "{width} mm"
height = "13 mm"
[resin]
name = "CM Sepharose 6FF"
{more}
[resin.sizes]
distribution = "normal"
mean = "300 um"
standard_deviation = "6 um"
minimum = "280 um"
maximum = "320 um"
[liquid]
temperature = "20 degC"
[numerics]
seed = {seed}
[output]
checkpoint_interval = "3 min"
analysis = false
[[protocol]]
step = "settle"
bed_height = "9 mm"
"""
MEETS = 0.01
WALL_MEETS = 0.005  # beds of one width differ by 0.004


def zou_yu_loose(ratio):
    return 0.400 + 0.010 * (math.exp(10.686 / ratio) - 1.0)


def benyahia_oneill(ratio):
    return 0.390 + 1.740 / (ratio + 1.140) ** 2


def run_piece(piece):
    kind, ratio = PIECES[piece]
    more = "rolling_friction = 0.0" if kind == "smooth" else ""
    print("seed,porosity,height_mm")
    for seed in range(1, BEDS[ratio] + 1):
        folder = WORK / f"{piece}-{seed}"
        runs.run(CASE.format(width=round(ratio * DIAMETER, 6), seed=seed, more=more), folder)
        about = runs.summary(folder)
        print(f"{seed},{about['settled_porosity']},{about['settled_height_m'] * 1e3}")


def judge(tables):
    good = True
    mean = {}
    for piece, (kind, ratio) in PIECES.items():
        if piece not in tables:
            continue
        beds = [float(row["porosity"]) for row in tables[piece]]
        mean[kind, ratio] = sum(beds) / len(beds)
        loose = zou_yu_loose(ratio)
        text = (f"{'smooth spheres' if kind == 'smooth' else 'beads of the resin'}, column of {ratio} diameters, "
                f"{len(beds)} beds, {min(beds):.4f} to {max(beds):.4f}, mean")
        reference = f"Zou and Yu, loose, {loose:.4f}; Benyahia and O'Neill {benyahia_oneill(ratio):.4f}"
        good &= runs.line(text, mean[kind, ratio], loose - MEETS, loose + MEETS, reference)
    for kind, ratio in mean:
        if ratio != WIDEST and (kind, WIDEST) in mean:
            wall = zou_yu_loose(ratio) - zou_yu_loose(WIDEST)
            good &= runs.line(f"{kind}, column of {ratio} less {WIDEST} diameters", mean[kind, ratio] - mean[kind, WIDEST],
                              wall - WALL_MEETS, wall + WALL_MEETS, f"Zou and Yu {wall:.4f}")
    return good


if __name__ == "__main__":
    sys.exit(runs.main(PIECES, run_piece, judge))
