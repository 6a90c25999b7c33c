#!/usr/bin/env python3
"""Draws what newton_convergence wrote: the relative residual against the step of Newton's method.

plot_newton_convergence.py [newton_convergence.csv] [newton_convergence.svg]

The picture may be a PNG or SVG. A table of scenes makes one panel, with a line for each scene.
"""

import csv
import sys
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLOURS = ["tab:blue", "tab:orange", "tab:red", "tab:purple"]
STYLES = {"paper": ("o--", "paper's scheme"), "magmpm": ("s-", "magmpm")}


def is_table_of_scenes(path):
    with open(path, encoding="utf-8") as table:
        return table.readline().startswith("scene,")


def read_scenes(path):
    """{scene: [(step, residual), ...]}"""
    curves = defaultdict(list)
    with open(path, newline="") as table:
        for row in csv.DictReader(table):
            curves[row["scene"]].append((int(row["step"]), float(row["relative_residual"])))
    return curves


def draw_scenes(curves, path):
    figure, panel = plt.subplots(figsize=(6.5, 4.2))
    markers = "osv^D<>pXP*h"
    for i, (scene, points) in enumerate(sorted(curves.items())):
        panel.semilogy(*zip(*points), marker=markers[i % len(markers)], markersize=4, label=scene)
    panel.axhline(1e-10, color="grey", linestyle=":")
    finish(panel)
    panel.legend(fontsize=6, ncol=2)
    panel.set_ylabel("residual, relative to zero potential")
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def finish(panel):
    panel.set_xlabel("Newton step")
    panel.xaxis.get_major_locator().set_params(integer=True)
    panel.grid(alpha=0.3)


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
        finish(panel)
        panel.legend(fontsize=7)
    panels[0][0].set_ylabel("residual, relative to zero potential")
    figure.tight_layout()
    figure.savefig(path)


if __name__ == "__main__":
    source = sys.argv[1] if len(sys.argv) > 1 else "newton_convergence.csv"
    target = sys.argv[2] if len(sys.argv) > 2 else "newton_convergence.svg"
    if is_table_of_scenes(source):
        draw_scenes(read_scenes(source), target)
    else:
        draw(read(source), target)
