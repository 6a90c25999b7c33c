"""The picture of render_field_lines: bodies cut open in a plane, and field lines in it."""

import numpy
import vtk

from pictures import drawing, field_lines
from pictures.quantities import array_of, points_of, spacing_of
from pictures.run import Run
from pictures.screen import fail
from pictures.surface import cut_open
from pictures.tiles import BAR_HEIGHT, surfaces

BODY = (0.80, 0.76, 0.70)


def make(options, axis):
    """Writes the picture. axis: across which the plane of the seeds lies, or None."""
    run = Run(options.folder)
    frame = run.index(options.frame)
    fields = run.fields(frame)
    name = array_of(fields, options.quantity).GetName()
    low, high, axis = region(run, frame, fields, options, axis)
    distance = options.distance or max(high - low) / 40
    lines = chosen_lines(fields, options.quantity, low, high, axis, distance)
    if not lines:
        fail("no line of '%s' is longer than three times the distance %g m between lines: is the "
             "field zero in this frame?" % (name, distance))

    magnitudes = numpy.linalg.norm(numpy.concatenate([line[1] for line in lines]), axis=1)
    between = options.range or numpy.percentile(magnitudes, (1, 99))
    colours = drawing.colours_between(max(between[0], 1e-3 * between[1]), between[1], True)
    width, height = options.tile
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    direction = options.direction or view_across(axis)
    add_bodies(renderer, run, frame, axis if not options.whole else None, low, high, direction)
    drawing.add_tubes(renderer, field_lines.as_polylines(lines), field_lines.arrows_of(lines),
                      distance / 16, colours)
    for sphere in run.magnets(run.frames[frame][0]) + options.magnet:
        drawing.add_sphere(renderer, sphere)
    drawing.add_text(renderer, "t = %.4g s" % run.frames[frame][0], 0.5, 0.02, 14, "centre")
    drawing.place_camera(renderer, low, high, direction, width / height)
    renderer.UseFXAAOn()
    picture = drawing.rendered(renderer, width, height)
    bar = drawing.colour_bar(colours, name, width, BAR_HEIGHT)
    drawing.save(numpy.vstack([picture, bar]), options.picture, options.palette)


def region(run, frame, fields, options, axis):
    """
    Lower and upper corner of where lines are drawn: half of the bodies' size around them, but
    within the mesh, and without thickness across the plane; and the axis, which is z in 2D.
    """
    points = points_of(run.particles(frame))
    if options.box is not None:
        n = len(options.box) // 2
        low, high = (numpy.array((options.box[i:i + n] + [0.0])[:3]) for i in (0, n))
    elif len(points):
        margin = 0.5 * numpy.ptp(points, axis=0).max()
        low, high = points.min(axis=0) - margin, points.max(axis=0) + margin
    else:
        fail("frame %d has no particles to draw lines around: give the region by --box." % frame)
    bounds = fields.GetBounds()
    low, high = numpy.maximum(low, bounds[::2]), numpy.minimum(high, bounds[1::2])
    if bounds[4] == bounds[5]:
        axis = 2
    if axis is not None and len(points) and options.box is None:
        low[axis] = high[axis] = 0.5 * (points[:, axis].min() + points[:, axis].max())
    return low, high, axis


def chosen_lines(fields, quantity, low, high, axis, distance):
    """Lines through points of the plane, apart from one another by the distance."""
    seeds = field_lines.seeds_in_plane(low, high, axis, distance)
    if axis is None:
        seeds = seeds[:4000]
    lines = field_lines.lines_through(fields, quantity, seeds, 2 * max(high - low), distance / 4)
    thick = [0, 0, 0] if axis is None else [2 * distance * (d == axis) for d in range(3)]
    return field_lines.evenly_spaced(lines, low - thick, high + thick, distance)


def view_across(axis):
    """Where the eye is: in front of the plane, a little to the right and above."""
    return {None: (0.35, -1, 0.3), 0: (1, -0.2, 0.25), 1: (0.2, -1, 0.25), 2: (0, 0, 1)}[axis]


def add_bodies(renderer, run, frame, axis, low, high, direction):
    """The surfaces of the bodies; what is between the plane and the eye is cut away."""
    for _, surface in surfaces(run, frame, spacing_of(run.particles(0))):
        if axis is not None and high[axis] == low[axis] and not is_flat(surface):
            normal = [-numpy.sign(direction[d]) * (d == axis) for d in range(3)]
            surface = cut_open(surface, 0.5 * (low + high), normal)
        drawing.add_surface(renderer, surface, BODY, None)


def is_flat(surface):
    bounds = surface.GetBounds()
    return bounds[4] == bounds[5]
