#!/usr/bin/env python3
"""Water in a tank over many steps, 2D: whether the J of its particles stays that of the lattice, and the
water its volume. The tank stands still, is shaken, or is stirred by a paddle. Each quarter of a run has a line;
the last one is held against its limits.

long_fluid.py PATH/OF/magmpm [--steps 100000] [--only still shaken stirred] [--csv]
"""

import argparse
import tempfile

from water_tank import COMPRESSION, MEAN_HEIGHT, SOUND, Tank, column, mean, print_limits, speeds, version

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

CASES = {"still": ("0, -9.81", ""), "shaken": ("3, -9.81", ""), "stirred": ("0, -9.81", PADDLE)}

# The largest mean density error, 1 - min J, max J - 1.
LIMITS = {"still": (0.001, COMPRESSION + 0.002, 0.002),
          "shaken": (0.004, 0.08, 0.02),
          "stirred": (0.02, 0.13, 0.04)}


def quarters(rows):
    n = len(rows)
    return [rows[quarter * n // 4:(quarter + 1) * n // 4] for quarter in range(4)]


def report(case, rows):
    """One line for each quarter of the run."""
    for part in quarters(rows):
        print(f"{case:8} {part[-1]['step']:>7} {100 * mean(column(part, 'density error')):12.2f} "
              f"{100 * max(column(part, 'density error')):12.2f} "
              f"{mean(column(part, 'centre of mass y')):12.4f} "
              f"{min(column(part, 'min J')):8.3f} {min(column(part, 'min J')) - 1 + COMPRESSION:10.4f} "
              f"{max(column(part, 'max J')):8.3f} "
              f"{mean(speeds(part)):8.3f} {mean(speeds(part)) / SOUND:8.1e} "
              f"{max(column(part, 'max |v|')):8.2f}", flush=True)


def limits(case, rows):
    """The last quarter against what it may be."""
    heights = [mean(column(part, "centre of mass y")) for part in quarters(rows)]
    last = quarters(rows)[-1]
    error, compression, expansion = LIMITS[case]
    result = [(f"{case}, density error", mean(column(last, "density error")), error),
              (f"{case}, 1 - min J", 1 - min(column(last, "min J")), compression),
              (f"{case}, max J - 1", max(column(last, "max J")) - 1, expansion),
              (f"{case}, mean height against the quarters before",
               max(abs(height / heights[-1] - 1) for height in heights[1:]), 0.003)]
    if case == "still":
        result += [("still, |min J - hydrostatic|",
                    abs(min(column(last, "min J")) - 1 + COMPRESSION), 0.002),
                   ("still, |mean height - hydrostatic| [m]", abs(heights[-1] - MEAN_HEIGHT), 0.0005),
                   ("still, rms of v over c", mean(speeds(last)) / SOUND, 1e-4)]
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("magmpm", help="the program")
    parser.add_argument("--steps", type=float, default=1e5, help="about so many")
    parser.add_argument("--only", nargs="*", default=list(CASES), choices=list(CASES))
    parser.add_argument("--csv", action="store_true", help="name,value,limit of the last quarters alone")
    arguments = parser.parse_args()
    if arguments.csv:
        print("name,value,limit")
    else:
        print(version(arguments.magmpm))
        print(f"{'tank':8} {'to step':>7} {'mean |dJ| %':>12} {'largest %':>12} {'mean y [m]':>12} "
              f"{'min J':>8} {'from rest':>10} {'max J':>8} {'rms v':>8} {'rms v/c':>8} {'max |v|':>8}")
    rows_with_limits = []
    for case in arguments.only:
        gravity, more = CASES[case]
        with tempfile.TemporaryDirectory() as folder:
            # At 0.4 dx/c and a little more than that for the speed of the water.
            tank = Tank(arguments.magmpm, folder, 1.12e-3 * arguments.steps, gravity, more)
            tank.run()
            rows = tank.rows()
        if not arguments.csv:
            report(case, rows)
        rows_with_limits += limits(case, rows)
    print_limits(rows_with_limits, arguments.csv)


if __name__ == "__main__":
    main()
