"""A cloth dropped on a sphere: Drape and other cloth simulations, in turn, medians.

    python3 tests/bench/peers/drop.py [--quick] [--csv FILE]

A square of 0.5 m, 65 x 65 particles, 0.15 kg/m2, links of 100 N/m along the threads and 50 N/m along the diagonals, rigidity in
bending 1 uN m, falls from 5 mm above a fixed sphere of radius 0.15 m, friction 0.3, for one second (drop_scene.py). One core,
one thread; seconds of wall clock and of processor for a second of cloth, without imports, reading and building. The ratio is
that of processor seconds, which other work on the machine disturbs less. Each peer runs in a process of its own, with the
solver and the steps that its documentation or its examples have for cloth, where that ends in a drape.

Their results differ in quality, so the table reports how each cloth ends: its lowest point, its deepest particle (under the
surface of the true sphere; below zero: above it), its longest link. With a particle deeper than the thickness (1 mm), the
middle more than 20 mm from the top, the lowest point not 0 to 0.2 m below the middle of the sphere, or a number that is not
finite it is no drape, and the table reports that. What differs:

drape    double precision; explicit, second order, steps of its own below the limit; a mesh of 20,480 triangles; braked by
         0.5 1/s
tissu    double; XPBD, 600 steps of 3 iterations, in which links are softer than asked for; cloth touches cloth; speed falls
         by 1 % a step; the rim as heavy as the rest; friction takes a share of the sliding; hinges on one diagonal of a cell
blender  single; implicit Euler, 10 steps a frame of 32 ms (with its default of 5 the cloth falls through at this thickness),
         its default damping of springs; the same mesh; braked by 0.5 1/s; the rim as heavy as the rest
springs  Newton, single; explicit, first order, 5,760 steps; penalty contact with a true sphere; nothing braked
style3d  Newton, single; implicit Euler by projective dynamics, 600 steps of 4 iterations, in which the cloth comes down
         late; triangles without lateral contraction; contact as above
mujoco   double; implicit, 500 steps, conjugate gradients to 1e-6; triangles of the same sheet taken as a continuum; contact
         by soft constraints with a true sphere; braked by 0.5 1/s
"""
import argparse
import csv
import importlib
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

from environment import run_in

PEERS = {  # name: module, function
    "drape": ("drop_drape", "drop"),
    "tissu": ("drop_tissu", "drop"),
    "blender": ("drop_blender", "drop"),
    "springs": ("drop_newton", "springs"),
    "style3d": ("drop_newton", "style3d"),
    "mujoco": ("drop_mujoco", "drop"),
}
LIMIT = 900  # s, for a run

if __name__ == "__main__":
    run_in("peers-drop", "requirements-drop.txt")

import numpy as np  # noqa: E402
from drop_scene import judge  # noqa: E402


def run_here(name, seconds, path):
    module, function = PEERS[name]
    places, spent = getattr(importlib.import_module(module), function)(seconds)
    np.savez(path, places=places, rates=np.array(spent) / seconds)


def run_apart(name, seconds):
    """(places, [wall, processor] per second of cloth) of a run in its own process, or why there is none, as a line."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "end.npz"
        command = [sys.executable, pathlib.Path(__file__).resolve(), "--run", name, str(seconds), path]
        one = {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")}
        try:
            run = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT, cwd=folder, env={**os.environ, **one})
        except subprocess.TimeoutExpired:
            return None, f"longer than {LIMIT} s"
        if run.returncode == 0:
            with np.load(path) as end:
                return end["places"], end["rates"]
        lines = run.stderr.strip().splitlines()
        return None, lines[-1] if lines else f"ended with {run.returncode}"


def measure(seconds, turns):
    """By name, the places at the end of the last run and [run, wall or processor]; or None and a line with the reason."""
    found = {name: (None, []) for name in PEERS}
    for _ in range(turns):
        for name, (_, rates) in found.items():
            if isinstance(rates, list):
                places, rate = run_apart(name, seconds)
                found[name] = (places, [*rates, rate] if places is not None else rate)
    return found


def row_of(name, places, rates, draped):
    if places is None:
        return {"peer": name, "remark": rates}
    end, fault = judge(places, draped)
    wall, processor = (statistics.median(column) for column in zip(*rates))
    return {"peer": name, "wall_s": wall, "processor_s": processor, **end,
            "remark": f"no drape: {fault}" if fault else ""}


def line_of(row, drape):
    if "wall_s" not in row:
        return f"{row['peer']:8} did not run: {row['remark']}"
    return (f"{row['peer']:8} {row['wall_s']:8.2f} {row['processor_s']:8.2f} {row['processor_s'] / drape:7.1f} x "
            f"{1e3 * row['lowest']:9.1f} {1e3 * row['deepest']:9.2f} {100 * row['elongation']:9.1f}   {row['remark']}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="40 ms of cloth once: no drape yet, no figures to rely on")
    parser.add_argument("--csv", type=pathlib.Path, help="also writes the rows to a file")
    parser.add_argument("--run", nargs=3, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    if options.run:
        return run_here(options.run[0], float(options.run[1]), options.run[2])

    found = measure(*((0.04, 1) if options.quick else (1.0, 3)))
    rows = [row_of(name, places, rates, not options.quick) for name, (places, rates) in found.items()]
    drape = rows[0].get("processor_s", float("nan"))
    print("          wall, s   cpu, s            lowest, mm deepest, mm longest, %")
    print(*(line_of(row, drape) for row in rows), sep="\n")
    if options.csv:
        with open(options.csv, "w", newline="") as file:
            columns = ["peer", "wall_s", "processor_s", "lowest", "deepest", "aside", "elongation", "remark"]
            table = csv.DictWriter(file, columns, lineterminator="\n")
            table.writeheader()
            table.writerows([{k: f"{v:.6g}" if isinstance(v, float) else v for k, v in row.items()} for row in rows])


if __name__ == "__main__":
    main()
