"""A cap sleeve set into an armhole: a closed seam with ease, where three pieces meet in a point.

Packs scene.toml, simulates it with FMPy, prints how far its five seams are, draws three moments, and checks that all are closed
and that the ring of the armhole kept its length.

    .venv/bin/python examples/sleeve/run.py [FOLDER]      results go to FOLDER, default build/sleeve
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from sewn import sewn

SEAMS = ("shoulder", "side", "underarm", "armhole_front", "armhole_back")
ARMHOLE, EASE = 2 * 0.174175, 1.084  # m, both edges of the armhole (drape check); of the cap over them
DRAWN = (0.0, 0.1, 1.2)  # s
EVERY = 0.1              # s


def armhole(row):
    return row["seam.armhole_front.length"] + row["seam.armhole_back.length"]


def check(result):
    print("time, s   largest gap of each seam, mm; * closed" + " " * 24 + "armhole, m")
    for row in result[::3]:
        gaps = "  ".join(f"{s} {1e3 * row[f'seam.{s}.gap.max']:.3f}{'*' if row[f'seam.{s}.closed'] else ''}" for s in SEAMS)
        print(f"{row['time']:7.2f}   {gaps}   {armhole(row):.4f}")
    end = result[-1]
    for s in SEAMS:
        assert end[f"seam.{s}.closed"] == 1, f"the seam {s} is open"
    assert abs(armhole(end) / ARMHOLE - 1) < 5e-3, "the armhole has not kept its length"
    print(f"all seams closed; the armhole is {armhole(end):.4f} m long, of edges of {ARMHOLE:.4f} m and a cap {EASE} times as long")


if __name__ == "__main__":
    sewn(Path(__file__).resolve().parent, check, DRAWN, EVERY, [(0.72, -0.78, 0.52), (0.14, 0, 0.17), (0, 0, 1)])
