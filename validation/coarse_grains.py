#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""K7: coarse grains of 1, 2 and 3 diameters in the box of the thesis (5.5.4): one curve for all, overlaps 1:2:3.

Same cells and averaging width in mm, same settled porosity. The counts of thesis table 8.2 do not fit its box; a bed
of 10 mm has about 64 000 beads.
"""
import sys

sys.dont_write_bytecode = True
import runs  # noqa: E402

WORK = runs.BUILD / "coarse_grains"
CASE = """
[column]
shape = "box"
size = ["2 mm", "2 mm", "12.5 mm"]
[column.boundaries]
x = "periodic"
y = "periodic"
z = "wall"
[resin]
name = "CM Sepharose 6FF"
coarse_grain = {grain}
[liquid]
temperature = "20 degC"
[coupling]
averaging_width = "0.79 mm"
[output]
checkpoint_interval = "3 min"
[[protocol]]
step = "settle"
bed_height = "10 mm"
porosity = 0.39
[[protocol]]
step = "flow_ramp"
to = "2763 cm/h"
steps = 10
hold = "0.4 s"
"""
PIECES = {"grain-3": 3, "grain-2": 2, "grain-1": 1}


def run_piece(piece):
    folder = WORK / piece
    runs.run(CASE.format(grain=PIECES[piece]), folder)
    runs.print_plateaus(folder)
    last = runs.rows(folder / "series.csv")[-1]
    print(f"# mean overlap {last['mean_overlap_m']} m, {last['particles']} grains", file=sys.stderr)


def overlap(piece):
    return float(runs.rows(WORK / piece / "series.csv")[-1]["mean_overlap_m"])


def judge(tables):
    good = True
    reference = "grain-1" if "grain-1" in tables else "grain-2"
    if reference not in tables:
        return False
    for piece, table in tables.items():
        if piece == reference:
            continue
        for key in ("pressure_drop_bar", "bed_height_mm"):
            worst = max((float(a[key]) / float(b[key]) for a, b in zip(table, tables[reference])),
                        key=lambda ratio: abs(ratio - 1))
            good &= runs.line(f"{piece}, {key} over that of {reference}, worst plateau", worst, 0.97, 1.03, "aim: 3 %")
        grains = PIECES[piece] / PIECES[reference]
        good &= runs.line(f"{piece}, mean overlap over that of {reference}, over {grains:g}",
                          overlap(piece) / overlap(reference) / grains, 0.97, 1.03, "thesis fig. 8.2 D")
    return good


if __name__ == "__main__":
    sys.exit(runs.main(PIECES, run_piece, judge))
