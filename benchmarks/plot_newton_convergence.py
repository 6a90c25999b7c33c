#!/usr/bin/env python3
"""Draws what newton_convergence wrote: the relative residual against the step of Newton's method.

plot_newton_convergence.py [newton_convergence.csv] [newton_convergence.svg]
"""

import csv
import sys
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLOURS = ["tab:blue", "tab:orange", "tab:red", "tab:purple"]
STYLES = {"paper": ("o--", "paper's scheme"), "magmpm": ("s-", "magmpm")}


def read(path):
    """{chi_0: {(a, scheme): [(step, residual), ...]}}"""
    curves = defaultdict(lambda: defaultdict(list))
    with open(path, newline="") as table:
        for row in csv.DictReader(table):
            curve = curves[float(row["susceptibility"])][float(row["argument"]), row["scheme"]]
            curve.append((int(row["step"]), float(row["relative_residual"])))
    return curves


def draw(curves, path):
    figure, panels = plt.subplots(
        1, len(curves), figsize=(4.5 * len(curves), 3.6), sharey=True, squeeze=False
    )
    for panel, (susceptibility, lines) in zip(panels[0], sorted(curves.items())):
        arguments = sorted({a for a, _ in lines})
        for (a, scheme), points in sorted(lines.items()):
            style, label = STYLES[scheme]
            panel.semilogy(
                *zip(*points),
                style,
                color=COLOURS[arguments.index(a) % len(COLOURS)],
                markersize=4,
                label=f"{label}, a = {a:g}",
            )
        panel.set_title(rf"$\chi_0$ = {susceptibility:g}")
        panel.set_xlabel("Newton step")
        panel.xaxis.get_major_locator().set_params(integer=True)
        panel.grid(alpha=0.3)
        panel.legend(fontsize=7)
    panels[0][0].set_ylabel("residual, relative to zero potential")
    figure.tight_layout()
    figure.savefig(path)


if __name__ == "__main__":
    source = sys.argv[1] if len(sys.argv) > 1 else "newton_convergence.csv"
    target = sys.argv[2] if len(sys.argv) > 2 else "newton_convergence.svg"
    draw(read(source), target)
