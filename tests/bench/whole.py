"""The whole, from files to outputs: start-up, packing, and what FMI costs compared with `drape run`.

    .venv/bin/python tests/bench/whole.py [--quick] [--csv FILE]

A square of about 15,000 particles of the measured wool that swings from an edge. Start-up: `drape run` until its first
communication step, and fmi2Instantiate to the end of the first fmi2DoStep. FMI: FMPy reads 1,000 positions of particles, or
velocities, which need the forces of that moment, after every millisecond; `drape run` covers the same simulated time and reads
only its end. All include their start; by turns, medians.
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
from master import Fmu, Instance  # noqa: E402
from scenes import HORIZONTAL, ROOT, pin_edge, sheet, toml  # noqa: E402

DRAPE = ROOT / "build" / "drape"
MILLISECOND = 1e-3


def timed(work):
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def wool_square(cells):
    scene = sheet(0.01 * cells, 0.01 * cells, 0.01, HORIZONTAL, damping=2.0)
    pin_edge(scene, "bar", 2)
    return scene


def command(*arguments):
    subprocess.run([DRAPE, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def start_up(folder, turns):
    """Seconds of the three starts."""
    file, packed = folder / "large.toml", folder / "large.fmu"
    file.write_text(toml(wool_square(122)))
    command("pack", file, "-o", packed)
    fmu = Fmu(packed)

    def first_step():
        with Instance(fmu) as cloth:
            cloth.initialize()
            cloth.run(MILLISECOND, MILLISECOND)

    rows = {
        "drape check": lambda: command("check", file),
        "drape run, one communication step": lambda: command(
            "run", file, "-o", folder / "run", "--until", MILLISECOND, "--every", MILLISECOND),
        "fmi2Instantiate to the end of the first fmi2DoStep": first_step,
        "drape pack": lambda: command("pack", file, "-o", packed),
    }
    return {name: statistics.median(timed(work) for _ in range(turns)) for name, work in rows.items()}


def fmi_cost(folder, turns, simulated):
    """Seconds of `drape run` and of FMPy, 1,000 outputs every millisecond."""
    file, packed = folder / "sheet.toml", folder / "sheet.fmu"
    file.write_text(toml(wool_square(122)))
    command("pack", file, "-o", packed, "--nodes", "all")
    fmu = Fmu(packed)
    steps = round(simulated / MILLISECOND)

    def references_of(what):
        names = [n for n in fmu.outputs() if n.startswith(what)][:1000]
        return [fmu.variables[name].valueReference for name in names]

    positions, velocities = references_of("node.position"), references_of("node.velocity")

    def fmi(references):
        with Instance(fmu) as cloth:
            cloth.initialize()
            for k in range(1, steps + 1):
                cloth.run(k * MILLISECOND, MILLISECOND)
                cloth.slave.getReal(references)

    def run():
        command("run", file, "-o", folder / "run", "--until", simulated, "--every", simulated)

    contenders = {
        "drape run": run,
        "FMPy, 1,000 positions a millisecond": lambda: fmi(positions),
        "FMPy, 1,000 velocities a millisecond": lambda: fmi(velocities),
    }
    times = {name: [] for name in contenders}
    for _ in range(turns):
        for name, work in contenders.items():
            times[name].append(timed(work))
    return {name: statistics.median(values) for name, values in times.items()}


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--quick", action="store_true", help="seconds in all, no figures to rely on")
    arguments.add_argument("--csv", type=Path, help="also writes the rows to a file")
    options = arguments.parse_args()
    turns, simulated = (1, 0.002) if options.quick else (5, 0.4)
    with tempfile.TemporaryDirectory() as folder:
        rows = start_up(Path(folder), turns)
        cost = fmi_cost(Path(folder), turns, simulated)
    rows |= cost
    for name, seconds in rows.items():
        print(f"{name:52} {seconds:8.4f} s")
    for name in list(cost)[1:]:
        print(f"{name + ', over drape run':52} {cost[name] / cost['drape run']:8.4f}")
    if options.csv:
        with open(options.csv, "w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows(
                [("what", "seconds"), *((name, f"{seconds:.4g}") for name, seconds in rows.items())])


if __name__ == "__main__":
    main()
