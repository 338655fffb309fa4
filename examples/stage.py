"""Sets an example up: its scene and the meshes of its bodies in one folder, the `drape` command, the FMU under FMPy."""
import csv
import math
import os
import shutil
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import fmpy
import numpy as np
from fmpy.fmi2 import FMU2Slave

ROOT = Path(__file__).resolve().parents[1]
REST_STEP, REST_STEPS, RESIDUAL = 0.1, 200, 1e-5  # s; at most; the residual of a fit at rest


def drape(*arguments, allowed=(0,)):
    """Runs the command; its messages go where this script's go. `allowed`: exit codes; 2 is a fit that has not come to rest, or
    a seam that is still open."""
    command = ROOT / "build" / "drape"
    if not command.exists():
        sys.exit(f"{command} is missing: run `bash examples/quickstart.sh`")
    done = subprocess.run([command, *map(str, arguments)])
    if done.returncode not in allowed:
        sys.exit(done.returncode)


def scene_put(folder, scene, **changed):
    """The scene file in a folder where its meshes will lie; fabrics are found from there. `changed`: values of keys `NAME = ...`."""
    folder.mkdir(parents=True, exist_ok=True)
    text = scene.read_text().replace('"../fabrics/', f'"{Path(os.path.relpath(ROOT / "examples" / "fabrics", folder.resolve())).as_posix()}/')
    for key, value in changed.items():
        lines = text.splitlines()
        at = [k for k, line in enumerate(lines) if line.split("=")[0].strip() == key]
        assert at, key
        for k in at:
            lines[k] = f"{key} = {value}"
        text = "\n".join(lines) + "\n"
    file = folder / "scene.toml"
    file.write_text(text)
    return file


def last_row(folder):
    """The end of a run's outputs.csv, by name."""
    with open(folder / "outputs.csv") as table:
        return {name: float(value) for name, value in list(csv.DictReader(table))[-1].items()}


def mesh_write(file, points, faces):
    """An OBJ file; faces are polygons by their points, counter-clockwise from outside."""
    file.parent.mkdir(parents=True, exist_ok=True)
    lines = [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in points]
    for face in faces:
        lines += [f"f {face[0] + 1} {a + 1} {b + 1}" for a, b in zip(face[1:], face[2:])]
    file.write_text("\n".join(lines) + "\n")


def box(x, y, z):
    """About the origin, with these edges."""
    points = [(i * x / 2, j * y / 2, k * z / 2) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]
    return points, [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def cylinder(radius, length, sides):
    """About the origin along z."""
    ring = [(radius * math.cos(2 * math.pi * k / sides), radius * math.sin(2 * math.pi * k / sides)) for k in range(sides)]
    points = [(x, y, z) for z in (-length / 2, length / 2) for x, y in ring] + [(0, 0, -length / 2), (0, 0, length / 2)]
    faces = []
    for k in range(sides):
        after = (k + 1) % sides
        faces += [(k, after, sides + after, sides + k), (after, k, 2 * sides), (sides + k, sides + after, 2 * sides + 1)]
    return points, faces


def ball(radius, rings):
    """About the origin; twice as many points go round as from pole to pole."""
    around = 2 * rings
    points = [(0, 0, radius)]
    for i in range(1, rings):
        t = math.pi * i / rings
        points += [(radius * math.sin(t) * math.cos(f), radius * math.sin(t) * math.sin(f), radius * math.cos(t))
                   for f in (2 * math.pi * j / around for j in range(around))]
    points.append((0, 0, -radius))
    at = lambda i, j: 1 + (i - 1) * around + j % around  # noqa: E731
    faces = [(0, at(1, j), at(1, j + 1)) for j in range(around)]
    faces += [(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)) for i in range(1, rings - 1) for j in range(around)]
    faces += [(len(points) - 1, at(rings - 1, j + 1), at(rings - 1, j)) for j in range(around)]
    return points, faces


class Unit:
    """An FMU between its communication steps."""

    def __init__(self, description, slave):
        self.reference = {v.name: v.valueReference for v in description.modelVariables}
        self.outputs = [v.name for v in description.modelVariables if v.causality == "output"]
        self.slave, self.time = slave, 0.0
        self.node_count = sum(name.startswith("node.position[") for name in self.reference) // 3

    def set(self, values):
        """Numbers by name; a sequence goes to NAME[1], NAME[2], ..."""
        flat = {}
        for name, value in values.items():
            if np.ndim(value) == 0:
                flat[name] = float(value)
            else:
                flat |= {f"{name}[{k + 1}]": float(v) for k, v in enumerate(value)}
        self.slave.setReal([self.reference[name] for name in flat], list(flat.values()))

    def get(self, *names):
        return np.array(self.slave.getReal([self.reference[name] for name in names]))

    def vector(self, name):
        return self.get(*(f"{name}[{k}]" for k in (1, 2, 3)))

    def nodes(self, name):
        """[nodes x 3] of "node.position" or "node.velocity"; of FMUs packed with --nodes all."""
        return self.get(*(f"{name}[{i},{k}]" for i in range(1, self.node_count + 1) for k in (1, 2, 3))).reshape(-1, 3)

    def step(self, length):
        self.slave.doStep(self.time, length)
        self.time += length

    def rest(self):
        """Steps until a cloth in fit mode is at rest; False where it finds none. The first step moves the pins."""
        for count in range(REST_STEPS):
            self.step(REST_STEP)
            if count > 0 and self.get("fit.residual")[0] <= RESIDUAL:
                return True
        return False


@contextmanager
def opened(fmu, start=None):
    """Opens an FMU; `start`: what is to hold from the start."""
    description = fmpy.read_model_description(fmu)
    folder = fmpy.extract(fmu)
    slave = FMU2Slave(guid=description.guid, unzipDirectory=folder, modelIdentifier=description.coSimulation.modelIdentifier)
    slave.instantiate()
    unit = Unit(description, slave)
    slave.setupExperiment(startTime=0.0)
    slave.enterInitializationMode()
    unit.set(start or {})
    slave.exitInitializationMode()
    try:
        yield unit
        slave.terminate()
    finally:
        slave.freeInstance()
        shutil.rmtree(folder)
