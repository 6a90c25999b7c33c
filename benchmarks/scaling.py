#!/usr/bin/env python3
"""Strong and weak scaling of magmpm by phase of a step: a magnetized block of particles that flies
through the field of a magnet, at fixed steps with a solve in every tenth.

scaling.py PATH/OF/magmpm [--ranks 2] [--cells 32] [--repeats 5]

Strong: the same block on one rank and on several. Weak: a block that is longer by the number of ranks.
The runs take turns; of each step and phase the shortest time of all repeats counts, so that
what others do on the machine matters less; of the ranks the first is timed, with what it waits.
"""

import argparse
import csv
import os
import subprocess
import sys
import tempfile

PHASES = ["P2G", "Update lattice", "G2P", "Sort and migrate", "Solve potential"]
PARTICLE_PHASES = PHASES[:4]

# One block of n^3 cells (weak: several in a row), which crosses 5 cells in 40 steps.
SCENE = """
set Dimension = 3
set End time  = 0.008
set Gravity   = 0, 0, 0
subsection Box
  set Upper corner = {box_x}, 1.5, 1.5
  set Cell size    = {dx}
end
subsection Bodies
  set List of bodies = block
  subsection block
    set Material     = clay
    set Lower corner = 0.25, 0.25, 0.25
    set Upper corner = {block_x}, 1.25, 1.25
    set Density      = 2500
    set Velocity     = {speed}, {speed}, {speed}
  end
end
subsection Materials
  set List of materials = clay
  subsection clay
    set Young's modulus          = 1e5
    set Poisson ratio            = 0.3
    set Saturation magnetization = 8e4
    set Initial susceptibility   = 0.9
  end
end
subsection Magnets
  set List of magnets = field
  subsection field
    set Type  = uniform field
    set Field = 0; 0; 1e5
  end
end
subsection Magnetics
  set Newton tolerance = 1e-6
  subsection Solve
    set When  = every n steps
    set Steps = 10
  end
end
subsection Time step
  set Time step = 2e-4
end
subsection Output
  set Frame interval = 0.008
  set Particles      = false
  set Fields         = false
end
"""


def scene(n_cells, n_blocks):
    dx = 1.0 / n_cells
    return SCENE.format(dx=repr(dx), box_x=0.5 + n_blocks, block_x=0.25 + n_blocks,
                        speed=5.0 * dx / 0.008)


def rows_of(program, n_ranks, text):
    """Rows of statistics.csv of a run."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "scaling.prm"), "w", encoding="utf-8") as file:
            file.write(text)
        done = subprocess.run(["mpirun", "-np", str(n_ranks), program, "scaling.prm"], cwd=folder,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if done.returncode != 0:
            sys.exit("scaling: magmpm failed: " + done.stderr.strip())
        with open(os.path.join(folder, "output-scaling", "statistics.csv"), newline="") as table:
            return list(csv.DictReader(table))


def shorter(best, rows):
    """Of each step and phase the shorter time."""
    times = [{phase: float(row[f"wall time: {phase} [s]"]) for phase in PHASES} for row in rows[1:]]
    if best is None:
        return times
    return [{phase: min(a[phase], b[phase]) for phase in PHASES} for a, b in zip(best, times)]


def total(times, phases):
    return sum(step[phase] for step in times for phase in phases)


def check(rows, n_ranks):
    """A figure about several ranks has to come from several ranks."""
    last = rows[-1]
    if n_ranks > 1 and float(last["migrated particles"]) == 0.0:
        sys.exit("scaling: no particle has changed its rank")
    return last


def print_table(title, one, several, n_ranks, is_weak):
    """Speed-up, or n times as much work in the same time: n t_1/t_n."""
    factor = n_ranks if is_weak else 1
    print(f"\n{title}\n{'phase':<18} {'1 rank, s':>10} {f'{n_ranks} ranks, s':>12} {'speed-up':>9}")
    rows = [(phase, [phase]) for phase in PHASES]
    for name, phases in rows + [("particle phases", PARTICLE_PHASES), ("all of these", PHASES)]:
        t_one, t_several = total(one, phases), total(several, phases)
        print(f"{name:<18} {t_one:10.3f} {t_several:12.3f} {factor * t_one / t_several:9.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="magmpm")
    parser.add_argument("--ranks", type=int, default=2)
    parser.add_argument("--cells", type=int, default=32, help="along an edge of the block, 8 n")
    parser.add_argument("--repeats", type=int, default=5)
    options = parser.parse_args()
    program = os.path.abspath(options.program)
    n = options.ranks

    runs = {"one": (1, 1), "strong": (n, 1), "weak": (n, n)}
    best = dict.fromkeys(runs)
    loads = []
    for _ in range(options.repeats):
        for name, (n_ranks, n_blocks) in runs.items():
            loads.append(os.getloadavg()[0])
            rows = rows_of(program, n_ranks, scene(options.cells, n_blocks))
            last = check(rows, n_ranks)
            best[name] = shorter(best[name], rows)
            if len(loads) <= len(runs):
                print(f"{name}: {n_ranks} ranks, {float(last['particles']):,.0f} particles, "
                      f"{float(last['potential unknowns']):,.0f} unknowns, "
                      f"{float(last['migrated particles']):,.0f} migrations, "
                      f"load imbalance {float(last['load imbalance [-]']):.3f}", flush=True)
    print(f"{len(best['one'])} steps; shortest of {options.repeats} repeats; {os.cpu_count()} cores, "
          f"load of the machine before a run: {min(loads):.1f} to {max(loads):.1f}")
    print_table("strong: the same block", best["one"], best["strong"], n, False)
    print_table(f"weak: {n} times the block", best["one"], best["weak"], n, True)


if __name__ == "__main__":
    main()
