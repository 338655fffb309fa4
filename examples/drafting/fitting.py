"""A drafted garment on its form: fitted, reported, drawn, checked."""
import argparse
import subprocess
import sys
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(EXAMPLES))
from look import picture
from stage import ROOT, drape, last_row

THICKNESS = 0.0005  # m, of the wool
GAP = 1e-3  # m
LONGEST = 20  # s of fitting; it ends at rest before


def draft(script, folder, *options):
    """Runs a draft.py; returns its scene."""
    done = subprocess.run([sys.executable, script, "-o", folder, *map(str, options)], check=True, capture_output=True, text=True)
    return Path(done.stdout.strip())


def fit(scene, folder):
    """From the placed pieces to the garment at rest; prints the report, returns the last row of the outputs by name."""
    report = folder / "report.txt"
    drape("run", scene, "-o", folder / "run", "--until", LONGEST, "--every", 0.5, "--frames", "--report", report, allowed=(0, 2))
    print(report.read_text())
    return last_row(folder / "run")


def check(end, rest=1e-5):
    """At rest (forces left, of the load), every seam closed, no particle deeper than the cloth is thick."""
    gaps = {name: value for name, value in end.items() if name.endswith(".gap.max")}
    residual, count = end["fit.residual"], end["contact.count"]
    print(f"{end['time']:g} s, {end['step.count']:.0f} steps; forces left {residual:.1e} of the load, {count:.0f} particles touch the form")
    print(f"largest gap {1e3 * max(gaps.values()):.1e} mm, penetration {1e3 * end['contact.penetration.max']:.3f} mm of {1e3 * THICKNESS} mm,"
          f" {end['strain.beyond_test.count']:.0f} threads beyond the tested range")
    assert residual <= rest, "the garment is not at rest"
    assert max(gaps.values()) < GAP, {name: gap for name, gap in gaps.items() if gap >= GAP}
    assert all(value == 1 for name, value in end.items() if name.startswith("seam.") and name.endswith(".closed")), "a seam is open"
    assert end["contact.penetration.max"] < THICKNESS, "the cloth sinks into the form"
    assert count > 0, "the garment does not touch the form"


def command_line(text, folder):
    parser = argparse.ArgumentParser(description=text.splitlines()[0])
    parser.add_argument("folder", type=Path, nargs="?", default=ROOT / "build" / folder)
    parser.add_argument("--quick", action="store_true", help="coarse cells, a short garment")
    return parser.parse_args()


def fitted(name, text, quick, full):
    """The whole example; `quick` and `full`: options of the draft."""
    options = command_line(text, name)
    scene = draft(EXAMPLES / name / "draft.py", options.folder, *(quick if options.quick else full))
    end = fit(scene, options.folder)
    for field in ("tension_warp", "strain_weft"):
        picture(options.folder / "run", options.folder / f"{name}_{field}.png", field=field, views=["front", "back", "oblique"])
    check(end)
