"""Surfaces of bodies, for runs that did not write them: contours of the volume of the particles."""

import numpy
import vtk

from pictures.quantities import as_array, numbers_of, points_of, points_with

MOST_NODES = 8_000_000


def surface_of(grid, chosen, spacing):
    """
    The surface of some particles of a frame (in 2D the area), smooth.

    Their volumes are spread over the nodes of a grid of the particle spacing, that is v, which is 1
    inside. Where v is half of the largest value around, the surface lies: so drops of few
    particles stay to be seen.

    chosen: which particles, one truth value each.  spacing: of the particles at the start [m].
    """
    points = points_of(grid)[chosen]
    flat = numpy.ptp(points_of(grid)[:, 2]) == 0.0
    dim = 2 if flat else 3
    ratios = volume_ratios(grid)[chosen]
    low, high = points[:, :dim].min(axis=0), points[:, :dim].max(axis=0)
    step = max(spacing, (numpy.prod(high - low + 8 * spacing) / MOST_NODES) ** (1 / dim))
    low = low - 4 * step
    counts = numpy.ceil((high - low) / step).astype(int) + 5

    volume = spread(points[:, :dim], ratios * (spacing / step) ** dim, low, step, counts)
    for axis in range(dim):
        for _ in range(2):
            volume = 0.5 * volume + 0.25 * (shifted(volume, 1, axis) + shifted(volume, -1, axis))
    around = volume
    for axis in range(dim):
        for _ in range(2):
            around = numpy.maximum(around, numpy.maximum(shifted(around, 1, axis),
                                                         shifted(around, -1, axis)))
    fraction = volume / numpy.clip(around, 0.04, 1.0)
    image = image_of(fraction, low, step, 0.0 if not flat else points[0, 2])
    return clipped(image) if flat else contoured(image)


def volume_ratios(grid):
    """J of every particle, 1 where the run did not write it."""
    data = grid.GetPointData()
    names = [data.GetArrayName(i).split(" [")[0] for i in range(data.GetNumberOfArrays())]
    return numbers_of(grid, "J") if "J" in names else numpy.ones(grid.GetNumberOfPoints())


def spread(points, weights, low, step, counts):
    """Sums of weights on the nodes of a grid, linear between the nodes around each point."""
    place = (points - low) / step
    cell = numpy.floor(place).astype(int)
    part = place - cell
    total = numpy.zeros(numpy.prod(counts))
    for corner in numpy.ndindex(*([2] * points.shape[1])):
        weight = weights * numpy.prod(numpy.where(corner, part, 1 - part), axis=1)
        node = numpy.ravel_multi_index(tuple((cell + corner).T), counts)
        total += numpy.bincount(node, weight, minlength=total.size)
    return total.reshape(counts).astype(numpy.float32)


def shifted(values, by, axis):
    """Values of the neighbours along an axis; the edge of the grid is empty."""
    return numpy.roll(values, by, axis)


def image_of(values, low, step, height):
    image = vtk.vtkImageData()
    size = list(values.shape) + [1] * (3 - values.ndim)
    image.SetDimensions(size)
    image.SetOrigin(*(list(low) + [height])[:3])
    image.SetSpacing(step, step, step)
    image.GetPointData().SetScalars(as_array(values.reshape(size).ravel(order="F"), "fraction"))
    return image


def contoured(image):
    contour, smooth = vtk.vtkFlyingEdges3D(), vtk.vtkWindowedSincPolyDataFilter()
    contour.SetInputData(image)
    contour.SetValue(0, 0.5)
    contour.ComputeNormalsOff()
    contour.ComputeScalarsOff()
    smooth.SetInputConnection(contour.GetOutputPort())
    smooth.SetNumberOfIterations(20)
    smooth.SetPassBand(0.05)
    smooth.NonManifoldSmoothingOn()
    smooth.NormalizeCoordinatesOn()
    smooth.Update()
    return with_normals(smooth.GetOutput())


def clipped(image):
    area, clip = vtk.vtkImageDataGeometryFilter(), vtk.vtkClipPolyData()
    area.SetInputData(image)
    clip.SetInputConnection(area.GetOutputPort())
    clip.SetValue(0.5)
    clip.Update()
    clip.GetOutput().GetPointData().Initialize()
    return clip.GetOutput()


def with_normals(surface):
    """The same surface with a normal at each point, for smooth shading."""
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SplittingOff()
    normals.ConsistencyOff()
    normals.Update()
    return normals.GetOutput()


def cut_open(surface, point, normal):
    """The part of a closed surface on the side of a plane to which the normal points, closed."""
    plane, planes, clip = vtk.vtkPlane(), vtk.vtkPlaneCollection(), vtk.vtkClipClosedSurface()
    plane.SetOrigin(*point)
    plane.SetNormal(*normal)
    planes.AddItem(plane)
    clip.SetInputData(surface)
    clip.SetClippingPlanes(planes)
    clip.Update()
    return clip.GetOutput()


def with_numbers(surface, positions, values, radius):
    """The surface with one number at each point: the mean over the particles around."""
    kernel, interpolator = vtk.vtkGaussianKernel(), vtk.vtkPointInterpolator()
    kernel.SetRadius(3 * radius)
    kernel.SetSharpness(2)
    interpolator.SetInputData(surface)
    interpolator.SetSourceData(points_with(positions, values, "colour"))
    interpolator.SetKernel(kernel)
    interpolator.SetNullPointsStrategyToClosestPoint()
    interpolator.Update()
    return interpolator.GetOutput()
