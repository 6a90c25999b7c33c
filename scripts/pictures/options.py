"""Options that the scripts have in common."""


def add_view_options(parser):
    """What is shown and from where."""
    parser.add_argument("--box", nargs="+", type=float, metavar="X",
                        help="what to show: lower corner and upper corner [m] "
                        "(default: magnets and particles of the first run's first frame and all "
                        "others that did not fly away)")
    parser.add_argument("--from", dest="direction", nargs=3, type=float, default=None,
                        metavar=("X", "Y", "Z"), help="where the eye is, seen from the middle")
    parser.add_argument("--magnet", nargs="+", type=float, action="append", default=[],
                        metavar="X", help="one more grey sphere: centre and radius [m]")
    parser.add_argument("--palette", action="store_true",
                        help="write at most 256 colours, a quarter of the bytes (python3-pil)")


def add_body_options(parser):
    """How the bodies look."""
    parser.add_argument("--colour", metavar="NAME",
                        help="quantity, a vector by its length: velocity (default of particles), J, "
                        "magnetization, von_mises_stress, body, or none: a colour for each body "
                        "(default of surfaces)")
    parser.add_argument("--range", nargs=2, type=float, metavar=("MIN", "MAX"),
                        help="of the colours (default: that of the shown frames, speeds from 0)")
    parser.add_argument("--surface", action="store_true",
                        help="smooth surfaces in light and shade instead of particles: those of "
                        "surface.pvd, or, where the run wrote none, found from the particles")
    parser.add_argument("--diameter", type=float,
                        help="of a particle [m] (default: the particle spacing of the first frame)")
    parser.add_argument("--titles", nargs="+", metavar="TEXT", default=[], help="one a run")
