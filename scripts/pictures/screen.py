"""What pictures need of the machine: VTK for Python and a screen, if need be a virtual one."""

import importlib.util
import os
import shutil
import sys

NEEDED = ("apt-get install --no-install-recommends python3-vtk9 python3-numpy xvfb xauth "
          "libgl1-mesa-dri")


def fail(message):
    """Ends the script with a message that names it."""
    sys.exit("%s: %s" % (os.path.basename(sys.argv[0]), message))


def prepare():
    """Checks that VTK is there; without a screen, starts the script again in a virtual one (Xvfb)."""
    for module in ("vtk", "numpy"):
        if importlib.util.find_spec(module) is None:
            fail("%s has no module '%s'. On Debian:\n  %s" % (sys.executable, module, NEEDED))
    if "DISPLAY" in os.environ:
        return
    if shutil.which("xvfb-run") is None:
        fail("there is no screen and no xvfb-run. On Debian:\n  " + NEEDED)
    sys.stdout.flush()
    os.execvp("xvfb-run", ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", sys.executable]
              + sys.argv)
