"""Tissu (pytissu): XPBD on its own sphere. Its package has no compiled core, so its sources are compiled here.

Steps as in its own example of a cloth on a sphere: 60 frames a second, 10 substeps of 3 iterations. Cloth touches cloth, which
it cannot leave out; particles lose 1 % of their speed a substep; friction takes its share of the sliding away in each
substep; hinges stand on one diagonal of each cell.
"""
import os
import pathlib
import subprocess
import sys
import tarfile
import tempfile

import drop_scene
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
FLAGS = ["-std=c++17", "-O3", "-DNDEBUG", "-fopenmp", "-I/usr/include/eigen3"]
GIVEN = ["SIDE", "CELL", "DENSITY", "THICKNESS", "FRICTION", "STRETCH", "SHEAR", "BENDING", "GRAVITY", "RADIUS"]


def sources(folder):
    """The package's sources, of the version that is installed."""
    from importlib.metadata import version

    found = list(folder.glob("pytissu-*/core"))
    if not found:
        name = f"pytissu=={version('pytissu')}"
        subprocess.run([sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--no-binary", "pytissu",
                        "-d", folder, name], check=True)
        with tarfile.open(next(folder.glob("pytissu-*.tar.gz"))) as archive:
            archive.extractall(folder, filter="data")
        found = list(folder.glob("pytissu-*/core"))
    return found[0]


def compiled():
    folder = pathlib.Path(sys.prefix) / "tissu"
    folder.mkdir(exist_ok=True)
    core, program, source = sources(folder), folder / "tissu_drop", HERE / "drop_tissu.cpp"
    newest = max(file.stat().st_mtime for file in (source, HERE / "drop_scene.py", HERE / "drop_tissu.py"))
    if program.exists() and program.stat().st_mtime > newest:
        return program
    parts = ("physics", "data-structures", "engine", "utils")
    files = [file for part in parts for file in sorted((core / "src" / part).glob("*.cpp"))]
    corner = drop_scene.grid()[0, 0]
    values = {name: getattr(drop_scene, name) for name in GIVEN}
    values.update({f"CORNER_{axis}": float(place) for axis, place in zip("XYZ", corner)})
    given = [f"-D{name}=({value!r})" for name, value in values.items()]
    run = subprocess.run(["g++", *FLAGS, *given, "-I", core / "include", source, *files, core / "src" / "io" / "OBJLoader.cpp",
                          "-o", program], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit("its core does not compile: " + next((line for line in run.stderr.splitlines() if "error" in line), ""))
    return program


def drop(seconds):
    program = compiled()
    with tempfile.TemporaryDirectory() as folder:
        places = pathlib.Path(folder) / "places"
        run = subprocess.run([program, str(seconds), places], check=True, capture_output=True, text=True,
                             env={**os.environ, "OMP_NUM_THREADS": "1"})
        return np.loadtxt(places).reshape(drop_scene.SIDE, drop_scene.SIDE, 3), [
            seconds * float(v) for v in run.stdout.split()]
