"""Programs to compare: building them, and running scenes with them."""

import hashlib
import os
import shutil
import subprocess
import time


class Failure(Exception):
    """What keeps programs from being compared."""


def call(command, **options):
    try:
        return subprocess.run(command, check=True, capture_output=True, text=True, **options).stdout
    except subprocess.CalledProcessError as error:
        raise Failure("'%s' failed:\n%s" % (" ".join(command),
                                            "\n".join((error.stdout + error.stderr)
                                                      .splitlines()[-20:]))) from error


def build(root):
    """Builds magmpm in a source folder, in the way of that source. Returns the program."""
    print("building magmpm in %s (minutes, if ccache does not know it)" % root, flush=True)
    # scripts/setup sets it, too, but did not always: old commits share their objects with new ones.
    call([os.path.join(root, "scripts", "setup"), "magmpm"],
         env=dict(os.environ, CCACHE_BASEDIR=root))
    return os.path.join(root, "build", "magmpm")


def build_commit(root, commit, folder):
    """Builds a commit in a worktree of its own, or takes the one that is there."""
    sha = call(["git", "-C", root, "rev-parse", "--verify", "--short=12",
                commit + "^{commit}"]).strip()
    worktree = os.path.join(folder, sha)
    if not os.path.exists(os.path.join(worktree, "scripts", "setup")):
        call(["git", "-C", root, "worktree", "prune"])
        call(["git", "-C", root, "worktree", "add", "--force", "--detach", worktree, sha])
    return build(worktree)


def environment():
    """As scripts/run sets it: also as root, and with more ranks than cores."""
    return dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_orte_execute_quiet="1",
                OMPI_MCA_mpi_yield_when_idle="1", OMP_NUM_THREADS="1")


class Program:
    """A magmpm, and what it writes of scenes, in a folder for each program."""

    def __init__(self, file, folder):
        if not os.path.isfile(file):
            raise Failure("there is no program '%s'" % file)
        self.file = os.path.abspath(file)
        with open(file, "rb") as stream:
            digest = hashlib.sha1(stream.read()).hexdigest()[:12]
        self.folder = os.path.join(folder, "runs", digest)

    def results(self, scene):
        """The output folder of a scene; if this very program has run it already, of that run."""
        kept = os.path.join(self.folder, "%s-%s" % (scene.name, scene.digest))
        if not os.path.exists(kept):
            folder = self.run(scene)
            os.makedirs(self.folder, exist_ok=True)
            if not os.path.exists(kept):
                os.rename(folder, kept)
        return kept

    def run(self, scene, overrides=()):
        """Runs a scene, in parts if it is resumed. Returns the output folder."""
        output = os.path.join(self.folder, "%s.%d" % (scene.name, os.getpid()))
        shutil.rmtree(output, ignore_errors=True)
        parts = [[]]
        if scene.resumed_at is not None:
            parts = [["--set", "End time=" + scene.resumed_at], ["--resume"]]
        for part in parts:
            command = [self.file, scene.file, "--set", "Output directory=" + output] + part
            for override in overrides:
                command += ["--set", override]
            if scene.ranks > 1:
                command = ["mpirun", "-np", str(scene.ranks)] + command
            start = time.time()
            outcome = subprocess.run(command, capture_output=True, text=True, env=environment())
            scene.seconds += time.time() - start
            if outcome.returncode != 0:
                raise Failure("%s fails with exit code %d:\n%s"
                              % (" ".join(command), outcome.returncode,
                                 "\n".join((outcome.stdout + outcome.stderr).splitlines()[-8:])))
        return output
