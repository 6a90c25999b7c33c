"""The scenes of tests/comparison: parameter files whose first comment says how they are run."""

import glob
import hashlib
import os
import re


class Scene:
    """A parameter file. In its comment, 'Ranks: 2', 'Resumed at: 0.01' (the end of a first part) and
    'Shows: a column > 5, another > 0' (else it would prove nothing) count."""

    def __init__(self, file):
        self.file = file
        self.name = os.path.splitext(os.path.basename(file))[0]
        with open(file, encoding="utf-8") as stream:
            text = stream.read()
        self.ranks = int(self.notes(text, "Ranks")[0])
        self.resumed_at = next(iter(self.notes(text, "Resumed at")), None)
        self.shows = [part.strip() for line in self.notes(text, "Shows") for part in line.split(",")]
        self.digest = self.digest_of(text)
        self.seconds = 0.0

    @staticmethod
    def notes(text, keyword):
        return re.findall(r"^# %s: (.*)$" % keyword, text, re.MULTILINE)

    def digest_of(self, text):
        """Of the file and of what lies beside it, which it may name."""
        digest = hashlib.sha1(text.encode())
        for file in sorted(glob.glob(os.path.join(os.path.dirname(self.file), "*"))):
            if not file.endswith(".prm"):
                with open(file, "rb") as stream:
                    digest.update(stream.read())
        return digest.hexdigest()[:12]

    def not_shown(self, table):
        """The first of what the scene should show that its rows do not show; None if they all do."""
        if not 2 <= table.n_rows <= 100:
            return "2 to 100 rows"
        for shown in self.shows:
            heading, limit = shown.rsplit(" > ", 1)
            if max(abs(float(value)) for value in table.columns[heading]) <= float(limit):
                return shown
        return None


def read_all(folder):
    """Scenes by name."""
    return {scene.name: scene
            for scene in map(Scene, sorted(glob.glob(os.path.join(folder, "*.prm"))))}
