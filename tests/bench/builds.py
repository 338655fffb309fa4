"""The two builds of an FMU's binary, by turns: microseconds a step, release over development.

    taskset -c 0 .venv/bin/python tests/bench/builds.py [--quick] [--csv FILE]

Both must be there: `bash tests/run.sh`, then `bash fmu/release.sh linux64`. A row is a scene, packed with either binary. One
instance of each simulates it, interval for interval by turns. A row compares the medians of its intervals. Both take the same
number of steps.
"""
import argparse
import csv
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "fmpy"))
from bodies import sheet_over_ball  # noqa: E402
from master import OK, Fmu, Instance  # noqa: E402
from scenes import HORIZONTAL, ROOT, flag, pin_edge, sheet, toml, two_strips  # noqa: E402

DRAPE = ROOT / "build" / "drape"
BUILDS = ("development", "release")
CELL = 0.01  # m
INTERVALS, SECONDS = 41, 3.0  # of a row: how many, and how long both builds take for them, about


def square(cells, fabric=None, **scene_keys):
    scene = sheet(CELL * cells, CELL * cells, CELL, HORIZONTAL, **scene_keys)
    scene["fabric"]["wool"] |= fabric or {}
    pin_edge(scene, "bar", 2)
    return scene


def scenes(folder):
    """Cloth of growing size, then what else a step may hold."""
    for cells in (4, 16, 64, 128, 256):
        yield f"cloth, {(cells + 1) ** 2} particles", square(cells, damping=2.0)
    yield "damping along springs, 4225 particles", square(64, {"damping": 2e-6})
    yield "order 4, 4225 particles", square(64, order=4)
    yield "self-contact, 4225 particles", square(64, self_contact=True)
    yield "wind, 54 particles", flag()
    yield "seam, 84 particles", two_strips()
    yield "body, 441 particles", sheet_over_ball(folder, cell=0.005)


def pack(scene, folder, name, build):
    file, packed = folder / f"{name}.toml", folder / f"{name}_{build}.fmu"
    file.write_text(toml(scene))
    subprocess.run([DRAPE, "pack", file, "-o", packed, "--build", build, "--platforms", "linux64"], check=True,
                   stdout=subprocess.DEVNULL)
    return Fmu(packed)


def step(cloth, length):
    """Seconds of an interval."""
    started = time.perf_counter()
    status = cloth.step(length)
    seconds = time.perf_counter() - started
    assert status == OK, cloth.log
    return seconds


def measure(fmus, intervals, seconds):
    """Microseconds a step by build."""
    clothes = {build: Instance(fmu).initialize() for build, fmu in fmus.items()}
    step_size = float(clothes["release"].get("step.size")[0])
    once = min(step(cloth, 64 * step_size) for cloth in clothes.values()) / 64  # s, a step
    length = max(1, round(seconds / (2 * intervals * once))) * step_size
    before = clothes["release"].get("step.count")[0]
    times = {build: [] for build in clothes}
    for k in range(intervals):
        for build in BUILDS if k % 2 else BUILDS[::-1]:
            times[build].append(step(clothes[build], length))
    counts = {build: cloth.get("step.count")[0] for build, cloth in clothes.items()}
    assert len(set(counts.values())) == 1, counts
    for cloth in clothes.values():
        cloth.slave.freeInstance()
    steps = (counts["release"] - before) / intervals
    return {build: 1e6 * statistics.median(taken) / steps for build, taken in times.items()}


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--quick", action="store_true", help="seconds in all, no figures to rely on")
    arguments.add_argument("--csv", type=Path, help="also writes the rows to a file")
    options = arguments.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        for k, (what, scene) in enumerate(scenes(folder)):
            fmus = {build: pack(scene, folder, f"row_{k}", build) for build in BUILDS}
            taken = measure(fmus, *((3, 0.05) if options.quick else (INTERVALS, SECONDS)))
            rows.append((what, *(taken[build] for build in BUILDS), taken["release"] / taken["development"]))
            print("{:40} {:10.2f} {:10.2f} us   {:.3f}".format(*rows[-1]), flush=True)
    ratios = [ratio for *_, ratio in rows]
    print(f"release over development: {min(ratios):.3f} to {max(ratios):.3f}, "
          f"{statistics.geometric_mean(ratios):.3f} in the geometric mean")
    if options.csv:
        with open(options.csv, "w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows(
                [("what", *(f"{build}, us a step" for build in BUILDS), "ratio"),
                 *((what, *(f"{number:.4g}" for number in numbers)) for what, *numbers in rows)])


if __name__ == "__main__":
    main()
