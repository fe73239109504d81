#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A slice of a lab column of CM Sepharose 6FF under a flow to 2763 cm/h, one setting changed at a time.

Each piece takes the settled bed of its porosity (settled when it is first asked for). The lab: thesis chapter 8.1.
"""
import sys

sys.dont_write_bytecode = True
import runs  # noqa: E402

WORK = runs.BUILD / "flow_compression"  # beds and runs; tables go to standard output

COLUMN = """
[column]
shape = "slice"
inner_diameter = "10 mm"
slice_depth = "0.9 mm"
height = "40 mm"
[resin]
name = "CM Sepharose 6FF"
coarse_grain = 3
{resin}
[liquid]
temperature = "20 degC"
"""
# Plateaus last until they are steady: near full flow the compressed bed consolidates in some 0.5 s.
RAMP = """
[[protocol]]
step = "flow_ramp"
to = "2763 cm/h"
steps = 20
hold_limit = "3 s"
"""
BACK = """
[[protocol]]
step = "flow_ramp"
from = "2763 cm/h"
to = "0 cm/h"
steps = 20
hold_limit = "3 s"
"""
HERTZ = 'contact = "hertz"\nyoungs_modulus = "5.53 MPa"'  # thesis fig. 8.1

# Name: porosity of the settled bed (none: as it settles), keys of [resin], further sections, further steps.
PIECES = {
    "porosity-0.38": (0.38, "", "", ""),
    "porosity-0.39": (0.39, "", "", BACK),
    "porosity-0.40": (None, "", "", ""),
    "merged": (0.39, "", '[coupling]\noverlap = "merged"', ""),
    "clamp-0.40": (0.39, "", "[drag]\nmin_void_fraction = 0.40", ""),
    # Beads at the floor are pressed beyond the limit of 0.3 at full flow.
    "width-half": (0.39, "", '[coupling]\naveraging_width = "0.395 mm"\n[numerics]\noverlap_limit = 0.6', ""),
    "width-twice": (0.39, "", '[coupling]\naveraging_width = "1.57 mm"', ""),
    "hertz": (0.39, HERTZ, "", ""),
    "hertz-0.38": (0.38, HERTZ, "", ""),
}
LAB_GRADIENT = 37.0  # at 2763 cm/h [bar/m]
LAB_COMPRESSION = 0.12  # about


def bed(porosity):
    """Folder of a settled bed."""
    folder = WORK / "beds" / ("as-it-settles" if porosity is None else f"{porosity}")
    wish = "" if porosity is None else f"porosity = {porosity}\n"
    runs.run(COLUMN.format(resin="") + f'[[protocol]]\nstep = "settle"\nbed_height = "31 mm"\n{wish}', folder)
    return folder


def run_piece(piece):
    porosity, resin, more, steps = PIECES[piece]
    start = bed(porosity)
    folder = WORK / "runs" / piece
    runs.run(COLUMN.format(resin=resin) + more + f'\n[beads]\nrun = "{start}"\n' + RAMP + steps, folder)
    runs.print_plateaus(folder)


def judge(tables):
    good = True
    for piece, table in tables.items():
        top = runs.at_highest_flow(table)
        print(f"{piece}: settled porosity {float(top['settled_porosity']):.4f}; at {float(top['velocity_cm_h']):.0f} cm/h "
              f"{float(top['pressure_drop_bar_m']):.3g} bar/m (lab {LAB_GRADIENT:g}), compression "
              f"{float(top['compression']):.4f} (lab about {LAB_COMPRESSION:g}); sections from the inlet "
              + " ".join(f"{float(top[f'section_{k}']):.3f}" for k in range(1, 8)))
        steady = [r for r in table if r["steady"] == "1"] or table
        good &= runs.line(f"{piece}, largest error of the balance of forces on steady plateaus",
                          max(abs(float(r["budget_error"])) for r in steady), 0, 5e-3, "aim: below 0.5 %")
        good &= runs.line(f"{piece}, largest noise of the pressure drop on them",
                          max(float(r["pressure_noise"]) for r in steady), 0, 1e-3, "aim: below 0.1 %")
        good &= runs.line(f"{piece}, compression of the last section over the first",
                          float(top["section_7"]) / float(top["section_1"]), 1, 1e3, "lab: rises towards the outlet")
    return good


if __name__ == "__main__":
    sys.exit(runs.main(PIECES, run_piece, judge))
