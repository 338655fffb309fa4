"""A strip is pulled round a bollard: how the tension grows with the angle, node by node.

At a node where the thread turns by D and the cloth slides, the pull T1 behind, T2 ahead and the bollard's N and mu N balance:

    T2 cos(D/2) - T1 cos(D/2) = mu N,   (T1 + T2) sin(D/2) = N      so      T2/T1 = (1 + mu tan(D/2))/(1 - mu tan(D/2)),

which goes to Euler and Eytelwein's e^(mu D) as the cells become small.

    .venv/bin/python examples/capstan/run.py [FOLDER]      results go to FOLDER, default build/capstan
"""
import math
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from look import picture
from stage import ROOT, cylinder, drape, mesh_write, opened, scene_put

HERE = Path(__file__).resolve().parent
MU, RADIUS, CELL, CELLS, SIDES = 0.3, 0.0505, 0.005, 16, 720
STEP, STEPS, MEASURED = 1e-3, 300, 100  # s; of the steps, the last are measured: the strip sings as it slides
PULL = 0.002 * CELL  # m a step
SLIDING = range(3, 13)  # nodes along the strip that slide


def pulled(unit):
    """Means over the last steps of the tension in every cell (as strain), and of the turn at every node."""
    angle = CELLS * CELL / 2 / RADIUS
    start, along = unit.vector("pin.pulled.position"), np.array([math.cos(angle), 0, -math.sin(angle)])
    strain, turn, ends = np.zeros(CELLS), np.zeros(CELLS + 1), np.zeros(2)
    for k in range(1, STEPS + 1):
        unit.set({"pin.pulled.position": start + PULL * k * along})
        unit.step(STEP)
        if k <= STEPS - MEASURED:
            continue
        link = np.diff(unit.nodes("node.position")[:CELLS + 1], axis=0)  # the first of the two threads
        length = np.linalg.norm(link, axis=1)
        strain += (length / CELL - 1) / MEASURED
        turn[1:-1] += np.arccos(np.einsum("ij,ij->i", link[1:], link[:-1]) / (length[1:] * length[:-1])) / MEASURED
        ends += [np.linalg.norm(unit.vector(f"pin.{end}.force")) / MEASURED for end in ("held", "pulled")]
    return strain, turn, ends


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build" / "capstan"
    scene = scene_put(folder, HERE / "scene.toml")
    mesh_write(folder / "bollard.obj", *cylinder(0.05, 0.1, SIDES))
    drape("pack", scene, "-o", folder / "capstan.fmu", "--nodes", "all")
    with opened(folder / "capstan.fmu") as unit:
        strain, turn, (held, tugged) = pulled(unit)

    print("node   turn, degrees   T2/T1     formula    e^(mu D)")
    worst = 0.0
    for k in SLIDING:
        t, ratio = MU * math.tan(turn[k] / 2), strain[k] / strain[k - 1]
        formula = (1 + t) / (1 - t)
        worst = max(worst, abs(ratio / formula - 1))
        print(f"{k:4d} {math.degrees(turn[k]):15.3f} {ratio:9.5f} {formula:11.5f} {math.exp(MU * turn[k]):11.5f}")
    print(f"\nheld with {held:.4f} N, pulled with {tugged:.4f} N; worst of the nodes {worst:.1e} off the formula")
    draw(scene, folder)
    # The normals of 720 facets are off by up to pi/1440 from those of the round bollard; the ratio by twice that times tan(D/2).
    assert worst < 1e-3, "the tension grows otherwise"


def draw(scene, folder):
    table = folder / "pull.csv"
    angle = CELLS * CELL / 2 / RADIUS
    start = RADIUS * np.array([math.sin(angle), 0, math.cos(angle)]) + [0, CELL / 2, 0]
    end = start + PULL * STEPS * np.array([math.cos(angle), 0, -math.sin(angle)])
    rows = [[0.0, *start], [STEP * STEPS, *end]]
    table.write_text("time," + ",".join(f"pin.pulled.position[{k}]" for k in (1, 2, 3)) + "\n"
                     + "".join(",".join(map(repr, map(float, row))) + "\n" for row in rows))
    drape("run", scene, "-o", folder / "run", "--until", 0.3, "--every", 0.1, "--frames", "--inputs", table)
    picture(folder / "run", folder / "capstan.png", field="tension_weft", views=[(0.3, -1.0, 0.45)], up="z", margin=0.12, limits=(35, 85))


if __name__ == "__main__":
    main()
