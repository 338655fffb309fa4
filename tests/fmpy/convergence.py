"""Error of the FMU against ARKODE for seven step sizes, each half the one before.

    python tests/fmpy/convergence.py      prints the table of the README

The swinging sheet is packed once per step size, simulated through FMI up to a fixed time before the first fold, and
compared with `drape reference` at tolerance 1e-12: rms over all coordinates of all particles. A scheme of order p has
error = C h^p (1 + O(h^2)), so the slope of log(error) over log(h), by least squares, is p.
"""
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from master import Fmu, Instance
from scenes import ROOT, read_csv, swinging_sheet, toml

COMMUNICATION = 0.0008  # s; 32 of the longest steps
LONGEST_STEP = COMMUNICATION / 32  # s
HALVINGS = 6
UNTIL = 128 * COMMUNICATION  # s


def _drape(*arguments):
    subprocess.run([ROOT / "build" / "drape", *map(str, arguments)], check=True, capture_output=True)


def last_row(file):
    """The last row of an outputs.csv as a dictionary."""
    names, rows = read_csv(file)
    return dict(zip(names, rows[-1]))


def node_positions(row):
    return np.array([value for name, value in row.items() if name.startswith("node.position[")]).reshape(-1, 3)


def reference(folder, **keys):
    """The last row of the reference run: all outputs and all particles at UNTIL."""
    scene = folder / "reference.toml"
    scene.write_text(toml(swinging_sheet(communication=COMMUNICATION, **keys)))
    out = folder / "reference"
    _drape("reference", scene, "-o", out, "--rtol", 1e-12, "--nodes", "all", "--until", UNTIL, "--every", UNTIL)
    return last_row(out / "outputs.csv")


def measure(folder, integrator="leapfrog", **keys):
    """[HALVINGS + 1 x 2] array of step sizes (s) and rms position errors (m)."""
    exact = node_positions(reference(folder, **keys))
    rows = []
    for k in range(HALVINGS + 1):
        step = LONGEST_STEP / 2**k
        scene = folder / f"{integrator}_{k}.toml"
        scene.write_text(toml(swinging_sheet(communication=COMMUNICATION, step=step, integrator=integrator, **keys)))
        _drape("pack", scene, "-o", scene.with_suffix(".fmu"), "--nodes", "all")
        with Instance(Fmu(scene.with_suffix(".fmu"))) as cloth:
            cloth.initialize().run(UNTIL, COMMUNICATION)
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
        print(markdown(measure(Path(name)), measure(Path(name), integrator="paper")))
