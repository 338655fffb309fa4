"""A frill is gathered to the hem of a tube: FMPy sews, and reads how far the seams are.

Packs scene.toml as an FMU, simulates it, prints gaps and lengths of the seams, draws the cloth, and checks that all seams are
closed and that the hem kept its length.

    .venv/bin/python examples/frill/run.py [FOLDER]      results go to FOLDER, default build/frill
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from sewn import sewn

SEAMS = ("tube_side", "frill_side", "gather")
HEM = 0.5  # m, the shorter side of the gathers
DRAWN = (0.0, 0.1, 0.5)  # s


def report(result):
    print("time, s   " + "   ".join(f"{seam}: gap, mm; closed" for seam in SEAMS) + "   hem, m")
    for row in result[::5]:
        states = "   ".join(
            f"{1e3 * row[f'seam.{s}.gap.max']:{len(s) + 6}.3f} {row[f'seam.{s}.closed']:10.0f}" for s in SEAMS)
        print(f"{row['time']:7.2f}   {states}   {row['seam.gather.length']:.4f}")


def check(result):
    report(result)
    end = result[-1]
    assert all(end[f"seam.{seam}.closed"] == 1 for seam in SEAMS), "a seam is open"
    assert abs(end["seam.gather.length"] / HEM - 1) < 5e-3, "the hem has not kept its length"
    print(f"all seams closed; the hem is {end['seam.gather.length']:.4f} m long, from sides of 0.5 m and 0.65 m")


if __name__ == "__main__":
    sewn(Path(__file__).resolve().parent, check, DRAWN, 0.1, [(0.36, -0.45, 0.74), (0, 0, 0.51), (0, 0, 1)], panel=(420, 420), font_size=10)
