"""Drape: `drape run` of the drop, on a sphere of 20,480 triangles."""
import csv
import os
import pathlib
import subprocess
import tempfile
import time

import numpy as np
from drape_side import DRAPE
from drop_scene import (BENDING, BRAKING, CELL, DENSITY, FRICTION, GRAVITY, LENGTH, SHEAR, SIDE, START, STRETCH, THICKNESS,
                        sphere)

# A link of width b pulls with b P(e)/w, P the diagram of a strip of width w, e its elongation over its length b: dF/dl = k
# where P = k w e. Diagonals lie b/sqrt(2) apart and are b sqrt(2) long: dF/dl = d where, taken literally, P = 2 d w e.
STRIP, TESTED = 0.05, 0.1  # m, elongation
SPECIMEN, HALF = 0.03, LENGTH / 2  # m
SCENE = f"""[scene]
name = "drop"
duration = 1.0
damping = {BRAKING}
gravity = [0, 0, {-GRAVITY}]
[options]
bias_model = "paper"
clamp_correction = false
[fabric.linear]
areal_density = {DENSITY}
thickness = {THICKNESS}
friction = {FRICTION}
strip = {{ width = {STRIP}, gauge = 0.2 }}
warp = {{ elongation_percent = [0, {100 * TESTED}], force = [0, {STRETCH * STRIP * TESTED!r}] }}
weft = {{ elongation_percent = [0, {100 * TESTED}], force = [0, {STRETCH * STRIP * TESTED!r}] }}
bias = {{ elongation_percent = [0, {100 * TESTED}], force = [0, {2 * SHEAR * STRIP * TESTED!r}] }}
bending = {{ rigidity_uN_cm2 = [{BENDING * SPECIMEN * 1e10!r}, {BENDING * SPECIMEN * 1e10!r}], width = {SPECIMEN} }}
[[piece]]
name = "sheet"
fabric = "linear"
cell = {CELL!r}
outline = [[{-HALF}, {-HALF}], [{HALF}, {-HALF}], [{HALF}, {HALF}], [{-HALF}, {HALF}]]
place = {{ origin = {list(START)}, axis_x = [1, 0, 0], axis_y = [0, 1, 0] }}
[[body]]
name = "ball"
mesh = "sphere.obj"
"""


def run(folder, until):
    """Wall and processor seconds of the whole command, and the places at its end."""
    out = folder / "out"
    start, before = time.perf_counter(), os.times()
    subprocess.run([DRAPE, "run", folder / "drop.toml", "-o", out, "--nodes", "all", "--until", str(until), "--every",
                    str(until)], check=True, stdout=subprocess.DEVNULL)
    wall, after = time.perf_counter() - start, os.times()
    processor = after.children_user + after.children_system - before.children_user - before.children_system
    with open(out / "outputs.csv", newline="") as file:
        rows = list(csv.reader(file))
    place = [float(v) for name, v in zip(rows[0], rows[-1]) if name.startswith("node.position")]
    return np.array([wall, processor]), np.array(place).reshape(SIDE, SIDE, 3)


def drop(seconds):
    """The command also reads, assembles and sorts the body: a run of one step of communication, which is taken off."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        points, faces = sphere()
        with open(folder / "sphere.obj", "w") as file:
            file.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in points.tolist())
            file.writelines(f"f {a} {b} {c}\n" for a, b, c in (faces + 1).tolist())
        (folder / "drop.toml").write_text(SCENE)
        start, _ = run(folder, 1e-3)
        whole, places = run(folder, seconds)
    return places, (whole - start) * seconds / (seconds - 1e-3)
