"""Pictures of runs side by side: every tile shows a frame of a run, all with the same eye."""

import math

import numpy
import vtk

from pictures import drawing
from pictures.quantities import (array_of, numbers_of, points_of, range_over, spacing_of)
from pictures.run import read
from pictures.surface import surface_of, with_normals, with_numbers

BAR_HEIGHT = 70 # pixels


class Look:
    """What all pictures of a set of frames have in common: colours, sizes, what is in view."""

    def __init__(self, runs, shown, options):
        self.options = options
        self.colour = options.colour or ("none" if options.surface else "velocity")
        self.colours = None
        if self.colour != "none":
            between = options.range or range_over(runs, shown, self.colour)
            self.colours = drawing.colours_between(*between)
            self.name = array_of(runs[0].particles(shown[0][0]), self.colour).GetName()
        self.spacing = spacing_of(runs[0].particles(0))
        self.diameter = options.diameter or 1.3 * self.spacing
        self.low, self.high = bounds_to_show(runs, shown, options)


def bounds_to_show(runs, shown, options):
    """Lower and upper corner of what all tiles show."""
    if options.box is not None:
        n = len(options.box) // 2
        return ((options.box[:n] + [0.0])[:3], (options.box[n:] + [0.0])[:3])
    low, high = [math.inf] * 3, [-math.inf] * 3

    def include(bounds):
        for d in range(3):
            low[d] = min(low[d], bounds[2 * d])
            high[d] = max(high[d], bounds[2 * d + 1])

    for run, frames in zip(runs, shown):
        for frame in (frames[0], frames[-1]):
            for *centre, radius in run.magnets(run.frames[frame][0]) + options.magnet:
                thickness = 0 if len(centre) == 2 else radius
                centre = (centre + [0.0])[:3]
                sizes = (radius, radius, thickness)
                include([centre[i // 2] + (sizes[i // 2] if i % 2 else -sizes[i // 2])
                         for i in range(6)])
        first = run.particles(0).GetBounds()
        include(first)
        size = max(first[1] - first[0], first[3] - first[2], first[5] - first[4])
        for frame in frames:
            grid = run.particles(frame)
            bounds = grid.GetBounds()
            if grid.GetNumberOfPoints() and max(bounds[2 * d + 1] - bounds[2 * d]
                                                for d in range(3)) < 3 * size:
                include(bounds)
    return low, high


def bodies_of(grid):
    """Which particles belong to each body, by the body's number; all to body 0 if not written."""
    data = grid.GetPointData()
    names = [data.GetArrayName(i).split(" [")[0] for i in range(data.GetNumberOfArrays())]
    if "body" not in names:
        return {0: numpy.ones(grid.GetNumberOfPoints(), dtype=bool)}
    numbers = numbers_of(grid, "body").astype(int)
    return {body: numbers == body for body in numpy.unique(numbers)}


def add_bodies(renderer, run, frame, look):
    """The actors of the bodies of a frame."""
    grid = run.particles(frame)
    if not grid.GetNumberOfPoints():
        return []
    if look.options.surface:
        return add_surfaces(renderer, run, frame, look)
    return [drawing.add_particles(renderer, grid, chosen,
                                  look.colour if look.colours else body_colour(body),
                                  look.colours, look.diameter)
            for body, chosen in bodies_of(grid).items()]


def body_colour(body):
    return drawing.BODY_COLOURS[body % len(drawing.BODY_COLOURS)]


def add_surfaces(renderer, run, frame, look):
    grid, actors = run.particles(frame), []
    for body, surface in surfaces(run, frame, look.spacing):
        if look.colours:
            surface = with_numbers(surface, points_of(grid), numbers_of(grid, look.colour),
                                   look.spacing)
        actors.append(drawing.add_surface(renderer, surface,
                                          None if look.colours else body_colour(body),
                                          look.colours))
    return actors


def surfaces(run, frame, spacing):
    """Number of a body and its surface, for each body: as the run wrote it, or from particles."""
    files = run.files_at("surface.pvd", frame)
    if files:
        return list(enumerate(with_normals(read(file)) for file in files))
    grid = run.particles(frame)
    return [(body, surface_of(grid, chosen, spacing)) for body, chosen in bodies_of(grid).items()]


def tile(run, frame, look, title=None):
    """The picture of a frame."""
    time = run.frames[frame][0]
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    actors = add_bodies(renderer, run, frame, look)
    actors += [drawing.add_sphere(renderer, sphere)
               for sphere in run.magnets(time) + look.options.magnet]
    drawing.add_text(renderer, "t = %.4g s" % time, 0.5, 0.02, 14, "centre")
    if title:
        drawing.add_text(renderer, title, 0.03, 0.93, 15)
    width, height = look.options.tile
    if look.options.surface and look.high[2] > look.low[2]:
        if run.stands_on_ground():
            drawing.add_ground(renderer, *run.box(), actors)
        drawing.shade_corners(renderer, math.dist(look.low, look.high))
    drawing.place_camera(renderer, look.low, look.high, look.options.direction, width / height)
    renderer.UseFXAAOn()
    return drawing.rendered(renderer, width, height)


def picture_of(rows, look, titles):
    """
    Tiles beside and below one another, and the colour bar.

    rows: of pairs (run, frame).  titles: text for tiles, by row and column.
    """
    tiles = [[tile(run, frame, look, titles.get((i, j))) for j, (run, frame) in enumerate(row)]
             for i, row in enumerate(rows)]
    picture = numpy.vstack([numpy.hstack(row) for row in tiles])
    if look.colours:
        bar = drawing.colour_bar(look.colours, look.name, picture.shape[1], BAR_HEIGHT)
        picture = numpy.vstack([picture, bar])
    return picture
