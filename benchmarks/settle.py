#!/usr/bin/env python3
"""What shaking leaves behind, 2D: a tank of 32 x 16 cells of water is shaken sideways for ten seconds, its motion
damped for eight, and left alone for four and for thirty. Then pressures, K (1 - J) over rho g H, of layers a cell
thick and of single particles against the weight of the water above, the height of its centre of mass, and what
still moves.

settle.py PATH/OF/magmpm [--csv]        Needs Python's VTK (Debian: python3-vtk9).
"""

import argparse
import os
import tempfile
import xml.etree.ElementTree

import vtk

from water_tank import COMPRESSION, MEAN_HEIGHT, SOUND, Tank, column, mean, print_limits, speeds, version

SHAKEN, DAMPED, ALONE, AT_REST = 10, 18, 22, 48  # s: until when
N_LAYERS = 16


def heights_and_volumes(folder, time):
    """y [m] and J of the particles in the frame of a time."""
    record = xml.etree.ElementTree.parse(os.path.join(folder, "particles.pvd")).getroot()
    file = min(record.iter("DataSet"),
               key=lambda entry: abs(float(entry.get("timestep")) - time)).get("file")
    reader = vtk.vtkXMLPUnstructuredGridReader()
    reader.SetFileName(os.path.join(folder, file))
    reader.Update()
    grid = reader.GetOutput()
    volumes = grid.GetPointData().GetArray("J [-]")
    return sorted((grid.GetPoint(p)[1], volumes.GetTuple1(p))
                  for p in range(grid.GetNumberOfPoints()))


def pressure_errors(particles):
    """By height: the part of the mass that is above a particle is known without the deformation."""
    n = len(particles)
    return [(1 - volume) / COMPRESSION - (1 - (rank + 0.5) / n)
            for rank, (_, volume) in enumerate(particles)]


def rows_of(tank):
    """Name, value and limit."""
    single = pressure_errors(heights_and_volumes(tank.output, ALONE))
    per_layer = len(single) // N_LAYERS
    layers = [mean(single[layer * per_layer:(layer + 1) * per_layer]) for layer in range(N_LAYERS)]
    statistics = tank.rows()
    times = column(statistics, "time")
    speed = speeds(statistics)
    at_end = [max(row for row, time in enumerate(times) if time <= end) for end in (ALONE, AT_REST)]
    shaken = [row for row, time in zip(statistics, times) if 0.5 * SHAKEN < time < SHAKEN]
    height = column(statistics, "centre of mass y")[at_end[0]]
    return [("shaken, density error", mean(column(shaken, "density error")), None),
            ("shaken, 1 - min J", 1 - min(column(shaken, "min J")), None),
            ("shaken, max J - 1", max(column(shaken, "max J")) - 1, None),
            ("settled, pressure of layers inside", max(abs(error) for error in layers[1:-1]), 0.007),
            ("settled, pressure at the floor", abs(layers[0]), 0.005),
            ("settled, pressure at the surface", abs(layers[-1]), None),
            ("settled, single particles, rms", mean([error**2 for error in single])**0.5, 0.02),
            ("settled, single particles, worst", max(abs(error) for error in single), None),
            ("settled, mean height", abs(height / MEAN_HEIGHT - 1), 0.001),
            ("settled, rms of v over c after 4 s", speed[at_end[0]] / SOUND, 5e-4),
            ("settled, rms of v over c after 30 s", speed[at_end[1]] / SOUND, 2e-4)]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("magmpm", help="the program")
    parser.add_argument("--csv", action="store_true", help="name,value,limit")
    arguments = parser.parse_args()
    print("name,value,limit" if arguments.csv else version(arguments.magmpm), flush=True)
    with tempfile.TemporaryDirectory() as folder:
        tank = Tank(arguments.magmpm, folder, SHAKEN,
                    f"if(t < {SHAKEN}, 3*sign(sin(pi*t)), 0); -9.81", frame_interval=1)
        tank.run()
        for end_time, damping in ((DAMPED, 2), (ALONE, 0), (AT_REST, 0)):
            tank.run("--resume", "--set", f"End time={end_time}", "--set",
                     f"Rest/Damping rate={damping}")
        print_limits(rows_of(tank), arguments.csv)


if __name__ == "__main__":
    main()
