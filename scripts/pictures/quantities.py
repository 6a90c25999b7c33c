"""Numbers of particles and fields, taken out of VTK's grids."""

import math

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from pictures.screen import fail


def array_of(grid, quantity):
    """The array called 'quantity [unit]', or an end that names what there is."""
    data = grid.GetPointData()
    names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
    for name in names:
        if name.split(" [")[0] == quantity:
            return data.GetArray(name)
    fail("there is no quantity '%s', but %s."
         % (quantity, ", ".join(sorted(name.split(" [")[0] for name in names))))


def points_of(grid):
    """Positions [m], one row a point."""
    if grid.GetNumberOfPoints() == 0:
        return numpy.zeros((0, 3))
    return vtk_to_numpy(grid.GetPoints().GetData())


def numbers_of(grid, quantity):
    """One number a point: the quantity, or its length."""
    values = vtk_to_numpy(array_of(grid, quantity))
    return numpy.linalg.norm(values, axis=1) if values.ndim > 1 else values


def as_array(values, name):
    """VTK's array of these numbers."""
    array = numpy_to_vtk(numpy.ascontiguousarray(values, dtype=float), deep=True)
    array.SetName(name)
    return array


def points_with(positions, values, name):
    """VTK's points at these positions with one number each."""
    points, vertices = vtk.vtkPoints(), vtk.vtkVertexGlyphFilter()
    points.SetData(as_array(positions, "positions"))
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.GetPointData().SetScalars(as_array(values, name))
    vertices.SetInputData(data)
    vertices.Update()
    return vertices.GetOutput()


def spacing_of(grid):
    """Median distance of a particle from its nearest neighbour [m]."""
    if grid.GetNumberOfPoints() < 2:
        return 0.01
    locator, nearest = vtk.vtkStaticPointLocator(), vtk.vtkIdList()
    locator.SetDataSet(grid)
    locator.BuildLocator()
    distances = []
    for point in range(0, grid.GetNumberOfPoints(), max(1, grid.GetNumberOfPoints() // 200)):
        locator.FindClosestNPoints(2, grid.GetPoint(point), nearest)
        distances.append(math.dist(grid.GetPoint(point), grid.GetPoint(nearest.GetId(1))))
    return sorted(distances)[len(distances) // 2]


def range_over(runs, shown, quantity):
    """Least and largest number of a quantity over the frames shown; speeds begin at 0."""
    low, high = math.inf, -math.inf
    for run, frames in zip(runs, shown):
        for frame in frames:
            grid = run.particles(frame)
            if grid.GetNumberOfPoints():
                values = numbers_of(grid, quantity)
                low, high = min(low, values.min()), max(high, values.max())
    if quantity == "velocity":
        low = 0.0
    return (low, high) if high > low else (low - 0.5, low + 0.5)
