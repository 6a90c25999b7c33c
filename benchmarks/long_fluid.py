#!/usr/bin/env python3
"""Water in a tank over many steps, 2D: whether the J of its particles stays that of the lattice, and the
water its volume. The tank stands still, is shaken, or is stirred by a paddle.

long_fluid.py PATH/OF/magmpm [--steps 100000] [--only still shaken stirred]
"""

import argparse
import csv
import math
import os
import subprocess
import sys
import tempfile

SCENE = """
set Dimension = 2
set End time  = {end_time}
set Gravity   = {gravity}
subsection Box
  set Upper corner = 1, 1
  set Cell size    = 0.03125
end
subsection Bodies
  set List of bodies = water
  subsection water
    set Material     = water
    set Lower corner = 0, 0
    set Upper corner = 1, 0.5
    set Density      = 1000
  end
end
subsection Materials
  set List of materials = water
  subsection water
    set Mechanical law = viscoelastic fluid
    set Bulk modulus   = 1e5     # sound at 10 m/s
    set Viscosity      = 0.001
  end
end
subsection Walls
  set Lower x = slip
  set Upper x = slip
  set Lower y = slip
  set Upper y = slip
end
subsection Output
  set Frame interval   = 1
  set Particles        = false
  set Statistics every = 25
end
"""

# The surface of a solid that pulls at nothing; it dives in and goes round at up to 0.5 m/s.
PADDLE = """
subsection Magnets
  set List of magnets = paddle
  subsection paddle
    set Type          = magnetized sphere
    set Position      = 0.5 + 0.3*cos(2*pi*t/4); 0.62 - 0.4*min(t, 2)/2
    set Magnetization = 0; 0
    set Radius        = 0.08
    set Contact       = slip
  end
end
"""

MASS = 500  # kg/m of water

CASES = {"still": ("0, -9.81", ""), "shaken": ("3, -9.81", ""), "stirred": ("0, -9.81", PADDLE)}


def column(rows, name):
    """The values of the column 'NAME [unit]'."""
    found = [key for key in rows[0] if key.split(" [")[0] == name]
    if not found:
        sys.exit(f"long_fluid: statistics.csv has no column '{name}'")
    return [float(row[found[0]]) for row in rows]


def run(magmpm, gravity, more, end_time, folder):
    """The rows of the statistics."""
    scene = os.path.join(folder, "tank.prm")
    with open(scene, "w") as file:
        file.write(SCENE.format(end_time=end_time, gravity=gravity) + more +
                   f"set Output directory = {folder}/output\n")
    result = subprocess.run([magmpm, scene], capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"long_fluid: {result.stderr}")
    with open(os.path.join(folder, "output", "statistics.csv")) as file:
        return list(csv.DictReader(file))


def mean(values):
    return sum(values) / len(values)


def report(case, rows):
    """One line for each quarter of the run."""
    n = len(rows)
    for quarter in range(4):
        part = rows[quarter * n // 4:(quarter + 1) * n // 4]
        print(f"{case:8} {part[-1]['step']:>7} {100 * mean(column(part, 'density error')):12.2f} "
              f"{100 * max(column(part, 'density error')):12.2f} "
              f"{mean(column(part, 'centre of mass y')):12.4f} "
              f"{min(column(part, 'min J')):8.3f} {max(column(part, 'max J')):8.3f} "
              f"{mean([math.sqrt(2 * e / MASS) for e in column(part, 'kinetic energy')]):8.3f} "
              f"{max(column(part, 'max |v|')):8.2f}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("magmpm", help="the program")
    parser.add_argument("--steps", type=float, default=1e5, help="about so many")
    parser.add_argument("--only", nargs="*", default=list(CASES), choices=list(CASES))
    arguments = parser.parse_args()
    print(subprocess.run([arguments.magmpm, "--version"], capture_output=True, text=True).stdout,
          end="")
    print(f"{'tank':8} {'to step':>7} {'mean |dJ| %':>12} {'largest %':>12} {'mean y [m]':>12} "
          f"{'min J':>8} {'max J':>8} {'rms v':>8} {'max |v|':>8}")
    for case in arguments.only:
        gravity, more = CASES[case]
        with tempfile.TemporaryDirectory() as folder:
            # At 0.4 dx/c and a little more than that for the speed of the water.
            end_time = 1.12e-3 * arguments.steps
            report(case, run(os.path.abspath(arguments.magmpm), gravity, more, end_time, folder))


if __name__ == "__main__":
    main()
