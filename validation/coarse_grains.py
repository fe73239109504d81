#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""K7: coarse grains of 1, 2 and 3 diameters in the box of the thesis (5.5.4), in a flow and below a plunger (its figs
8.2, 8.3): one curve for all, overlaps 1:2:3.

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
interval = "25 ms"
checkpoint_interval = "3 min"
analysis = false
"""
BED = """
[[protocol]]
step = "settle"
bed_height = "10 mm"
porosity = 0.39
"""
FLOW = """
[[protocol]]
step = "flow_ramp"
to = "2763 cm/h"
steps = 10
hold = "0.4 s"
"""
PRESS = """
[[protocol]]
step = "compress"
speed = "30 mm/min"
compression = "12.5 %"
"""
GRAINS = (3, 2, 1)
PIECES = {f"{what}-{grain}": (what, grain) for grain in GRAINS for what in ("flow", "press")}
COMPRESSIONS = (0.025, 0.05, 0.075, 0.10, 0.125)
MEETS = 0.03


def run_piece(piece):
    what, grain = PIECES[piece]
    column = CASE.format(grain=grain)
    bed = WORK / f"bed-{grain}"
    runs.run(column + BED, bed)
    folder = WORK / piece
    runs.run(column + f'[beads]\nrun = "{bed}"\n' + (FLOW if what == "flow" else PRESS), folder)
    series = runs.rows(folder / "series.csv")
    if what == "flow":
        runs.print_plateaus(folder, {"mean_overlap_um": lambda plateau: 1e6 * float(
            min(series, key=lambda row: abs(float(row["time_s"]) - float(plateau["end_time_s"])))["mean_overlap_m"])})
        return
    print("compression,plunger_force_N,mean_overlap_um,settled_porosity")
    points = [(float(r["plunger_compression"]), float(r["plunger_force_N"]), 1e6 * float(r["mean_overlap_m"])) for r in series]
    for wanted in COMPRESSIONS:
        before = max((p for p in points if p[0] <= wanted), key=lambda p: p[0])
        after = min((p for p in points if p[0] >= wanted - 1e-9), key=lambda p: p[0])
        part = 0 if after[0] <= before[0] else (wanted - before[0]) / (after[0] - before[0])
        force, overlap = (before[k] + part * (after[k] - before[k]) for k in (1, 2))
        print(f"{wanted},{force},{overlap},{runs.summary(bed)['settled_porosity']}")


def judge(tables):
    good = True
    for what, keys in (("flow", ("pressure_drop_bar", "bed_height_mm")), ("press", ("plunger_force_N",))):
        finest = min((grain for grain in GRAINS if f"{what}-{grain}" in tables), default=0)
        for grain in GRAINS:
            table = tables.get(f"{what}-{grain}")
            if not table:
                continue
            last, reference = table[-1], tables[f"{what}-{finest}"]
            print(f"{what}, coarse grain {grain}, settled {float(last['settled_porosity']):.4f}: " + ", ".join(
                f"{key} {float(last[key]):.4g}" for key in (*keys, "compression", "mean_overlap_um")))
            if grain == finest:
                continue
            for key in keys:
                worst = max((float(a[key]) / float(b[key]) for a, b in zip(table, reference)), key=lambda r: abs(r - 1))
                good &= runs.line(f"{what}, {key} of coarse grain {grain} over that of {finest}, worst point", worst,
                                  1 - MEETS, 1 + MEETS, "aim: one curve within 3 %")
            good &= runs.line(f"{what}, mean overlap over that of {finest}, over {grain / finest:g}, at the end",
                              float(last["mean_overlap_um"]) / float(reference[-1]["mean_overlap_um"]) / grain * finest,
                              1 - MEETS, 1 + MEETS, "thesis figs 8.2 D, 8.3 B")
    return good


if __name__ == "__main__":
    sys.exit(runs.main(PIECES, run_piece, judge))
