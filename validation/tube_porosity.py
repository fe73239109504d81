#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""P6: porosity of beds of nearly equal spheres in round columns of 8 to 24 diameters, as they settle in water.

Zou and Yu, Chem. Eng. Sci. 50 (1995) 1504, loose packing (constants as quoted by others, the paper itself was not
read); Benyahia and O'Neill, Part. Sci. Technol. 23 (2005) 169, all packings, beside it.
"""
import math
import sys

sys.dont_write_bytecode = True
import runs  # noqa: E402

WORK = runs.BUILD / "tube_porosity"
DIAMETER = 0.3  # [mm]
BEDS = {8: 3, 12: 2, 16: 1, 24: 1}  # random beds of each width in diameters
PIECES = {f"width-{ratio}": ratio for ratio in BEDS}
CASE = """
[column]
shape = "cylinder"
inner_diameter = "{width} mm"
height = "13 mm"
[resin]
name = "CM Sepharose 6FF"
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


def zou_yu_loose(ratio):
    return 0.400 + 0.010 * (math.exp(10.686 / ratio) - 1.0)


def benyahia_oneill(ratio):
    return 0.390 + 1.740 / (ratio + 1.140) ** 2


def run_piece(piece):
    ratio = PIECES[piece]
    print("seed,porosity,height_mm")
    for seed in range(1, BEDS[ratio] + 1):
        folder = WORK / f"{piece}-{seed}"
        runs.run(CASE.format(width=round(ratio * DIAMETER, 6), seed=seed), folder)
        about = runs.summary(folder)
        print(f"{seed},{about['settled_porosity']},{about['settled_height_m'] * 1e3}")


def judge(tables):
    good = True
    for piece, ratio in PIECES.items():
        if piece not in tables:
            continue
        beds = [float(row["porosity"]) for row in tables[piece]]
        loose = zou_yu_loose(ratio)
        good &= runs.line(f"column of {ratio} diameters, {len(beds)} beds, {min(beds):.4f} to {max(beds):.4f}, mean",
                          sum(beds) / len(beds), loose - MEETS, loose + MEETS,
                          f"Zou and Yu, loose, {loose:.4f}; Benyahia and O'Neill {benyahia_oneill(ratio):.4f}")
    return good


if __name__ == "__main__":
    sys.exit(runs.main(PIECES, run_piece, judge))
