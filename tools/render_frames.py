#!/usr/bin/python3
"""Draw a frame of a run: grains colored by their number of contacts, the chains of forces, and the flow if there is one.

Usage: render_frames.py FRAMES NUMBER PICTURE.png    (Debian: python3-vtk9; without a screen: xvfb-run -a)
       render_frames.py --forces PICTURE.png FRAMES:NUMBER:WORDS...    (forces alone, frames side by side)
"""
import math
import os
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
    actor.GetTextProperty().SetFontSize(15)
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


def flow(grid, top):
    """Cells up to a height, colored by the velocity between the beads, and the legend."""
    velocity = grid.GetCellData().GetArray("velocity_m_s")
    speed = vtk.vtkDoubleArray()
    speed.SetName("mm/s")
    for k in range(grid.GetNumberOfCells()):
        speed.InsertNextValue(1e3 * math.hypot(*velocity.GetTuple3(k)))
    grid.GetCellData().AddArray(speed)
    cut = vtk.vtkExtractGeometry()
    box = vtk.vtkBox()
    low, high = grid.GetBounds()[::2], grid.GetBounds()[1::2]
    box.SetBounds(low[0] - top, high[0] + top, low[1] - top, high[1] + top, low[2] - top, top)
    cut.SetInputData(grid)
    cut.SetImplicitFunction(box)
    colors = vtk.vtkColorTransferFunction()
    largest = speed.GetRange()[1]
    for share, rgb in ((0, (0.97, 0.98, 1.0)), (0.5, (0.42, 0.68, 0.84)), (1, (0.03, 0.19, 0.42))):
        colors.AddRGBPoint(share * largest, *rgb)
    mapper = vtk.vtkDataSetMapper()
    mapper.SetInputConnection(cut.GetOutputPort())
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("mm/s")
    mapper.SetLookupTable(colors)
    mapper.SetScalarRange(0, largest)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(colors)
    bar.SetTitle("mm/s")
    bar.SetNumberOfLabels(4)
    bar.SetLabelFormat("%.3g")
    bar.SetPosition(0.86, 0.3)
    bar.SetWidth(0.1)
    bar.SetHeight(0.4)
    bar.UnconstrainedFontSizeOn()
    for letters in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        letters.SetColor(0.1, 0.1, 0.1)
        letters.SetFontSize(14)
        letters.ShadowOff()
        letters.ItalicOff()
        letters.BoldOff()
    return actor, bar


THICKEST = 0.09e-3  # of a chain [m]


def draw(views, bounds, picture):
    """Panels of actors with their words, side by side, all seen alike."""
    x0, x1, y0, y1, z0, z1 = bounds
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(400 * len(views), 620)
    for k, (actors, words) in enumerate(views):
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(k / len(views), 0, (k + 1) / len(views), 1)
        renderer.SetBackground(1, 1, 1)
        for actor in actors:
            renderer.AddViewProp(actor)
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


def one_frame(folder, number, picture):
    bed = read(f"{folder}/beads_{int(number):06}.hdf")
    contacts = read(f"{folder}/contacts_{int(number):06}.hdf")
    views = [((beads(bed),), "grains, colored by their contacts (2 to 9)"),
             ((chains(contacts, THICKEST),), "normal forces of the contacts")]
    liquid = f"{folder}/liquid_{int(number):06}.hdf"
    if os.path.exists(liquid):
        views.append((flow(read(liquid), bed.GetBounds()[5]), "velocity of the liquid between the grains"))
    draw(views, bed.GetBounds(), picture)


def forces_of(picture, *frames):
    views, bounds = [], None
    for frame in frames:
        folder, number, words = frame.split(":")
        contacts = read(f"{folder}/contacts_{int(number):06}.hdf")
        here = read(f"{folder}/beads_{int(number):06}.hdf").GetBounds()
        bounds = bounds if bounds and bounds[5] > here[5] else here
        views.append(((chains(contacts, THICKEST),), words))
    draw(views, bounds, picture)


if __name__ == "__main__":
    if len(sys.argv) > 3 and sys.argv[1] == "--forces":
        forces_of(*sys.argv[2:])
    elif len(sys.argv) == 4:
        one_frame(*sys.argv[1:])
    else:
        sys.exit(__doc__)
