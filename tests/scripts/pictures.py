#!/usr/bin/python3
"""Runs two small scenes and makes pictures of them with the scripts: pictures.py MAGMPM SCRIPTS.

That a picture shows something is told by its colours: white alone is an empty one, the colours of
bodies are those of what is drawn. What the fields and particles are is no matter here.
"""

import glob
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

MAGMPM, SCRIPTS = (os.path.abspath(path) for path in sys.argv[1:3])
SCENES = os.path.join(os.path.dirname(SCRIPTS), "parameter_files")


def render(script, *arguments, path=None):
    """Exit code, output and errors of a script, without a screen."""
    environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
    if path is not None:
        environment["PATH"] = path
    return subprocess.run(["/usr/bin/python3", os.path.join(SCRIPTS, script), *arguments],
                          env=environment, capture_output=True, text=True)


def pixels(file):
    """Red, green, blue of the pixels of a PNG: rows from the bottom, columns."""
    reader = vtk.vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    colours = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return colours.reshape(height, width, -1)[:, :, :3].astype(int)


def part_unlike(image, colour):
    """Fraction of the pixels that differ from a colour."""
    return (abs(image - colour).sum(axis=2) > 30).mean()


class Pictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        for name, options in (("drop_2d", ["Box/Cell size=0.002", "End time=0.004"]),
                              ("cube_nonlinear", ["Box/Cell size=0.0625", "End time=0.01",
                                                  "Output/Frame interval=0.005"])):
            command = [MAGMPM, os.path.join(SCENES, name + ".prm")]
            for option in options + ["Output directory=" + name]:
                command += ["--set", option]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)

    def draw(self, script, *arguments, file="picture.png"):
        done = render(script, *arguments, "--picture", file)
        self.assertEqual(done.returncode, 0, done.stderr)
        return pixels(file)

    def test_particles_are_drawn_in_their_tiles(self):
        image = self.draw("render_particles", "cube_nonlinear", "--frames", "0", "-1",
                          "--tile", "200", "200")
        self.assertEqual(image.shape, (270, 400, 3))
        for tile in (image[70:, :200], image[70:, 200:]):
            self.assertGreater(part_unlike(tile, 255), 0.05)
        self.assertGreater(len(numpy.unique(image[:70].reshape(-1, 3), axis=0)), 100) # colours

    def test_surfaces_have_the_colour_of_the_body_and_a_ground(self):
        image = self.draw("render_particles", "cube_nonlinear", "--frames", "0", "--surface",
                          "--tile", "200", "200")
        red, green, blue = numpy.moveaxis(image, 2, 0)
        self.assertGreater((blue > 1.5 * red).mean(), 0.03) # the cube
        self.assertGreater(((red > blue) & (red > 150) & (red < 230)).mean(), 0.05) # the ground
        flat = self.draw("render_particles", "drop_2d", "--frames", "0", "--surface",
                         "--tile", "200", "200")
        self.assertGreater((flat[:, :, 2] > 1.5 * flat[:, :, 0]).mean(), 0.1) # a disc

    def test_field_lines_are_drawn_around_and_inside_of_a_body(self):
        for run in ("cube_nonlinear", "drop_2d"):
            image = self.draw("render_field_lines", run, "--frame", "-1", "--tile", "300", "240")
            coloured = image[70:].max(axis=2) - image[70:].min(axis=2) > 60
            with self.subTest(run=run):
                self.assertGreater(coloured.mean(), 0.01)
                for half in (coloured[:120], coloured[120:], coloured[:, :150], coloured[:, 150:]):
                    self.assertGreater(half.mean(), 0.003)

    def test_an_animation_moves_with_a_still_camera(self):
        done = render("render_animation", "cube_nonlinear", "--frames-folder", "frames",
                      "--tile", "200", "200", *(["--video", "cube.gif"] if shutil.which("ffmpeg")
                                                else []))
        self.assertEqual(done.returncode, 0, done.stderr)
        first, *_, last = [pixels(file) for file in sorted(glob.glob("frames/frame_*.png"))]
        self.assertTrue((first[:70] == last[:70]).all()) # the colour bar
        self.assertGreater(part_unlike(first, last), 0.001)
        if shutil.which("ffmpeg"):
            self.assertGreater(os.path.getsize("cube.gif"), 2000)

    def test_without_ffmpeg_the_frames_stay(self):
        os.mkdir("programs")
        os.symlink(shutil.which("Xvfb"), "programs/Xvfb")
        for name in ("xkbcomp", "sh"): # Xvfb needs them
            if shutil.which(name):
                os.symlink(shutil.which(name), os.path.join("programs", name))
        done = render("render_animation", "drop_2d", "--video", "drop.mp4", "--every", "2",
                      "--tile", "100", "100", path=os.path.abspath("programs"))
        self.assertEqual(done.returncode, 1)
        self.assertIn("apt-get install --no-install-recommends ffmpeg", done.stderr)
        self.assertEqual(len(glob.glob("drop-frames/frame_*.png")), 2)

    def test_mistakes_are_named(self):
        for script, arguments, message in (
                ("render_particles", ["nothing"], "is that the output folder of a run"),
                ("render_particles", ["drop_2d", "--colour", "speed"], "no quantity 'speed', but J"),
                ("render_field_lines", ["drop_2d", "--quantity", "E"], "no quantity 'E', but B"),
                ("render_animation", ["drop_2d", "--video", "drop.avi"], "neither in .mp4")):
            done = render(script, *arguments)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(message, done.stderr)
        bare = render("render_particles", "drop_2d", path="/nowhere")
        self.assertIn("apt-get install", bare.stderr)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        unittest.main(argv=sys.argv[:1], verbosity=2)
