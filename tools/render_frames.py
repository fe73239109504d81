#!/usr/bin/python3
"""Draw a frame of a run: grains colored by their number of contacts, and the chains of forces.

Usage: render_frames.py FRAMES NUMBER PICTURE.png    (Debian: python3-vtk9; without a screen: xvfb-run -a)
"""
import math
import sys

import vtk


def read(name):
    reader = vtk.vtkHDFReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


def text(words, x, y):
    actor = vtk.vtkTextActor()
    actor.SetInput(words)
    actor.GetTextProperty().SetFontSize(18)
    actor.GetTextProperty().SetColor(0.1, 0.1, 0.1)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(x, y)
    return actor


def beads(grid):
    grid.GetPointData().SetActiveScalars("diameter_m")
    sphere = vtk.vtkSphereSource()
    sphere.SetRadius(0.5)
    sphere.SetThetaResolution(24)
    sphere.SetPhiResolution(24)
    glyph = vtk.vtkGlyph3D()
    glyph.SetInputData(grid)
    glyph.SetSourceConnection(sphere.GetOutputPort())
    glyph.SetScaleModeToScaleByScalar()
    glyph.SetScaleFactor(1.0)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(glyph.GetOutputPort())
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("contacts")
    mapper.SetScalarRange(2, 9)
    colors = vtk.vtkColorTransferFunction()
    for value, rgb in ((2, (0.96, 0.93, 0.84)), (5, (0.55, 0.75, 0.82)), (9, (0.16, 0.34, 0.56))):
        colors.AddRGBPoint(value, *rgb)
    mapper.SetLookupTable(colors)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def chains(grid, thickest):
    forces = grid.GetCellData().GetArray("normal_force_N")
    largest = max(forces.GetValue(k) for k in range(forces.GetNumberOfTuples()))
    points, lines, radii = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkDoubleArray()
    radii.SetName("radius")
    for k in range(grid.GetNumberOfCells()):
        ends = grid.GetCell(k).GetPoints()
        lines.InsertNextCell(2)
        for end in (0, 1):
            lines.InsertCellPoint(points.InsertNextPoint(ends.GetPoint(end)))
            radii.InsertNextValue(thickest * math.sqrt(max(0.0, forces.GetValue(k)) / largest))
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    data.GetPointData().AddArray(radii)
    data.GetPointData().SetActiveScalars("radius")
    tube = vtk.vtkTubeFilter()
    tube.SetInputData(data)
    tube.SetVaryRadiusToVaryRadiusByAbsoluteScalar()
    tube.SetNumberOfSides(10)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(tube.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.72, 0.16, 0.12)
    return actor


def main(folder, number, picture):
    bed = read(f"{folder}/beads_{int(number):06}.hdf")
    contacts = read(f"{folder}/contacts_{int(number):06}.hdf")
    x0, x1, y0, y1, z0, z1 = bed.GetBounds()
    thickest = 0.09e-3
    views = ((beads(bed), "grains, colored by their contacts (2 to 9)"), (chains(contacts, thickest), "normal forces of the contacts"))
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(1000, 750)
    for k, (actor, words) in enumerate(views):
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(0.5 * k, 0, 0.5 * (k + 1), 1)
        renderer.SetBackground(1, 1, 1)
        renderer.AddActor(actor)
        renderer.AddActor2D(text(words, 0.08, 0.02))
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(0.5 * (x0 + x1), 0.5 * (y0 + y1), 0.5 * (z0 + z1))
        camera.SetPosition(0.5 * (x0 + x1) + 0.003, -0.05, 0.5 * (z0 + z1) + 0.006)
        camera.SetViewUp(0, 0, 1)
        camera.SetParallelScale(0.56 * (z1 - z0))
        renderer.ResetCameraClippingRange()
        window.AddRenderer(renderer)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.Update()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(picture)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
