"""Drape on the peers' cloth: where it ends, and how fast it is."""
import csv
import pathlib
import subprocess
import tempfile

import numpy as np

from cloth import BEND_WARP, BEND_WEFT, BIAS, CELL, DENSITY, GRAVITY, STEP, WARP, WEFT

DRAPE = pathlib.Path(__file__).resolve().parents[3] / "build" / "drape"

SCENE = """[scene]
name = "peers"
duration = {duration}
step = {step}
communication = {step}
gravity = [0, 0, {gravity}]
[options]
clamp_correction = false
[fabric.f]
areal_density = {density}
thickness = 5e-4
warp = {{ elongation_percent = [0, 10], force = [0, {warp}] }}
weft = {{ elongation_percent = [0, 10], force = [0, {weft}] }}
bias = {{ elongation_percent = [0, 10], force = [0, {bias}], correction = [1, 1] }}
{bending}
[[piece]]
name = "sheet"
fabric = "f"
cell = {cell}
outline = [[0, 0], [{side}, 0], [{side}, {side}], [0, {side}]]
[[pin]]
name = "bar"
piece = "sheet"
edges = [2]
"""


def drape_places(n, hinges, steps):
    """Places of the particles of a cloth that hangs from its last row."""
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "scene.toml"
        strip, specimen = 0.05, 0.03
        bending = (f"bending = {{ rigidity_uN_cm2 = [{BEND_WARP * specimen * 1e10!r}, {BEND_WEFT * specimen * 1e10!r}] }}"
                   if hinges else "")
        scene.write_text(SCENE.format(duration=steps * STEP, step=STEP, gravity=GRAVITY, density=DENSITY,
                                      warp=0.1 * WARP * strip, weft=0.1 * WEFT * strip, bias=0.1 * BIAS * strip,
                                      bending=bending, cell=CELL, side=(n - 1) * CELL))
        out = pathlib.Path(folder) / "out"
        subprocess.run([DRAPE, "run", scene, "-o", out, "--nodes", "all", "--every", str(steps * STEP)], check=True,
                       stdout=subprocess.DEVNULL)
        with open(out / "outputs.csv", newline="") as file:
            rows = list(csv.reader(file))
    place = [float(v) for name, v in zip(rows[0], rows[-1]) if name.startswith("node.position")]
    return np.array(place).reshape(n, n, 3)


def drape_rates(quick):
    """Million particle-steps a second of `drape bench peers`, by name."""
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "peers.csv"
        subprocess.run([DRAPE, "bench", "peers", "--csv", table, *(["--quick"] if quick else [])], check=True,
                       stdout=subprocess.DEVNULL)
        with open(table, newline="") as file:
            return {row["name"]: float(row["million_particle_steps_per_s"]) for row in csv.DictReader(file)}
