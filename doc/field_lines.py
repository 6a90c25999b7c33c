"""Field lines of H_int (the field h = -grad phi of the magnetized material) around the particles.

In ParaView:    Tools > Python Shell > Run Script, after `import os; os.chdir("output-...")`,
                or  paraview --script=doc/field_lines.py  started inside the output folder
As a picture:   pvbatch doc/field_lines.py output-cube_nonlinear --frame 60 --picture lines.png
                (without a screen: xvfb-run -a pvbatch ...)

It opens fields.pvd and particles.pvd of a run, seeds lines around the particles of the chosen
frame (the last one by default), and leaves a pipeline in which everything can be changed: the
seeds, the quantity (H, M and B can be traced as well) and the time. Whoever makes a stream tracer
by hand sets its "Interpolator Type" to "Interpolator with Cell Locator", see trace_lines() below.
"""

import argparse
import os
import sys

from paraview import simple


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", default=".", help="output folder of a run")
    parser.add_argument("--quantity", default="H_int", help="H_int (default), H, M or B")
    parser.add_argument("--frame", type=int, default=-1, help="number of the frame, -1 the last")
    parser.add_argument("--seeds", type=int, default=150, help="number of lines")
    parser.add_argument("--picture", help="write this PNG and end")
    # ParaView's own shell has arguments of its own, which are none of this script's.
    return parser.parse_args(sys.argv[1:] if sys.argv and sys.argv[0].endswith(".py") else [])


def full_name(source, quantity):
    """The name with its unit, such as 'H_int [A/m]', as it stands in the file."""
    for array in source.PointData:
        if array.GetName().split(" [")[0] == quantity:
            return array.GetName()
    sys.exit("field_lines: there is no '%s' in the fields; see 'Field quantities' in the parameter "
             "file." % quantity)


def open_series(folder, name):
    path = os.path.abspath(os.path.join(folder, name))
    if not os.path.exists(path):
        sys.exit("field_lines: there is no '%s': is that the output folder of a run?" % path)
    source = simple.PVDReader(registrationName=name, FileName=path)
    source.UpdatePipelineInformation()
    return source


def show_particles(particles, view):
    display = simple.Show(particles, view)
    display.SetRepresentationType("Points")
    display.PointSize = 2.0
    display.RenderPointsAsSpheres = 1
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = display.AmbientColor = [0.35, 0.35, 0.4]


def trace_lines(fields, particles, options):
    """Lines through points spread over a ball around the particles."""
    bounds = particles.GetDataInformation().GetBounds()
    middle = [0.5 * (bounds[2 * d] + bounds[2 * d + 1]) for d in range(3)]
    size = max(bounds[2 * d + 1] - bounds[2 * d] for d in range(3))

    lines = simple.StreamTracer(registrationName="field lines", Input=fields,
                                SeedType="Point Cloud")
    lines.Vectors = ["POINTS", full_name(fields, options.quantity)]
    lines.SeedType.Center = middle
    lines.SeedType.Radius = size
    lines.SeedType.NumberOfPoints = options.seeds
    lines.IntegrationDirection = "BOTH"
    lines.MaximumStreamlineLength = 10 * size
    lines.MaximumSteps = 2000
    # The default walks from a cell to its neighbour through common points, which cells of different
    # size do not have: lines would end wherever the mesh changes its size.
    lines.InterpolatorType = "Interpolator with Cell Locator"
    return lines, size


def show_lines(lines, size, options, view):
    tubes = simple.Tube(registrationName="tubes", Input=lines)
    tubes.Radius = 0.008 * size
    display = simple.Show(tubes, view)
    name = full_name(lines, options.quantity)
    simple.ColorBy(display, ("POINTS", name, "Magnitude"))
    colours = simple.GetColorTransferFunction(name)
    colours.ApplyPreset("Viridis (matplotlib)", True)
    display.RescaleTransferFunctionToDataRange(True, False)
    colours.MapControlPointsToLogSpace() # the field falls with the cube of the distance
    colours.UseLogScale = 1
    display.SetScalarBarVisibility(view, True)


def look_at_particles(particles, size, view):
    """A view without perspective, from the side in 3D, that holds four times their size."""
    bounds = particles.GetDataInformation().GetBounds()
    middle = [0.5 * (bounds[2 * d] + bounds[2 * d + 1]) for d in range(3)]
    is_flat = bounds[5] == bounds[4]
    direction, up = ([0, 0, 5], [0, 1, 0]) if is_flat else ([1.7, -4.5, 1.2], [0, 0, 1])
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = middle
    view.CameraPosition = [m + size * d for m, d in zip(middle, direction)]
    view.CameraViewUp = up
    view.CameraParallelScale = 2 * size


def main():
    options = arguments()
    fields = open_series(options.folder, "fields.pvd")
    particles = open_series(options.folder, "particles.pvd")
    times = list(fields.TimestepValues) or [0.0]
    time = times[min(options.frame, len(times) - 1)]
    for source in (fields, particles):
        source.UpdatePipeline(time)
    full_name(fields, options.quantity)

    simple._DisableFirstRenderCameraReset()
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = [800, 700]
    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    simple.GetTimeKeeper().Time = view.ViewTime = time

    show_particles(particles, view)
    lines, size = trace_lines(fields, particles, options)
    show_lines(lines, size, options, view)

    look_at_particles(particles, size, view)
    simple.Render()
    if options.picture:
        simple.SaveScreenshot(options.picture, view, CompressionLevel=5,
                              OverrideColorPalette="WhiteBackground")


main()
