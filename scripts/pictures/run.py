"""The output folder of a run: its frames, what they hold, its magnets."""

import math
import os
import re
import xml.etree.ElementTree

import vtk

from pictures.screen import fail


class Run:
    """An output folder. Frames are counted by particles.pvd."""

    def __init__(self, folder):
        self.folder = folder
        self.frames = self.record("particles.pvd")
        if not self.frames:
            fail("there is no frame in '%s': is that the output folder of a run, and does it write "
                 "particles?" % os.path.join(folder, "particles.pvd"))
        self.parameters = self.read_parameters()
        self.loaded = (None, None)

    def record(self, name):
        """Time and file of each data set that a .pvd names; empty if there is no such file."""
        path = os.path.join(self.folder, name)
        if not os.path.exists(path):
            return []
        return [(float(entry.get("timestep")), os.path.join(self.folder, entry.get("file")))
                for entry in xml.etree.ElementTree.parse(path).getroot().iter("DataSet")]

    def files_at(self, name, frame):
        """The files that a .pvd names for the time of a frame."""
        time = self.frames[frame][0]
        return [file for other, file in self.record(name)
                if abs(other - time) <= 1e-9 * max(abs(time), 1e-9)]

    def read_parameters(self):
        """The values of parameters.prm by 'Section/Subsection/Name'; empty if there is no file."""
        values, sections = {}, []
        path = os.path.join(self.folder, "parameters.prm")
        if not os.path.exists(path):
            return values
        with open(path, encoding="utf-8") as file:
            for line in file:
                line = re.sub(r"\s+", " ", line.split("#")[0]).strip()
                if line.startswith("subsection "):
                    sections.append(line[len("subsection "):])
                elif line == "end":
                    sections.pop()
                elif line.startswith("set ") and "=" in line:
                    name, value = line[len("set "):].split("=", 1)
                    values["/".join(sections + [name.strip()])] = value.strip()
        return values

    def magnets(self, time):
        """Centre and radius of each magnetized sphere at a time."""
        spheres = []
        for name, value in self.parameters.items():
            if name.startswith("Magnets/") and name.endswith("/Type") and "sphere" in value:
                magnet = name[:-len("Type")]
                position = self.parameters[magnet + "Position"].split(";")
                radius = float(self.parameters[magnet + "Radius"])
                spheres.append([expression_at(text, time) for text in position] + [radius])
        return spheres

    def solids(self, frame):
        """Surfaces of magnets and rigid bodies by number: magnets first, in the order of their list."""
        return [item for file in self.files_at("rigid_bodies.pvd", frame)
                for item in parts_of(read(file))]

    def n_magnets(self):
        names = self.parameters.get("Magnets/List of magnets", "")
        return len([name for name in names.split(",") if name.strip()])

    def box(self):
        """Lower and upper corner of the mechanical box [m]."""
        corners = [self.parameters.get("Box/%s corner" % which, "") for which in ("Lower", "Upper")]
        return [[float(number) for number in corner.split(",")] for corner in corners]

    def stands_on_ground(self):
        """Whether gravity pulls down onto a wall."""
        gravity = re.split("[,;]", self.parameters.get("Gravity", ""))  # it may be expressions of t
        return gravity[-1].strip().startswith("-") and self.parameters.get("Walls/Lower z") != "open"

    def particles(self, frame):
        """The particles of a frame as VTK's grid; the latest frame asked for is kept."""
        if self.loaded[0] != frame:
            self.loaded = (frame, read(self.frames[frame][1]))
        return self.loaded[1]

    def fields(self, frame):
        """The magnetic fields of a frame as VTK's grid."""
        files = self.files_at("fields.pvd", frame)
        if not files:
            fail("there are no fields of frame %d in '%s': does the run write them (Output/Fields), "
                 "and is anything magnetic?" % (frame, os.path.join(self.folder, "fields.pvd")))
        return read(files[0])

    def index(self, frame):
        """The number of a frame where -1 is the last and -2 the one before."""
        last = len(self.frames) - 1
        return min(frame, last) if frame >= 0 else max(0, last + 1 + frame)

    def frame_near(self, time):
        return min(range(len(self.frames)), key=lambda i: abs(self.frames[i][0] - time))


def read(file):
    """The data set in a file that magmpm wrote."""
    if not os.path.exists(file):
        fail("there is no '%s', which the record of the frames names." % file)
    readers = {".vtu": vtk.vtkXMLUnstructuredGridReader, ".vtp": vtk.vtkXMLPolyDataReader,
               ".pvtu": vtk.vtkXMLPUnstructuredGridReader, ".pvtp": vtk.vtkXMLPPolyDataReader}
    reader = readers[os.path.splitext(file)[1]]()
    reader.SetFileName(file)
    reader.Update()
    return reader.GetOutput()


def parts_of(grid):
    """Numbers and surfaces (in 2D areas) of what the quantity 'body [-]' tells apart in a grid."""
    surface, threshold = vtk.vtkGeometryFilter(), vtk.vtkThreshold()
    name, at_points = "body [-]", grid.GetPointData().HasArray("body [-]")
    values = (grid.GetPointData() if at_points else grid.GetCellData()).GetArray(name)
    if not grid.GetNumberOfCells() or values is None:
        return []
    threshold.SetInputData(grid)
    threshold.SetInputArrayToProcess(0, 0, 0, int(not at_points), name)
    surface.SetInputConnection(threshold.GetOutputPort())
    parts = []
    for number in range(int(values.GetRange()[0]), int(values.GetRange()[1]) + 1):
        threshold.SetLowerThreshold(number - 0.5)
        threshold.SetUpperThreshold(number + 0.5)
        surface.Update()
        if surface.GetOutput().GetNumberOfCells():
            part = vtk.vtkPolyData()
            part.DeepCopy(surface.GetOutput())
            parts.append((number, filled(part) if part.GetNumberOfLines() else part))
    return parts


def filled(lines):
    """The area inside of closed lines."""
    clean, strips, area = vtk.vtkCleanPolyData(), vtk.vtkStripper(), vtk.vtkContourTriangulator()
    clean.SetInputData(lines)
    strips.SetInputConnection(clean.GetOutputPort())
    strips.JoinContiguousSegmentsOn()
    area.SetInputConnection(strips.GetOutputPort())
    area.Update()
    return area.GetOutput()


def expression_at(text, time):
    """The value of an expression of t as it stands in a parameter file, if it is a simple one."""
    names = {name: getattr(math, name) for name in dir(math) if not name.startswith("_")}
    names.update(t=time, abs=abs, min=min, max=max, choose=lambda test, a, b: a if test else b)
    source = re.sub(r"\bif\s*\(", "choose(", text.replace("^", "**"))
    try:
        return float(eval(source, {"__builtins__": {}}, names))
    except Exception as error:
        fail("the expression '%s' of a magnet's position is beyond this script (%s). Give the "
             "sphere with --magnet." % (text.strip(), error))
