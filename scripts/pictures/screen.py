"""What pictures need of the machine: VTK for Python and a screen, if need be a virtual one."""

import atexit
import ctypes
import importlib.util
import os
import shutil
import signal
import subprocess
import sys

NEEDED = "apt-get install --no-install-recommends python3-vtk9 python3-numpy xvfb libgl1-mesa-dri"


def fail(message):
    """Ends the script with a message that names it."""
    sys.exit("%s: %s" % (os.path.basename(sys.argv[0]), message))


def prepare():
    """Checks that VTK is there; without a screen, starts a virtual one (Xvfb)."""
    for module in ("vtk", "numpy"):
        if importlib.util.find_spec(module) is None:
            fail("%s has no module '%s'. On Debian:\n  %s" % (sys.executable, module, NEEDED))
    if "DISPLAY" in os.environ:
        return
    if shutil.which("Xvfb") is None:
        fail("there is no screen and no Xvfb. On Debian:\n  " + NEEDED)
    os.environ["DISPLAY"] = start_virtual_screen()


def start_virtual_screen():
    """
    The name of the display of an Xvfb that ends with this script, whatever ends it.

    VTK opens and closes the display more than once. By default, and so in xvfb-run, the server
    starts anew when its last client leaves, and refuses one that comes at that moment.
    """
    number, number_in = os.pipe()

    def end_with_parent():
        ctypes.CDLL(None).prctl(1, signal.SIGTERM) # PR_SET_PDEATHSIG

    server = subprocess.Popen(["Xvfb", "-displayfd", str(number_in), "-screen", "0",
                               "1280x1024x24", "-noreset", "-nolisten", "tcp"],
                              pass_fds=[number_in], preexec_fn=end_with_parent,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    atexit.register(server.wait)
    atexit.register(server.terminate)
    os.close(number_in)
    with os.fdopen(number) as answer:
        display = answer.readline().strip()
    if not display:
        fail("the virtual screen, Xvfb, did not start.")
    return ":" + display
