"""What seams, contact and self-contact cost a garment on its form, compared with its pieces alone.

    taskset -c 0 .venv/bin/python tests/bench/garment.py [--quick] [--csv FILE] [--settle SECONDS]

The drafted dress of about 15,000 particles of wool, dynamic with `damping = 20`, in four scenes: its pieces alone, which
fall; sewn, without the form; sewn on the form; the same with self-contact. All run for 2.5 s first, after which the dress
lies still. Then each goes on for 5 ms by turns, in one FMPy process. The table has microseconds a step, medians. Each row is
a scene of its own, because a scene costs only what it contains.
"""
import argparse
import csv
import re
import sys
import tempfile
from pathlib import Path

from turns import ROOT, Run, microseconds

sys.path.insert(0, str(ROOT / "examples" / "drafting"))
from fitting import EXAMPLES, draft  # noqa: E402

TURN = 0.005  # s of cloth


def without(text, table):
    """A scene without its tables [[table]]."""
    return re.sub(rf"\[\[{table}\]\].*?(?=\n\[|\Z)", "", text, flags=re.S)


def variants(text):
    sewn_on_form = text.replace('mode = "fit"', "damping = 20")
    sewn = without(sewn_on_form, "body")
    return {
        "lattices alone": without(sewn, "seam"),
        "with seams": sewn,
        "with seams and contact": sewn_on_form,
        "with seams, contact and self-contact": sewn_on_form.replace("[scene]", "[scene]\nself_contact = true", 1),
    }


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--quick", action="store_true", help="coarse cells, seconds in all, no figures to rely on")
    arguments.add_argument("--csv", type=Path, help="also writes the rows to a file")
    arguments.add_argument("--settle", type=float, default=2.5, help="s of cloth before it is measured")
    options = arguments.parse_args()
    cell, settle, turns = (0.03, 0.01, 1) if options.quick else (0.0078, options.settle, 8)
    with tempfile.TemporaryDirectory() as folder:
        text = draft(EXAMPLES / "dress" / "draft.py", Path(folder), f"--cell={cell}").read_text()
        runs = {name: Run(Path(folder), k, scene) for k, (name, scene) in enumerate(variants(text).items())}
        rows = list(microseconds(runs, settle, TURN, turns).items())
        touching = runs["with seams and contact"].instance.get("contact.count")[0]
    for name, value in rows:
        print(f"{name:40} {value:8.1f} us a step {value / rows[0][1]:8.2f}")
    print(f"{touching:.0f} particles and pairs touch the form")
    if options.csv:
        with open(options.csv, "w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows(
                [("what", "us a step"), *((name, f"{value:.4g}") for name, value in rows)])


if __name__ == "__main__":
    main()
