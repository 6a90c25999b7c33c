"""Water in a tank of 1 m, filled to 0.5 m: the scene, how it is run, and rows with their limits. Of long_fluid.py
and settle.py."""

import csv
import math
import os
import subprocess
import sys

DENSITY, BULK_MODULUS, GRAVITY = 1000.0, 1e5, 9.81
WIDTH, DEPTH = 1.0, 0.5  # m
MASS = DENSITY * WIDTH * DEPTH  # kg/m
SOUND = math.sqrt(BULK_MODULUS / DENSITY)  # m/s

# J = 1 - rho g/K times the depth below the surface of the undeformed water.
COMPRESSION = DENSITY * GRAVITY * DEPTH / BULK_MODULUS  # 1 - J at the floor
MEAN_HEIGHT = DEPTH / 2 - COMPRESSION * DEPTH / 3  # of the mass, at rest

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
  set Frame interval      = {frame_interval}
  set Particles           = {particles}
  set Particle quantities = J
  set Statistics every    = 25
end
"""


class Tank:
    """A run in a folder of its own."""

    def __init__(self, magmpm, folder, end_time, gravity, more="", frame_interval=None):
        self.magmpm = os.path.abspath(magmpm)
        self.output = os.path.join(folder, "output")
        self.scene = os.path.join(folder, "tank.prm")
        with open(self.scene, "w") as file:
            file.write(SCENE.format(end_time=end_time, gravity=gravity,
                                    frame_interval=frame_interval or 1,
                                    particles="true" if frame_interval else "false") + more +
                       f"set Output directory = {self.output}\n")

    def run(self, *arguments):
        result = subprocess.run([self.magmpm, self.scene, *arguments], capture_output=True,
                                text=True)
        if result.returncode != 0:
            sys.exit(f"{os.path.basename(sys.argv[0])}: {result.stderr}")

    def rows(self):
        """Those of the statistics."""
        with open(os.path.join(self.output, "statistics.csv")) as file:
            return list(csv.DictReader(file))


def column(rows, name):
    """The values of the column 'NAME [unit]'."""
    found = [key for key in rows[0] if key.split(" [")[0] == name]
    if not found:
        sys.exit(f"statistics.csv has no column '{name}'")
    return [float(row[found[0]]) for row in rows]


def speeds(rows):
    """The root mean square of the speed in each row [m/s]."""
    return [math.sqrt(2 * energy / MASS) for energy in column(rows, "kinetic energy")]


def mean(values):
    return sum(values) / len(values)


def version(magmpm):
    return subprocess.run([magmpm, "--version"], capture_output=True, text=True).stdout.strip()


def print_limits(rows, as_csv):
    """Rows of name, value and the largest value allowed, which may be None."""
    for name, value, limit in rows:
        if as_csv:
            print(f'"{name}",{value:.6g},{"inf" if limit is None else limit}', flush=True)
        elif limit is None:
            print(f"{name:60} {value:10.4g}", flush=True)
        else:
            print(f"{name:60} {value:10.4g}  limit {limit:8.4g}"
                  f"{'' if value <= limit else '  MISSED'}", flush=True)
