"""The frames of two runs: what their .pvd name, array by array."""

import array
import math
import os
import re
import struct
import xml.etree.ElementTree
import zlib

from comparison.statistics import Report

# Frames hold single precision.
TOLERANCE = 1e-6

TYPES = {"Float32": "f", "Float64": "d", "Int8": "b", "UInt8": "B", "Int32": "i", "UInt32": "I",
         "Int64": "q", "UInt64": "Q"}


def record(path):
    """Time and file of each data set that a .pvd names."""
    return [(float(entry.get("timestep")), entry.get("file"))
            for entry in xml.etree.ElementTree.parse(path).getroot().iter("DataSet")]


def pieces(path):
    """The files with data: those that a .pvtu names, or the file itself."""
    if not path.endswith(".pvtu"):
        return [path]
    return [os.path.join(os.path.dirname(path), piece.get("Source"))
            for piece in xml.etree.ElementTree.parse(path).getroot().iter("Piece")]


def unpacked(data, start, header, is_compressed):
    """The bytes of an array that begins here: as they are, or in blocks compressed by zlib."""
    def numbers(position, n):
        return struct.unpack_from("<%d%s" % (n, header), data, position)
    width = struct.calcsize(header)
    if not is_compressed:
        return data[start + width:start + width + numbers(start, 1)[0]]
    n_blocks = numbers(start, 1)[0]
    position = start + (3 + n_blocks) * width
    blocks = []
    for size in numbers(start + 3 * width, n_blocks):
        blocks.append(zlib.decompress(data[position:position + size]))
        position += size
    return b"".join(blocks)


def arrays(path):
    """The appended arrays of a VTK file by section and name, those of all pieces one after the other."""
    with open(path, "rb") as file:
        content = file.read()
    head, data = content.split(b'<AppendedData encoding="raw">', 1)
    data = data[data.index(b"_") + 1:]
    text = head.decode()
    header = TYPES[re.search(r'header_type="(\w+)"', text).group(1)]
    is_compressed = "vtkZLibDataCompressor" in text
    found, section = {}, ""
    for tag, attributes in re.findall(r"<(\w+)([^>]*)>", text):
        if tag != "DataArray":
            section = tag
            continue
        values = dict(re.findall(r'(\w+)="([^"]*)"', attributes))
        if "offset" not in values:
            continue
        numbers = array.array(TYPES[values["type"]],
                              unpacked(data, int(values["offset"]), header, is_compressed))
        found.setdefault((section, values["Name"]), array.array(numbers.typecode)).extend(numbers)
    return found


def difference_of(one, other):
    """Of the largest number; infinite if there are not as many."""
    if one == other:
        return 0.0
    if len(one) != len(other):
        return math.inf
    size = max(abs(value) for value in one)
    difference = max(abs(a - b) for a, b in zip(one, other))
    return difference / size if size > 0 else math.inf


def compare_files(name, old, new, worst):
    """Compares two files; sets the worst difference by the name of an array."""
    for one, other in zip(pieces(old), pieces(new)):
        if not os.path.exists(other):
            worst["%s: %s is missing" % (name, os.path.basename(other))] = math.inf
            continue
        there, here = arrays(one), arrays(other)
        for key, numbers in there.items():
            label = "%s: %s" % (name, key[1])
            difference = difference_of(numbers, here[key]) if key in here else math.inf
            worst[label] = max(worst.get(label, 0.0), difference)


def compare(old, new):
    """A statistics.Report on the frames of two output folders."""
    worst = {}
    n_frames = 0
    for name in sorted(file for file in os.listdir(old) if file.endswith(".pvd")):
        here = record(os.path.join(new, name)) if os.path.exists(os.path.join(new, name)) else []
        there = record(os.path.join(old, name))
        if [frame[0] for frame in here] != [frame[0] for frame in there]:
            worst["%s: times of frames" % name] = math.inf
            continue
        n_frames += len(there)
        for (_, one), (_, other) in zip(there, here):
            compare_files(name, os.path.join(old, one), os.path.join(new, other), worst)
    report = Report("; %d frames%s" % (n_frames, "" if not any(worst.values()) else
                                       ", worst: %s %.1e" % max(worst.items(), key=lambda w: w[1])))
    for label, difference in worst.items():
        if difference > TOLERANCE:
            report.difference("%s: %.1e" % (label, difference))
    return report
