"""A piece sewn to itself: a bent rectangle becomes a round tube.

Packs scene.toml, simulates it with FMPy, prints gap and diameters, draws three moments, and checks the shape: a sheet of width w
that bends across its seam as it does elsewhere has its least energy, 2 pi^2 B/w per length, as a ring of the radius w/(2 pi).

    .venv/bin/python examples/tube/run.py [FOLDER]      results go to FOLDER, default build/tube
"""
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from sewn import sewn

DRAWN = (0.0, 0.05, 1.5)  # s
EVERY = 0.05              # s
WIDTH, HEIGHT = 0.25, 0.1  # m


def distance(row, one, other):
    return math.dist(*([row[f"probe.{probe}.position[{k}]"] for k in (1, 2, 3)] for probe in (one, other)))


def check(result):
    print("time, s   gap, mm   closed   diameters, mm")
    for row in result[::3]:
        diameters = [1e3 * distance(row, *ends) for ends in (("front", "back"), ("left", "right"))]
        print(f"{row['time']:7.2f} {1e3 * row['seam.side.gap.max']:9.4f} {row['seam.side.closed']:8.0f} "
              + " ".join(f"{d:8.2f}" for d in diameters))
    end = result[-1]
    assert end["seam.side.closed"] == 1 and end["seam.side.gap.max"] < 1e-12, "the seam is open"
    assert abs(end["seam.side.length"] / HEIGHT - 1) < 5e-3, "the seam has not kept its length"
    for ends in (("front", "back"), ("left", "right")):
        ratio = distance(end, *ends) / (WIDTH / math.pi)
        assert abs(ratio - 1) < 5e-3, f"the tube is not round: {'-'.join(ends)} is {ratio:.3f} of the diameter"
    print(f"closed and round: w/pi is {1e3 * WIDTH / math.pi:.2f} mm")


if __name__ == "__main__":
    sewn(Path(__file__).resolve().parent, check, DRAWN, EVERY, [(0.02, -0.28, 0.24), (0, 0, 0.05), (0, 0, 1)], panel=(300, 330))
