"""Lines of a magnetic field on the adaptive mesh of a run, at even distances from one another."""

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from pictures.quantities import array_of, as_array, points_with

MOST_POINTS = 4000 # of a line


def lines_through(fields, quantity, seeds, length, step):
    """
    Positions [m] and field of the lines through some points, both ways, of a length at most.

    Cells of different size share only some of their points, so the tracer finds the next cell with
    a locator; walking from a cell to its neighbour would end the lines where the size changes.
    """
    tracer = vtk.vtkStreamTracer()
    tracer.SetInputData(fields)
    tracer.SetSourceData(points_with(seeds, numpy.zeros(len(seeds)), "seed"))
    tracer.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS,
                                  array_of(fields, quantity).GetName())
    tracer.SetInterpolatorType(vtk.vtkStreamTracer.INTERPOLATOR_WITH_CELL_LOCATOR)
    tracer.SetIntegratorTypeToRungeKutta4()
    tracer.SetIntegrationDirectionToBoth()
    tracer.SetIntegrationStepUnit(vtk.vtkStreamTracer.LENGTH_UNIT)
    tracer.SetInitialIntegrationStep(step)
    tracer.SetMaximumPropagation(length)
    tracer.SetMaximumNumberOfSteps(MOST_POINTS)
    tracer.SetTerminalSpeed(1e-300)
    tracer.SetComputeVorticity(False)
    tracer.Update()
    return halves_joined(tracer.GetOutput(), quantity)


def halves_joined(traced, quantity):
    """Positions, field and the number of the seed's point of each line, along the field."""
    if not traced.GetNumberOfPoints():
        return []
    points = vtk_to_numpy(traced.GetPoints().GetData())
    field = vtk_to_numpy(array_of(traced, quantity))
    seeds = vtk_to_numpy(traced.GetCellData().GetArray("SeedIds"))
    pieces, ids = {}, vtk.vtkIdList()
    for cell in range(traced.GetNumberOfCells()):
        traced.GetCellPoints(cell, ids)
        numbers = [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
        if len(numbers) > 1:
            way = points[numbers[1]] - points[numbers[0]]
            pieces.setdefault(seeds[cell], {})[way @ field[numbers[0]] > 0] = numbers
    lines = []
    for halves in pieces.values():
        before = halves.get(False, [])[:0:-1]
        after = halves.get(True) or halves[False][:1]
        lines.append((points[before + after], field[before + after], len(before)))
    return lines


def evenly_spaced(lines, low, high, distance):
    """
    Of each line the part around its seed that stays a distance away from all parts kept before,
    long lines first; short parts are left out. What is taken is marked on a grid of a quarter of the
    distance.
    """
    step = 0.25 * distance
    counts = numpy.ceil((numpy.array(high) - low) / step).astype(int) + 1
    taken = numpy.zeros(counts, dtype=bool)
    around = numpy.stack(numpy.meshgrid(*[numpy.arange(-3, 4)] * 3), axis=-1).reshape(-1, 3)
    around = around[(around**2).sum(axis=1) <= 10]
    kept = []
    for points, field, seed in sorted(lines, key=lambda line: -length_within(line[0], low, high)):
        node = numpy.rint((points - low) / step).astype(int)
        inside = ((node >= 0) & (node < counts)).all(axis=1)
        node = numpy.clip(node, 0, counts - 1)
        free = inside & ~taken[tuple(node.T)]
        if not free[seed]:
            continue
        blocked = numpy.flatnonzero(~free)
        first = blocked[blocked < seed].max(initial=-1) + 1
        last = blocked[blocked > seed].min(initial=len(points))
        part = slice(first, last)
        if length_within(points[part], low, high) < 4 * distance:
            continue
        marked = (node[part][:, None, :] + around[None]).reshape(-1, 3)
        marked = marked[((marked >= 0) & (marked < counts)).all(axis=1)]
        taken[tuple(marked.T)] = True
        kept.append((points[part], field[part]))
    return kept


def length_within(points, low, high):
    """Length of a line inside of a box [m]."""
    inside = ((points >= low) & (points <= high)).all(axis=1)
    return (numpy.linalg.norm(numpy.diff(points, axis=0), axis=1) * inside[1:]).sum()


def seeds_in_plane(low, high, axis, distance):
    """Points in the plane through the middle of a box, across an axis, in an order without pattern."""
    sides = [numpy.arange(a + 0.5 * distance, b, distance) for a, b in zip(low, high)]
    if axis is not None:
        sides[axis] = numpy.array([0.5 * (low[axis] + high[axis])])
    seeds = numpy.stack(numpy.meshgrid(*sides), axis=-1).reshape(-1, 3)
    return numpy.random.default_rng(1).permutation(seeds)


def as_polylines(lines):
    """VTK's lines, with the magnitude of the field as their numbers 'colour'."""
    cells, points = vtk.vtkCellArray(), vtk.vtkPoints()
    start = 0
    for positions, _ in lines:
        cells.InsertNextCell(len(positions))
        for i in range(len(positions)):
            cells.InsertCellPoint(start + i)
        start += len(positions)
    points.SetData(as_array(numpy.concatenate([line[0] for line in lines]), "positions"))
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetLines(cells)
    magnitudes = numpy.linalg.norm(numpy.concatenate([line[1] for line in lines]), axis=1)
    data.GetPointData().SetScalars(as_array(magnitudes, "colour"))
    return data


def arrows_of(lines):
    """VTK's points in the middle of each line with the unit vector of the field and its magnitude."""
    middles = [len(points) // 2 for points, _ in lines]
    positions = numpy.array([points[i] for (points, _), i in zip(lines, middles)])
    field = numpy.array([values[i] for (_, values), i in zip(lines, middles)])
    magnitudes = numpy.linalg.norm(field, axis=1)
    data = points_with(positions, magnitudes, "colour")
    data.GetPointData().SetVectors(as_array(field / magnitudes[:, None], "direction"))
    return data
