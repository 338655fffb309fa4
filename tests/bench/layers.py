"""What self-contact costs two sheets that lie on each other, at rest and sliding.

    taskset -c 0 .venv/bin/python tests/bench/layers.py [--quick] [--csv FILE]

Two sheets of wool of 6,561 particles each lie on a table, without self-contact both on the table itself, with it one on the
other. At rest they are damped; sliding, the upper one begins at 0.5 m/s. After 0.05 s each goes on for 1 ms by turns, in
one FMPy process. The table has microseconds a step, medians, and how many times as long a step takes with self-contact.
"""
import argparse
import copy
import csv
import sys
import tempfile
from pathlib import Path

from turns import ROOT, Run, microseconds

sys.path.insert(0, str(ROOT / "tests" / "fmpy"))
from scenes import HORIZONTAL, sheet, toml  # noqa: E402

LAYER = 0.0006  # m, from one sheet to the next: more than the thickness
TABLE = """v -1 -1 -0.1
v 2 -1 -0.1
v -1 2 -0.1
v 2 2 -0.1
v -1 -1 0
v 2 -1 0
v -1 2 0
v 2 2 0
f 1 3 4 2
f 5 6 8 7
f 1 2 6 5
f 3 7 8 4
f 1 5 7 3
f 2 4 8 6
"""


def scene(self_contact, speed, cells):
    two = sheet(0.4, 0.4, 0.4 / cells, HORIZONTAL | {"origin": [0, 0, LAYER / 2]}, duration=10.0, communication=0.001,
                damping=0.0 if speed else 2.0, self_contact=self_contact)
    upper = copy.deepcopy(two["piece"][0]) | {"name": "upper", "velocity": [speed, 0, 0]}
    upper["place"]["origin"] = [0.002, 0.001, LAYER * (1.5 if self_contact else 0.5)]
    two["piece"].append(upper)
    two["body"] = [{"name": "table", "mesh": "table.obj"}]
    return toml(two)


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--quick", action="store_true", help="coarse cells, seconds in all, no figures to rely on")
    arguments.add_argument("--csv", type=Path, help="also writes the rows to a file")
    options = arguments.parse_args()
    cells, turns = (16, 1) if options.quick else (80, 7)
    kinds = [(f"{name}, {has} self-contact", has == "with", speed)
             for name, speed in (("at rest", 0.0), ("sliding", 0.5)) for has in ("without", "with")]
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "table.obj").write_text(TABLE)
        runs = {name: Run(Path(folder), k, scene(has, speed, cells)) for k, (name, has, speed) in enumerate(kinds)}
        times = microseconds(runs, 0.01 if options.quick else 0.05, 0.001, turns)
    rows = [(name, times[name], times[name] / times[kinds[k - k % 2][0]]) for k, (name, _, _) in enumerate(kinds)]
    for name, value, ratio in rows:
        print(f"{name:32} {value:8.1f} us a step {ratio:8.2f}")
    if options.csv:
        with open(options.csv, "w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows(
                [("what", "us a step", "times without"), *((n, f"{v:.4g}", f"{r:.3g}") for n, v, r in rows)])


if __name__ == "__main__":
    main()
