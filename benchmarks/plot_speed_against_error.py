#!/usr/bin/env python3
"""Draws what speed_against_error wrote: error of moment and force against time.

plot_speed_against_error.py [speed_against_error.csv] [speed_against_error.png] [cold|warm]
"""

import csv
import math
import sys
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

PANELS = [
    ("sphere in a uniform field", "moment_error", "moment of a sphere"),
    ("sphere near a dipole", "force_error", "force of a dipole on a sphere"),
]
LINES = {"magmpm": "-", "paper": "--", "paper with open faces": ":"}
MARKERS = "osv^D<>pX*hP"


def read(path):
    """{scene: {(scheme, contender): [row, ...]}}, in the order of the file."""
    scenes = defaultdict(lambda: defaultdict(list))
    with open(path, newline="") as table:
        for row in csv.DictReader(table):
            scenes[row["scene"]][row["scheme"], row["contender"]].append(row)
    return scenes


def draw_panel(panel, contenders, column, seconds):
    for number, ((scheme, name), rows) in enumerate(contenders.items()):
        points = [(float(row[seconds]), 100.0 * float(row[column])) for row in rows]
        points = [point for point in points if all(map(math.isfinite, point))]
        panel.loglog(
            *zip(*points),
            LINES[scheme] + MARKERS[number % len(MARKERS)],
            color=plt.get_cmap("tab20")(number % 20),
            markersize=4,
            linewidth=1.2,
            label=f"magmpm: {name}" if scheme == "magmpm" else name,
        )
    for percent in (1.0, 3.0):
        panel.axhline(percent, color="gray", linewidth=0.7, linestyle=":")
    panel.set_ylabel("error (rms over places) [%]")
    panel.grid(alpha=0.3, which="both", linewidth=0.4)


def draw(scenes, path, start):
    panels = [panel for panel in PANELS if panel[0] in scenes]
    figure, axes = plt.subplots(1, len(panels), figsize=(5.2 * len(panels), 5.2), squeeze=False)
    for panel, (scene, column, title) in zip(axes[0], panels):
        draw_panel(panel, scenes[scene], column, f"{start}_seconds")
        panel.set_title(title)
        panel.set_xlabel(f"seconds of a {'first' if start == 'cold' else 'later'} frame, one core")
    handles, labels = axes[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=4, fontsize=7)
    figure.tight_layout(rect=(0, 0.16, 1, 1))
    figure.savefig(path, dpi=110)


if __name__ == "__main__":
    source = sys.argv[1] if len(sys.argv) > 1 else "speed_against_error.csv"
    target = sys.argv[2] if len(sys.argv) > 2 else "speed_against_error.png"
    draw(read(source), target, sys.argv[3] if len(sys.argv) > 3 else "warm")
