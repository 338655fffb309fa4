"""Error of the FMU against ARKODE for several step sizes, each half the one before.

    python tests/fmpy/convergence.py      prints the table of the README
    python tests/fmpy/convergence.py all  prints the tables of all cases

A cloth is packed once per step size, simulated through FMI up to a fixed time before the first fold, and compared with
`drape reference` at tolerance 1e-12: rms over all coordinates of all particles. A scheme of order p has
error = C h^p (1 + O(h^2)), so the slope of log(error) over log(h), by least squares, is p.
"""
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import numpy as np
import scenes
from master import OK, Fmu, Instance
from scenes import ROOT, read_csv, toml, write_inputs

COMMUNICATION = 0.0008  # s


@dataclass(frozen=True)
class Case:
    scene: Callable[..., dict]  # of keys of [scene]
    steps: int = 32  # in a communication interval, at first
    halvings: int = 6
    intervals: int = 128
    path: Callable[[float], dict] | None = None  # inputs at a time

    @property
    def longest_step(self):
        return COMMUNICATION / self.steps

    @property
    def until(self):
        return self.intervals * COMMUNICATION


SWINGING = Case(scenes.swinging_sheet)
CASES = {
    "concave piece with a hole, grain 20 degrees": Case(scenes.concave_sheet, halvings=4, intervals=64),
    "driven clamp": Case(scenes.driven_sheet, halvings=4, intervals=64, path=scenes.pole_path),
    "flag in light wind": Case(scenes.flag, halvings=4, intervals=64),
    "damping along the springs": Case(scenes.damped_sheet, steps=64, halvings=4, intervals=64),
}


def _drape(*arguments):
    done = subprocess.run([ROOT / "build" / "drape", *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def last_row(file):
    """The last row of an outputs.csv as a dictionary."""
    names, rows = read_csv(file)
    return dict(zip(names, rows[-1]))


def node_positions(row):
    return np.array([value for name, value in row.items() if name.startswith("node.position[")]).reshape(-1, 3)


def inputs_of(folder, case):
    """The options that name the inputs of a case: a row at each communication point."""
    if not case.path:
        return []
    times = [k * COMMUNICATION for k in range(case.intervals + 1)]
    return ["--inputs", write_inputs(folder / "inputs.csv", case.path, times)]


def reference(folder, case=SWINGING, **keys):
    """The last row of the reference run: all outputs and all particles at the end."""
    scene = folder / "reference.toml"
    scene.write_text(toml(case.scene(communication=COMMUNICATION, **keys)))
    out = folder / "reference"
    # fmt: off
    _drape("reference", scene, "-o", out, "--rtol", 1e-12, "--nodes", "all", "--until", case.until, "--every", case.until,
           *inputs_of(folder, case))
    # fmt: on
    return last_row(out / "outputs.csv")


def simulate(cloth, case):
    """To the end in communication steps, each to the inputs at its end."""
    for k in range(case.intervals):
        if case.path:
            cloth.drive(case.path((k + 1) * COMMUNICATION))
        cloth.time = k * COMMUNICATION
        assert cloth.step(COMMUNICATION) == OK, cloth.log


def measure(folder, case=SWINGING, integrator="leapfrog", **keys):
    """[halvings + 1 x 2] array of step sizes (s) and rms position errors (m)."""
    exact = node_positions(reference(folder, case, **keys))
    rows = []
    for k in range(case.halvings + 1):
        step = case.longest_step / 2**k
        scene = folder / f"{integrator}_{k}.toml"
        scene.write_text(toml(case.scene(communication=COMMUNICATION, step=step, integrator=integrator, **keys)))
        _drape("pack", scene, "-o", scene.with_suffix(".fmu"), "--nodes", "all")
        with Instance(Fmu(scene.with_suffix(".fmu"))) as cloth:
            simulate(cloth.initialize(), case)
            assert cloth.get("step.size")[0] == step
            rows.append((step, np.sqrt(np.mean((cloth.nodes() - exact) ** 2))))
    return np.array(rows)


def slope(table):
    return np.polyfit(np.log(table[:, 0]), np.log(table[:, 1]), 1)[0]


def markdown(leapfrog, paper):
    """The README's table."""
    lines = ["| step, µs | leapfrog: rms error, m | the paper's scheme: rms error, m |", "|---:|---:|---:|"]
    lines += [f"| {1e6 * a[0]:.4g} | {a[1]:.2e} | {b[1]:.2e} |" for a, b in zip(leapfrog, paper)]
    lines.append(f"| order | {slope(leapfrog):.2f} | {slope(paper):.2f} |")
    return "\n".join(lines)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        if sys.argv[1:] == ["all"]:
            for title, case in CASES.items():
                table = measure(Path(name), case)
                print(f"{title}: order {slope(table):.3f}")
                for step, error in table:
                    print(f"  {1e6 * step:.4g} µs: {error:.3e} m")
        else:
            print(markdown(measure(Path(name)), measure(Path(name), integrator="paper")))
