#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Slices against round columns under a flow (thesis section 8.2.2, fig. 8.4, which has them nearly identical).

A slice of width W has the wall of a round column of 2 W for its volume, and the same distance between walls as one
of W: both are compared with it.
"""
import sys

sys.dont_write_bytecode = True
import runs  # noqa: E402

WORK = runs.BUILD / "slice_and_cylinder"
CASE = """
[column]
{shape}
height = "{column} mm"
[resin]
name = "CM Sepharose 6FF"
coarse_grain = 3
[liquid]
temperature = "20 degC"
[output]
checkpoint_interval = "3 min"
analysis = false
[[protocol]]
step = "settle"
bed_height = "{height} mm"
[[protocol]]
step = "flow_ramp"
to = "2763 cm/h"
steps = 10
hold = "0.8 s"
"""
SLICE = 'shape = "slice"\ninner_diameter = "{} mm"\nslice_depth = "0.9 mm"'
ROUND = 'shape = "cylinder"\ninner_diameter = "{} mm"'
# Name: shape, width or diameter [mm], height of the bed [mm].
PIECES = {
    "slice-5": (SLICE, 5, 10),
    "round-5": (ROUND, 5, 10),
    "round-10": (ROUND, 10, 10),
    "slice-10": (SLICE, 10, 10),
}


def run_piece(piece):
    shape, width, height = PIECES[piece]
    folder = WORK / piece
    runs.run(CASE.format(shape=shape.format(width), column=1.3 * height, height=height), folder)
    runs.print_plateaus(folder)


def judge(tables):
    good = True
    top = {piece: runs.at_highest_flow(table) for piece, table in tables.items()}
    for piece, row in top.items():
        print(f"{piece}: settled porosity {float(row['settled_porosity']):.4f}, {float(row['settled_height_mm']):.2f} mm; at "
              f"{float(row['velocity_cm_h']):.0f} cm/h {float(row['pressure_drop_bar_m']):.3g} bar/m, compression "
              f"{float(row['compression']):.4f}, sections " + " ".join(f"{float(row[f'section_{k}']):.3f}" for k in range(1, 8)))
    for one, other in (("slice-5", "round-5"), ("slice-5", "round-10"), ("slice-10", "round-10")):
        if one not in top or other not in top:
            continue
        for key in ("pressure_drop_bar_m", "compression"):
            good &= runs.line(f"{key} of {one} over {other}", float(top[one][key]) / float(top[other][key]), 0.9, 1.1,
                              "thesis fig. 8.4: nearly identical")
    return good


if __name__ == "__main__":
    sys.exit(runs.main(PIECES, run_piece, judge))
