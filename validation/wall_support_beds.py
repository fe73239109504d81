#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What walls carry (thesis section 7.4): beds of 30 mm in slices of three widths, five times to 637 cm/h and back.

A slice of width W has as much wall for its volume as a round column of 2 W. Beads by Hertz's law with the relaxed
moduli of the resin library, for lab plateaus last minutes; friction as in the thesis's simulations.
"""
import math
import sys

sys.dont_write_bytecode = True
import runs  # noqa: E402

WORK = runs.BUILD / "wall_support_beds"
CASE = """
[column]
shape = "slice"
inner_diameter = "{width} mm"
slice_depth = "0.9 mm"
height = "38 mm"
[resin]
name = "{resin}"
contact = "hertz"
friction = 0.1
wall_friction = 0.1
rolling_friction = 0.35
restitution = 0.5
coarse_grain = {grain}
[liquid]
temperature = "20 degC"
[output]
checkpoint_interval = "3 min"
analysis = false
[[protocol]]
step = "settle"
bed_height = "30 mm"
[[protocol]]
step = "repeat"
count = 5
[[protocol.steps]]
step = "flow_ramp"
to = "637 cm/h"
steps = 10
hold_limit = "3 s"
[[protocol.steps]]
step = "flow_ramp"
from = "637 cm/h"
to = "0 cm/h"
steps = 10
hold_limit = "3 s"
"""
# Coarse grains of both resins have 0.26 mm.
RESINS = {"sep": ("CM Sepharose 6FF", 3), "toy": ("Toyopearl SP-650M", 4)}
WIDTHS = (5, 7.5, 10)
PIECES = {f"{resin}-{width}": (resin, width) for resin in RESINS for width in WIDTHS}
# Fits to the lab, D in mm: a ln D + b, of bar/m and of the compression (thesis eqs 7.2 to 7.5).
FITS = {"sep": ((1.9751, 0.3544), (0.01100, 0.01398)), "toy": ((3.5121, 2.6535), (0.01344, 0.03688))}


def run_piece(piece):
    resin, width = PIECES[piece]
    name, grain = RESINS[resin]
    folder = WORK / piece
    runs.run(CASE.format(width=width, resin=name, grain=grain), folder)
    runs.print_plateaus(folder)


def cycles(table):
    """The plateaus of each cycle: ten up, ten down."""
    return [table[k:k + 20] for k in range(0, len(table) - 19, 20)]


def loop(cycle):
    """Mean difference of the compression, down less up at the same flow, over that at the highest flow."""
    value = [float(r["compression"]) for r in cycle]
    return sum(value[18 - k] - value[k] for k in range(9)) / 9 / value[9]


def judge(tables):
    good = True
    for resin, (gradient, compression) in FITS.items():
        last = {}
        for width in WIDTHS:
            table = tables.get(f"{resin}-{width}")
            if not table:
                continue
            first, *_, fifth = cycles(table)
            top = fifth[9]
            last[width] = (float(top["pressure_drop_bar_m"]), float(top["compression"]), loop(fifth))
            log_d = math.log(2 * width)
            print(f"{resin}, {width} mm (round {2 * width:g} mm), settled {float(top['settled_porosity']):.4f}: "
                  f"{last[width][0]:.3f} bar/m (lab {gradient[0] * log_d + gradient[1]:.2f}), compression "
                  f"{last[width][1]:.4f} (lab {compression[0] * log_d + compression[1]:.4f}), first cycle "
                  f"{float(first[9]['compression']):.4f}; loop {last[width][2]:.3f} of it, first {loop(first):.3f}")
        if len(last) < len(WIDTHS):
            continue
        narrow, wide = last[WIDTHS[0]], last[WIDTHS[-1]]
        for k, what in enumerate(("bar/m", "compression")):
            good &= runs.line(f"{resin}, {what}, widest over narrowest", wide[k] / narrow[k], 1.02, 2.0, "lab: grows with ln D")
        good &= runs.line(f"{resin}, loop, widest over narrowest", wide[2] / narrow[2], 0.0, 0.98, "lab: narrower in a wide column")
    return good


if __name__ == "__main__":
    sys.exit(runs.main(PIECES, run_piece, judge))
