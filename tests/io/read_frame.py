#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Print a frame, as the VTK library reads it, in JSON.

Usage: read_frame.py FRAME.hdf
"""
import json
import sys

from vtkmodules.vtkCommonCore import vtkIdList, vtkObject
from vtkmodules.vtkIOHDF import vtkHDFReader


def values(array):
    """Rows of an array; numbers if a row has one, and its type in front."""
    width = array.GetNumberOfComponents()
    rows = [array.GetTuple(k) for k in range(array.GetNumberOfTuples())]
    if array.GetDataTypeAsString() not in ("float", "double"):
        rows = [[int(v) for v in row] for row in rows]
    return {
        "type": array.GetDataTypeAsString(),
        "values": [row[0] for row in rows] if width == 1 else rows,
    }


def arrays(data):
    return {data.GetArrayName(k): values(data.GetArray(k)) for k in range(data.GetNumberOfArrays())}


def cells(grid):
    points = vtkIdList()
    for k in range(grid.GetNumberOfCells()):
        grid.GetCellPoints(k, points)
        yield {
            "type": grid.GetCellType(k),
            "points": [points.GetId(p) for p in range(points.GetNumberOfIds())],
        }


errors = []
reader = vtkHDFReader()
reader.AddObserver("ErrorEvent", lambda *_: errors.append("the reader reports an error"))
vtkObject.GlobalWarningDisplayOn()
if not reader.CanReadFile(sys.argv[1]):
    sys.exit(f"{sys.argv[1]}: VTK does not take it for one of its files")
reader.SetFileName(sys.argv[1])
reader.Update()
if errors:
    sys.exit(f"{sys.argv[1]}: {errors[0]}")
grid = reader.GetOutput()
json.dump(
    {
        "points": [grid.GetPoint(k) for k in range(grid.GetNumberOfPoints())],
        "cells": list(cells(grid)),
        "point_data": arrays(grid.GetPointData()),
        "cell_data": arrays(grid.GetCellData()),
        "field_data": arrays(grid.GetFieldData()),
    },
    sys.stdout,
)
