#!/usr/bin/env python3
"""The magnetized cube that hits a magnet, parameter_files/cube_nonlinear.prm: what lattice spacing,
time step, the trigger of a new magnetic solve and the contact cost, and what they change of the impact.

impact_speed.py PATH/OF/magmpm [--end-time 0.17] [--ranks 2] [--only spacing step trigger contact]
"""

import argparse
import csv
import os
import resource
import subprocess
import sys
import tempfile

SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                     "..", "parameter_files", "cube_nonlinear.prm")


def cell_size(n_cells):
    return [f"Box/Cell size={1.0 / n_cells!r}"]


def moved_fraction(fraction):
    return [f"Magnetics/Solve/Moved fraction={fraction}"]


def elastic_factor(factor):
    return [f"Time step/Elastic factor={factor}"]


FIXED_STEP = ["Time step/Time step=5e-5", "Time step/Allow unstable time step=true"]


def groups(n_cells, finest):
    """{name: [(row, settings), ...]}; the rows of a group are compared with its last."""
    coarse = cell_size(n_cells)
    return {
        "spacing": [(f"dx = 1/{n}", cell_size(n)) for n in (64, 96, 128) if n <= finest],
        "step": [(f"elastic factor {f}", coarse + elastic_factor(f)) for f in (0.6, 0.4, 0.2, 0.1)]
        + [("fixed 5e-5 s", coarse + FIXED_STEP)],
        "trigger": [(f"moved by {f} dx", coarse + moved_fraction(f)) for f in (0.5, 0.2, 0.1, 0.05)]
        + [("every step", coarse + ["Magnetics/Solve/When=every step"])],
        "contact": [(f"{contact}, factor {f}",
                     coarse + elastic_factor(f) + [f"Magnets/ball/Contact={contact}"])
                    for contact, factors in (("slip", (0.1, 0.4)), ("stick", (0.02, 0.1, 0.4)))
                    for f in factors],
    }


def column(rows, name):
    """The values of the column 'NAME [unit]'."""
    found = [key for key in rows[0] if key.split(" [")[0] == name]
    if not found:
        sys.exit(f"impact_speed: statistics.csv has no column '{name}'")
    return [float(row[found[0]]) for row in rows]


def parabola_peak(x, y):
    """Place and height of the vertex of the parabola through three points."""
    left, right = (y[1] - y[0]) / (x[1] - x[0]), (y[2] - y[1]) / (x[2] - x[1])
    curvature = (right - left) / (x[2] - x[0])
    if curvature == 0.0:
        return x[1], y[1]
    place = 0.5 * (x[0] + x[1]) - left / (2.0 * curvature)
    return place, y[1] + (place - x[1]) * (left + curvature * (place - x[0]))


def energies(rows):
    """The largest kinetic energy [J], and the largest rise of the sum of all over its lowest value before."""
    names = [key for key in rows[0] if key.endswith(" energy [J]")]
    largest, lowest, rise = max(column(rows, "kinetic energy")), float("inf"), 0.0
    for row in rows:
        total = sum(float(row[name]) for name in names)
        lowest = min(lowest, total)
        rise = max(rise, total - lowest)
    return largest, rise


def impact(path):
    """When the centre of mass was fastest, its speed then, the smallest J, and the energies."""
    with open(path, newline="") as table:
        rows = list(csv.DictReader(table))
    times, heights = column(rows, "time"), column(rows, "centre of mass z")
    middles = [0.5 * (a + b) for a, b in zip(times, times[1:])]
    speeds = [(a - b) / (t - s) for a, b, s, t in zip(heights, heights[1:], times, times[1:])]
    top = max(range(len(speeds)), key=speeds.__getitem__)
    if top == len(speeds) - 1:
        sys.exit("impact_speed: the cube has not hit the magnet yet; give a later --end-time")
    when, speed = parabola_peak(middles[top - 1:top + 2], speeds[top - 1:top + 2])
    volumes = column(rows, "min J")
    if min(volumes) == volumes[-1]:
        sys.exit("impact_speed: the cube is still being compressed; give a later --end-time")
    kinetic, rise = energies(rows)
    return {"time": when, "speed": speed, "min J": min(volumes), "kinetic": kinetic, "rise": rise,
            "steps": len(rows), "solves": int(column(rows, "magnetic solves")[-1])}


def cpu_seconds():
    """Of all runs so far: on a machine that others use too, wall time also has what they took."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(options, settings):
    with tempfile.TemporaryDirectory() as folder:
        settings = settings + [f"End time={options.end_time}", f"Output directory={folder}/out",
                               "Output/Particles=false", "Output/Fields=false"]
        command = ["mpirun", "-np", str(options.ranks), options.program, SCENE]
        for setting in settings:
            command += ["--set", setting]
        start = cpu_seconds()
        done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if done.returncode != 0:
            return done.stderr.strip().splitlines()[-1]
        result = impact(os.path.join(folder, "out", "statistics.csv"))
        result["seconds"] = (cpu_seconds() - start) / options.ranks
        return result


def print_group(name, results):
    """Deviations are from the last row that did not fail."""
    print(f"\n{name:<20} {'core s':>8} {'steps':>6} {'solves':>6} {'impact s':>9} {'':>8} "
          f"{'speed m/s':>9} {'':>8} {'min J':>7} {'':>8} {'K [J]':>7} {'rise/K':>7}")
    finished = [result for _, result in results if isinstance(result, dict)]
    for row, result in results:
        if isinstance(result, str):
            print(f"{row:<20} failed: {result}")
            continue
        text = f"{row:<20} {result['seconds']:8.1f} {result['steps']:6d} {result['solves']:6d}"
        for key, digits in (("time", 5), ("speed", 4), ("min J", 4)):
            width = 7 if key == "min J" else 9
            deviation = result[key] / finished[-1][key] - 1.0
            text += f" {result[key]:{width}.{digits}f} {100.0 * deviation:+7.2f}%"
        text += f" {result['kinetic']:7.1f} {100.0 * result['rise'] / result['kinetic']:6.2f}%"
        print(text, flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="magmpm")
    parser.add_argument("--end-time", type=float, default=0.17, help="[s]")
    parser.add_argument("--ranks", type=int, default=2)
    parser.add_argument("--cells", type=int, default=64, help="1/dx of all but spacings [1/m]")
    parser.add_argument("--finest", type=int, default=128, help="largest 1/dx of spacings [1/m]")
    parser.add_argument("--only", nargs="+", choices=["spacing", "step", "trigger", "contact"])
    options = parser.parse_args()
    print(f"cube_nonlinear.prm until {options.end_time} s, {options.ranks} ranks, no output; "
          f"all but spacings with dx = 1/{options.cells}\n"
          "impact: when the centre of mass is fastest; per cent: from the last row; "
          "core s: per rank", flush=True)
    for name, cases in groups(options.cells, options.finest).items():
        if not options.only or name in options.only:
            print_group(name, [(row, run(options, settings)) for row, settings in cases])


if __name__ == "__main__":
    main()
