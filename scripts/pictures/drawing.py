"""What is drawn into a renderer: bodies, spheres, text, a colour bar; the eye; the file."""

import importlib.util
import os

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from pictures.quantities import numbers_of, points_of, points_with
from pictures.screen import fail

BODY_COLOURS = ((0.10, 0.22, 0.36), (0.72, 0.30, 0.16), (0.16, 0.42, 0.30), (0.48, 0.22, 0.46),
                (0.75, 0.58, 0.18), (0.30, 0.30, 0.32))


def colours_between(low, high, logarithmic=False):
    """The colour map 'viridis', for values from low to high."""
    anchors = ((0.267, 0.005, 0.329), (0.283, 0.141, 0.458), (0.230, 0.322, 0.546),
               (0.173, 0.449, 0.558), (0.128, 0.567, 0.551), (0.158, 0.684, 0.502),
               (0.369, 0.789, 0.383), (0.678, 0.864, 0.190), (0.993, 0.906, 0.144))
    between = vtk.vtkColorTransferFunction()
    for i, colour in enumerate(anchors):
        between.AddRGBPoint(255 * i / (len(anchors) - 1), *colour)
    colours = vtk.vtkLookupTable()
    colours.SetNumberOfTableValues(256)
    for i in range(256):
        colours.SetTableValue(i, *between.GetColor(i), 1)
    colours.SetRange(low, high)
    if logarithmic:
        colours.SetScaleToLog10()
    return colours


def add_mapped(renderer, mapper, colours=None):
    """An actor for a mapper; with colours, by the numbers called 'colour'."""
    if colours is None:
        mapper.ScalarVisibilityOff()
    else:
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray("colour")
        mapper.SetLookupTable(colours)
        mapper.UseLookupTableScalarRangeOn()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.35)
    actor.GetProperty().SetDiffuse(0.7)
    renderer.AddActor(actor)
    return actor


def add_particles(renderer, grid, chosen, colour, colours, diameter):
    """Particles as small spheres, coloured by a quantity, or all alike if colour is a triple."""
    by_quantity = isinstance(colour, str)
    values = numbers_of(grid, colour)[chosen] if by_quantity else numpy.zeros(chosen.sum())
    mapper = vtk.vtkOpenGLSphereMapper()
    mapper.SetInputData(points_with(points_of(grid)[chosen], values, "colour"))
    mapper.SetRadius(0.5 * diameter)
    actor = add_mapped(renderer, mapper, colours if by_quantity else None)
    if not by_quantity:
        actor.GetProperty().SetColor(*colour)
    return actor


def add_surface(renderer, surface, colour, colours):
    """A surface that shines a little, in one colour, or in those of its numbers 'colour'."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface)
    actor = add_mapped(renderer, mapper, colours if colour is None else None)
    look = actor.GetProperty()
    look.SetInterpolationToPhong()
    if colour is not None:
        look.SetColor(*colour)
        look.SetSpecular(0.35)
        look.SetSpecularPower(30)
    return actor


def add_tubes(renderer, lines, arrows, radius, colours):
    """Lines with an arrow head on each, in the colours of their numbers."""
    tubes, mapper = vtk.vtkTubeFilter(), vtk.vtkPolyDataMapper()
    tubes.SetInputData(lines)
    tubes.SetRadius(radius)
    tubes.SetNumberOfSides(10)
    mapper.SetInputConnection(tubes.GetOutputPort())
    add_mapped(renderer, mapper, colours)

    cone, heads, mapper = vtk.vtkConeSource(), vtk.vtkGlyph3D(), vtk.vtkPolyDataMapper()
    cone.SetResolution(16)
    cone.SetHeight(8 * radius)
    cone.SetRadius(3 * radius)
    heads.SetInputData(arrows)
    heads.SetSourceConnection(cone.GetOutputPort())
    heads.SetVectorModeToUseVector()
    heads.SetScaleModeToDataScalingOff()
    heads.SetColorModeToColorByScalar()
    mapper.SetInputConnection(heads.GetOutputPort())
    add_mapped(renderer, mapper, colours)


def add_sphere(renderer, sphere):
    """A grey sphere (in 2D a disc): centre and radius."""
    *centre, radius = sphere
    source = vtk.vtkSphereSource()
    source.SetCenter(*(centre + [0.0])[:3])
    source.SetRadius(radius)
    source.SetThetaResolution(64)
    source.SetPhiResolution(64)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = add_mapped(renderer, mapper)
    actor.GetProperty().SetColor(0.62, 0.62, 0.64)
    return actor


def add_ground(renderer, low, high, casters):
    """A light plane at the height of the lower corner, with the shadows of some actors."""
    plane = vtk.vtkPlaneSource()
    plane.SetOrigin(*low)
    plane.SetPoint1(high[0], low[1], low[2])
    plane.SetPoint2(low[0], high[1], low[2])
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(plane.GetOutputPort())
    add_mapped(renderer, mapper).GetProperty().SetColor(0.86, 0.85, 0.83)

    # Light from the upper left in front: what is higher throws its shadow farther back to the right.
    height, lift = low[2], 1e-3 * (high[0] - low[0])
    onto_ground = vtk.vtkTransform()
    onto_ground.SetMatrix((1, 0, 0.35, -0.35 * height, 0, 1, 0.35, -0.35 * height,
                           0, 0, 0, height + lift, 0, 0, 0, 1))
    for caster in casters:
        caster.GetMapper().Update()
        flat, mapper = vtk.vtkTransformPolyDataFilter(), vtk.vtkPolyDataMapper()
        flat.SetInputData(caster.GetMapper().GetInput())
        flat.SetTransform(onto_ground)
        mapper.SetInputConnection(flat.GetOutputPort())
        shadow = add_mapped(renderer, mapper)
        shadow.GetProperty().LightingOff()
        shadow.GetProperty().SetColor(0.60, 0.60, 0.61)


def set_style(text, size):
    text.SetColor(0.1, 0.1, 0.1)
    text.SetFontSize(size)
    text.ItalicOff()
    text.BoldOff()
    text.ShadowOff()


def add_text(renderer, text, x, y, size, justification="left"):
    label = vtk.vtkTextActor()
    label.SetInput(text)
    set_style(label.GetTextProperty(), size)
    if justification == "centre":
        label.GetTextProperty().SetJustificationToCentered()
    label.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    label.SetPosition(x, y)
    renderer.AddActor2D(label)


def colour_bar(colours, name, width, height):
    """A picture of the colours with the name and unit of the quantity."""
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(colours)
    bar.SetOrientationToHorizontal()
    bar.SetTextPositionToPrecedeScalarBar()
    bar.SetMaximumNumberOfColors(256)
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.3g")
    bar.SetPosition(0.35, 0.1)
    bar.SetPosition2(0.6, 0.6)
    bar.SetTextPad(3)
    bar.UnconstrainedFontSizeOn()
    set_style(bar.GetLabelTextProperty(), 14)
    add_text(renderer, name, 0.02, 0.45, 15)
    renderer.AddActor2D(bar)
    return rendered(renderer, width, height)


def place_camera(renderer, low, high, direction, aspect):
    """Looks from a direction, without perspective, so that the box fills the tile."""
    flat = high[2] - low[2] < 1e-9 * max(high[0] - low[0], 1e-300)
    direction = direction or ((0, 0, 1) if flat else (0.35, -1, 0.3))
    up = (0, 1, 0) if flat or list(direction[:2]) == [0, 0] else (0, 0, 1)
    middle = [0.5 * (a + b) for a, b in zip(low, high)]
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*middle)
    camera.SetPosition(*[m + d for m, d in zip(middle, direction)])
    camera.SetViewUp(*up)
    renderer.ResetCamera(low[0], high[0], low[1], high[1], low[2], high[2])
    camera.OrthogonalizeViewUp()

    # A light over the left shoulder shows shapes better than one at the eye.
    light = vtk.vtkLight()
    light.SetLightTypeToCameraLight()
    light.SetPosition(-0.5, 0.7, 1)
    renderer.AddLight(light)
    fill = vtk.vtkLight()
    fill.SetLightTypeToCameraLight()
    fill.SetPosition(1, 0.1, 0.4)
    fill.SetIntensity(0.35)
    renderer.AddLight(fill)

    # The size on the screen of the box's corners, instead of the sphere around them.
    along, upward = camera.GetDirectionOfProjection(), camera.GetViewUp()
    right = numpy.cross(along, upward)
    half = [0.5 * (b - a) for a, b in zip(low, high)]
    width = sum(abs(r) * h for r, h in zip(right, half))
    height = sum(abs(u) * h for u, h in zip(upward, half))
    scale = 1.15 * max(height, width / aspect, 1e-12)
    camera.SetParallelScale(scale)
    # A little up, for the time is written below.
    for place, move in ((camera.GetFocalPoint(), camera.SetFocalPoint),
                        (camera.GetPosition(), camera.SetPosition)):
        move(*[p - 0.07 * scale * u for p, u in zip(place, upward)])


def shade_corners(renderer, size):
    """Darkens what little light reaches: corners, creases, the ground beside a body."""
    passes, shade = vtk.vtkRenderStepsPass(), vtk.vtkSSAOPass()
    shade.SetRadius(0.1 * size)
    shade.SetBias(0.002 * size)
    shade.SetKernelSize(128)
    shade.BlurOn()
    shade.SetDelegatePass(passes)
    renderer.SetPass(shade)


def rendered(renderer, width, height):
    """The picture that a renderer makes: bytes for rows from the top, columns and RGB."""
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(width, height)
    window.AddRenderer(renderer)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.Update()
    colours = vtk_to_numpy(image.GetOutput().GetPointData().GetScalars())
    return colours.reshape(height, width, 3)[::-1].copy()


def save(picture, file, palette=False):
    """Writes a picture as a PNG."""
    height, width, _ = picture.shape
    image, writer = vtk.vtkImageData(), vtk.vtkPNGWriter()
    image.SetDimensions(width, height, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(picture[::-1].reshape(-1, 3), deep=True))
    os.makedirs(os.path.dirname(file) or ".", exist_ok=True)
    writer.SetFileName(file)
    writer.SetCompressionLevel(9)
    writer.SetInputData(image)
    writer.Write()
    if palette:
        reduce_colours(file)


def reduce_colours(file):
    """Writes a PNG anew with 256 colours."""
    if importlib.util.find_spec("PIL") is None:
        fail("--palette needs Pillow. On Debian:\n  apt-get install --no-install-recommends "
             "python3-pil")
    from PIL import Image

    with Image.open(file) as image:
        smaller = image.convert("RGB").quantize(256, dither=Image.Dither.NONE)
    smaller.save(file, optimize=True)
