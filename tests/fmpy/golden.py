"""A cloth that every stage of the kernel moves, and the hash of where it ends: the same in every build, on every platform.

Its scene needs no function of the mathematical library but the square root, which all libraries round alike.
"""
import hashlib
import struct

from scenes import HORIZONTAL, pin_points, sheet

STEPS, LENGTH = 20, 1e-4  # communication steps, s
HASH = "94c29173fa1e3c152e5d7a04080f3659d5eaaf5196333d828a339817b74dd174"

# Of its own: the shipped fabrics may be measured or smoothed again.
FABRIC = {
    "areal_density": 0.15, "thickness": 5e-4, "damping": 1e-6, "strip": {"width": 0.05, "gauge": 0.1},
    "bending": {"rigidity_uN_cm2": [1370, 1100], "width": 0.03},
    "warp": {"elongation_percent": [0, 0.3, 0.6, 1, 1.5], "force": [0, 2, 11, 60, 160]},
    "weft": {"elongation_percent": [0, 2, 4, 7, 10], "force": [0, 1, 4, 15, 40]},
    "bias": {"elongation_percent": [0, 3, 6, 10], "force": [0, 1, 3, 8]},
}


def golden_sheet():
    """A sheet with a slanted side and a slit, in wind, damped along its springs; 20 time steps in each communication step."""
    scene = sheet(0.12, 0.1, 0.005, HORIZONTAL, step=5e-6, communication=LENGTH, wind=[3.0, 1.0, 2.0])
    scene["piece"][0]["outline"] = [[0, 0], [0.12, 0], [0.09, 0.1], [0.061, 0.1], [0.06, 0.03], [0.059, 0.1], [0, 0.1]]
    scene["fabric"]["wool"] = FABRIC
    scene["air"] = {"normal": 1.2, "tangential": 0.1}
    pin_points(scene, "left", (0, 0.1))
    return scene


def hash_of(values):
    return hashlib.sha256(struct.pack(f"<{len(values)}d", *values)).hexdigest()
