"""A cloth that every stage of the kernel moves, and the hash of where it ends: the same in every build, on every platform.

Its scene needs no function of the mathematical library but the square root, which all libraries round alike.
"""
import hashlib
import struct

from scenes import HORIZONTAL, pin_points, sheet

STEPS, LENGTH = 20, 1e-4  # communication steps, s
HASH = "8866b2a409cd8fdc1949b17d7be237f72e08f8e0c8228a45fd4a07cf5809b0ec"


def golden_sheet():
    """A sheet with a slanted side and a slit, in wind, damped along its springs; 20 time steps in each communication step."""
    scene = sheet(0.12, 0.1, 0.005, HORIZONTAL, step=5e-6, communication=LENGTH, wind=[3.0, 1.0, 2.0])
    scene["piece"][0]["outline"] = [[0, 0], [0.12, 0], [0.09, 0.1], [0.061, 0.1], [0.06, 0.03], [0.059, 0.1], [0, 0.1]]
    scene["fabric"]["wool"]["damping"] = 1e-6
    scene["air"] = {"normal": 1.2, "tangential": 0.1}
    pin_points(scene, "left", (0, 0.1))
    return scene


def hash_of(values):
    return hashlib.sha256(struct.pack(f"<{len(values)}d", *values)).hexdigest()
