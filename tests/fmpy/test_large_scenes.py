"""Outlines of 100,000 points are read and checked in seconds, whatever their shape and whatever is wrong with them."""
import math
import resource
import subprocess

import pytest
from scenes import HORIZONTAL, ROOT, sheet

COUNT = 100_000
SECONDS = 20  # of a processor; a release build on one of 2023 takes 1 to 3


def scene(outline):
    of = sheet(1, 1, 0.05, HORIZONTAL, duration=0.001)
    of["piece"][0] |= {"outline": outline}
    return of


def round_about(radius):
    return [[radius(k) * math.cos(2 * math.pi * k / COUNT), radius(k) * math.sin(2 * math.pi * k / COUNT)] for k in range(COUNT)]


def wave():
    """Sewn along its waves to a straight edge: the seam has as many edges."""
    of = scene([[k / COUNT, 0.02 * math.sin(30 * k / COUNT)] for k in range(COUNT)] + [[1, 1], [0, 1]])
    other = of["piece"][0] | {"name": "other", "outline": [[0, 0], [1, 0], [1, 1], [0, 1]],
                              "place": HORIZONTAL | {"origin": [0, -1.1, 1]}}
    of["piece"].append(other)
    of["seam"] = [{"name": "join", "a": {"piece": "sheet", "edges": list(range(COUNT))},
                   "b": {"piece": "other", "edges": [2], "reverse": True}}]
    return of


def star():
    """Spikes as long as the piece is wide, which nowhere touch. It holds no point at the given pin."""
    of = scene(round_about(lambda k: 0.5 if k % 2 else 0.4))
    of["piece"][0]["cell"] = 2.0
    return of


SHAPES = {
    "round": (lambda: scene(round_about(lambda k: 0.5 + 0.01 * math.sin(40 * 2 * math.pi * k / COUNT))), 0, None),
    "wave": (wave, 0, "ease"),
    "star": (star, 1, "cell = 2 m; allowed: at most the piece's shorter side"),
    "crossed star": (lambda: scene(round_about(lambda k: 0.5 * math.cos(2 * math.pi * (k * 0.3819)))), 1, "is no simple outline: edge "),
    "one point": (lambda: scene([[0, 0], [1, 0]] + [[1, 1]] * COUNT), 1, "repeats point "),
}


@pytest.mark.parametrize("name", SHAPES)
def test_outline_of_many_points(write, name):
    make, code, words = SHAPES[name]
    file = write(make())
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([ROOT / "build" / "drape", "check", file], capture_output=True, text=True, timeout=10 * SECONDS)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    assert done.returncode == code, done.stderr[:1000]
    assert words is None or words in done.stdout + done.stderr
    assert after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime < SECONDS
