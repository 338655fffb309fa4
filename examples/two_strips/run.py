"""Two strips with cells of 10 and 14 mm, sewn together: the paper's Figure 7 as an FMU.

Packs scene.toml, simulates it with FMPy, prints gap and state of the seam, draws three moments, and checks what a seam must do:
the strips hang from the bar with their whole weight, as long as their warp stretches to, and straight.

    .venv/bin/python examples/two_strips/run.py [FOLDER]      results go to FOLDER, default build/two_strips
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from sewn import sewn

DRAWN = (0.0, 0.05, 1.5)  # s
EVERY = 0.05              # s
WIDTH, HEIGHT, BAR = 0.1, 0.24, 0.28  # m: of both strips sewn together; of the bar above the ground
WEIGHT = 0.2 * WIDTH * HEIGHT * 9.81  # N


def check(result):
    print("time, s   gap, mm   closed   length, m   pull on the bar, N")
    for row in result[::3]:
        print(f"{row['time']:7.2f} {1e3 * row['seam.join.gap.max']:9.4f} {row['seam.join.closed']:8.0f} "
              f"{row['seam.join.length']:11.5f} {-row['pin.bar.force[3]']:12.5f}")
    end = result[-1]
    pull, length = -end["pin.bar.force[3]"], end["seam.join.length"]
    assert end["seam.join.closed"] == 1 and end["seam.join.gap.max"] < 1e-12, "the seam is open"
    assert abs(length / WIDTH - 1) < 5e-3, "the seam has not kept its length"
    assert abs(pull / WEIGHT - 1) < 5e-3, "the bar does not carry the weight of both strips"
    for corner in ("left", "right"):
        drop = BAR - end[f"probe.{corner}.position[3]"]
        assert abs(drop / HEIGHT - 1) < 2e-3, f"the {corner} corner of the hem is not where it hangs straight"
    print(f"closed; {length:.5f} m of {WIDTH} m; the bar carries {pull:.5f} N of {WEIGHT:.5f} N")


if __name__ == "__main__":
    sewn(Path(__file__).resolve().parent, check, DRAWN, EVERY, [(0.36, -0.52, 0.28), (0.055, 0, 0.155), (0, 0, 1)], edge_color="#4a3316", line_width=1.2)
