"""One cloth on four meshes, the paper's Figure 5: the free sag and the overhang of the bending test.

Runs sag.toml and overhang.toml on cells of 10, 5, 2.5 and 1.25 mm with forces scaled by width and, for comparison, by the area of
a cell as the paper has it; prints where the tip comes to rest, draws it, and checks it against the heavy elastica and from mesh
to mesh.

    .venv/bin/python examples/mesh_independence/run.py [FOLDER] [--quick]     FOLDER: default build/mesh_independence;
                                                                             --quick: without the finest mesh
"""
import csv
import os
import subprocess
import sys
from pathlib import Path

os.environ.setdefault("MPLBACKEND", "Agg")

import numpy as np
from matplotlib import pyplot

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
CELLS = (0.01, 0.005, 0.0025, 0.00125)  # m
LENGTH = {"sag": 0.1, "overhang": 0.065}  # m: the figure's l
BETA = 9.81 * 0.065**3 / (1370e-10 / 0.03)  # m2/kg: of the overhang, per areal density
DENSITIES = (0.1, 0.12, 0.15, 0.18, 0.2)  # kg/m2
INPUTS = 'time,"pin.near.position[1]","pin.near.position[2]","pin.near.position[3]"\n0,0.05,0.1,0\n0.5,0.05,0.09,0\n'


def rest(scene, cell, scaling, folder, density=0.15):
    """Level and drop (m) of the tip at rest, and the largest strain of the warp."""
    lines = []
    for line in (HERE / f"{scene}.toml").read_text().splitlines():
        if line.startswith("cell ="):
            line = f"cell = {cell}"
        if line.startswith("areal_density ="):
            line = f"areal_density = {density}"
        if line.startswith("scaling ="):
            line = f'scaling = "{scaling}"'
        lines.append(line.replace("../fabrics", str(ROOT / "examples" / "fabrics")))
    place = folder / f"{scene}_{scaling}_{1e3 * cell:g}mm_{1e3 * density:g}g"
    place.mkdir(parents=True, exist_ok=True)
    (place / "scene.toml").write_text("\n".join(lines) + "\n")
    (place / "inputs.csv").write_text(INPUTS)
    inputs = ["--inputs", place / "inputs.csv"] if scene == "sag" else []
    subprocess.run([ROOT / "build" / "drape", "run", place / "scene.toml", "-o", place, "--every", "60", *inputs],
                   check=True, stderr=subprocess.DEVNULL)
    row = list(csv.DictReader((place / "outputs.csv").open()))[-1]
    assert float(row["fit.residual"]) <= 1e-5, f"{place.name} is not at rest"
    return np.array([float(row["probe.tip.position[2]"]), -float(row["probe.tip.position[3]"])]), float(row["strain.warp.max"])


def elastica(beta, step=1e-2):
    """Out and down of the free end over l by shooting backwards from it: with v from the end, phi'' = v sin phi, phi = pi/2
    at v = beta^(1/3); by bisection in the angle phi of the end."""

    def shoot(delta):
        v, y, n = 0.0, np.array([delta, 0.0, 0.0, 0.0]), round(beta ** (1 / 3) / step)
        h = beta ** (1 / 3) / n
        rate = lambda v, y: np.array([y[1], v * np.sin(y[0]), np.sin(y[0]), np.cos(y[0])])
        for _ in range(n):
            k1 = rate(v, y)
            k2 = rate(v + h / 2, y + h / 2 * k1)
            k3 = rate(v + h / 2, y + h / 2 * k2)
            k4 = rate(v + h, y + h * k3)
            v, y = v + h, y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        return y

    low, high = 0.0, np.pi / 2
    for _ in range(45):
        middle = (low + high) / 2
        low, high = (middle, high) if shoot(middle)[0] < np.pi / 2 else (low, middle)
    return shoot(low)[2:] / beta ** (1 / 3)


def draw(cells, tips, exact, file):
    figure, panels = pyplot.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    for panel, scene in zip(panels, LENGTH):
        finest = exact if scene == "overhang" else tips[scene, "width"][-1]
        for scaling, colour in (("width", "#1c5fc0"), ("paper_area", "#c0281c")):
            off = [100 * np.linalg.norm(tip - finest) / LENGTH[scene] or np.nan for tip in tips[scene, scaling]]
            panel.loglog(1e3 * np.array(cells), off, "o-", color=colour, label=scaling)
        panel.set(title=scene, xlabel="cell, mm", ylabel="tip off the " + ("elastica" if scene == "overhang" else "finest") + ", % of l")
        panel.set_xticks([1e3 * c for c in cells], [f"{1e3 * c:g}" for c in cells])
        panel.minorticks_off()
        panel.grid(alpha=0.3)
        panel.legend()
    figure.savefig(file, dpi=90)


def main():
    arguments = [a for a in sys.argv[1:] if a != "--quick"]
    cells = CELLS[:-1] if "--quick" in sys.argv else CELLS
    folder = Path(arguments[0]) if arguments else ROOT / "build" / "mesh_independence"
    folder.mkdir(parents=True, exist_ok=True)
    exact = 0.065 * elastica(0.15 * BETA)
    tips = {}
    for scene in LENGTH:
        print(f"{scene}: tip level and down, mm; largest strain of the warp, %")
        print("  cell, mm           width                          paper_area")
        rows = [[rest(scene, cell, scaling, folder) for scaling in ("width", "paper_area")] for cell in cells]
        for cell, row in zip(cells, rows):
            print(f"  {1e3 * cell:8g}  " + "  ".join(f"{1e3 * t[0]:9.3f} {1e3 * t[1]:9.3f} {100 * e:8.4f} " for t, e in row))
        for k, scaling in enumerate(("width", "paper_area")):
            tips[scene, scaling] = [row[k][0] for row in rows]
    print(f"  elastica  {1e3 * exact[0]:9.3f} {1e3 * exact[1]:9.3f}")
    if len(cells) == 4:
        print("overhang on cells of 2.5 mm: tip level and down, mm, beside the elastica's")
        for density in DENSITIES:
            tip, there = rest("overhang", 0.0025, "width", folder, density)[0], 0.065 * elastica(density * BETA)
            print(f"  {1e3 * density:5.0f} g/m2  " + "  ".join(f"{1e3 * a:8.3f} {1e3 * b:8.3f}" for a, b in zip(tip, there)))
            assert np.linalg.norm(tip - there) < 0.005 * 0.065, "the tip is not where the elastica ends"
    draw(cells, tips, exact, folder / "mesh_independence.png")

    for scene, length in LENGTH.items():
        tip = tips[scene, "width"]
        change = [np.linalg.norm(b - a) / length for a, b in zip(tip, tip[1:])]
        orders = [np.log2(a / b) for a, b in zip(change, change[1:])]
        print(f"{scene}: from mesh to mesh " + ", ".join(f"{100 * c:.3f}" for c in change) + " % of l, order "
              + ", ".join(f"{o:.2f}" for o in orders))
        assert change[-1] < (0.005 if len(cells) == 4 else 0.02), "the tip depends on the mesh"
        assert orders[-1] > 1.7, "the tip does not converge with order 2"
    errors = [np.linalg.norm(t - exact) / 0.065 for t in tips["overhang", "width"]]
    print("overhang: off the elastica " + ", ".join(f"{100 * e:.3f}" for e in errors) + " % of l")
    assert errors[2] < 0.005, "on cells of 2.5 mm the tip is not where the elastica ends"


if __name__ == "__main__":
    main()
