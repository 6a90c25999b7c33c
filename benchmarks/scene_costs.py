#!/usr/bin/env python3
"""What runs of scenes cost: a line of a Markdown table for each output folder.

scene_costs.py OUTPUT [OUTPUT...] [--paper NAME=ALL/MAGNETIC]...

Particles, unknowns of the potential (the most of the run), frames, seconds per frame of all and of
the magnetic part (potential and force), Newton iterations per solve (mean and most) and the largest
residual that a solve left, relative to zero potential. All of it is read from statistics.csv and
log.txt of the runs. With the paper's seconds per frame, as in --paper cube_nonlinear=48.6/19.6,
the ratio to it follows.
"""

import argparse
import csv
import os
import re
import sys

MAGNETIC = "wall time: Solve potential [s]"


def read_log(folder):
    """Frames that were completed, and the wall time of the run [s]."""
    with open(os.path.join(folder, "log.txt"), encoding="utf-8") as file:
        log = file.read()
    frames = re.findall(r"^frame +(\d+)/", log, re.MULTILINE)
    total = re.findall(r"Total wallclock time elapsed[ |]*([0-9.e+]+)s", log)
    if not frames or not total:
        sys.exit("scene_costs: the log of '%s' has no frame or no end: has the run ended?" % folder)
    # A resumed run has one table for each part.
    return int(frames[-1]), sum(float(seconds) for seconds in total)


def read_statistics(folder):
    with open(os.path.join(folder, "statistics.csv"), newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def line_of(folder, paper):
    rows = read_statistics(folder)
    n_frames, seconds = read_log(folder)
    solves = [row for row in rows if int(float(row["Newton steps"])) > 0]
    newton = [int(float(row["Newton steps"])) for row in solves]
    residual = max((float(row["Newton residual [-]"]) for row in solves), default=0.0)
    magnetic = sum(float(row[MAGNETIC]) for row in rows) / n_frames
    name = os.path.basename(os.path.normpath(folder)).replace("output-", "", 1)
    cells = [name, "{:,}".format(int(float(rows[0]["particles"]))),
             "{:,}".format(max(int(float(row["potential unknowns"])) for row in rows)),
             str(n_frames), "%.2f" % (seconds / n_frames), "%.2f" % magnetic,
             "%.1f (%d)" % (sum(newton) / len(newton), max(newton)) if newton else "-",
             "%.0e" % residual if newton else "-"]
    theirs = paper.get(name)
    cells += ["%g, %g" % theirs, "%.0f" % (theirs[0] * n_frames / seconds)] if theirs else ["", ""]
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", help="output folders of runs that have ended")
    parser.add_argument("--paper", action="append", default=[], metavar="NAME=ALL/MAGNETIC",
                        help="seconds per frame that the paper tells")
    options = parser.parse_args()
    paper = {}
    for text in options.paper:
        name, numbers = text.split("=")
        paper[name] = tuple(float(number) for number in numbers.split("/"))
    print("| scene | particles | unknowns | frames | s per frame: all | magnetic | Newton: mean (most)"
          " | residual | paper: all, magnetic | ratio |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    for folder in options.folders:
        print(line_of(folder, paper))


if __name__ == "__main__":
    main()
