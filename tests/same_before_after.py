"""Compares two commits on one machine: numbers only. A change of names or rooms leaves every number as it was.

    .venv/bin/python tests/same_before_after.py BEFORE AFTER [--quick] [--keep DIR]

Builds both commits and compares:
  outputs    of every example, FMU and scene: all .csv, .vtp and .obj files, byte for byte
  XML        of every scene; version, guid and generation tool are held, that is, left out where they differ
  golden     the hashes that the golden test expects
  benchmark  of the kernels: runs of both commits by turns on one core; medians; no row slower by more than 5 %

--quick: scenes alone, for a moment each, and one short benchmark that is printed but not checked. --keep DIR: the folder of both
builds and of the results; a commit that was built there before is not built again. Exit code 1 if anything differs.
"""
import argparse
import csv
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import fmpy

ROOT = Path(__file__).resolve().parents[1]
FMI_HEADERS = Path(fmpy.__file__).parent / "c-code"
OPTIONS = ["-DDRAPE_TESTS=OFF", "-DDRAPE_REFERENCE=ON", "-DDRAPE_BENCH=ON", f"-DDRAPE_FMI_HEADERS={FMI_HEADERS}"]
COMPARED = (".csv", ".vtp", ".obj")  # endings of the files with numbers
HELD = re.compile(r' (?:guid|generationTool|generationDateAndTime|version)="[^"]*"')
HASH = re.compile(r"\bk\w+ = (\d{12,}|0x[0-9a-fA-F]{8,})")
UNTIL, EVERY = "0.05", "0.01"  # s, of scenes and FMUs
RUNS, SLOWER = 9, 0.95
SHOWN = 5  # differences of a kind


@dataclass
class Side:
    name: str      # before or after
    commit: str
    tree: Path     # sources, and build/ within
    results: Path

    def drape(self, *arguments, prefix=()):
        return subprocess.run([*prefix, self.tree / "build" / "drape", *map(str, arguments)], capture_output=True, text=True)

    def scenes(self):
        """Scene files by a short name."""
        files = [*self.tree.glob("examples/*/*.toml"), *self.tree.glob("modelDescription/samples/*.toml")]
        return {f"{file.parent.name}/{file.stem}": file for file in sorted(files) if "[[piece]]" in file.read_text()}


@dataclass
class Row:
    what: str
    same: bool
    detail: str


def run(*command, **named):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, **named)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout[-4000:]}{done.stderr[-4000:]}")
    return done.stdout


def make_side(name, revision, folder):
    """Clones and builds a commit, unless that has been done."""
    commit = run("git", "-C", ROOT, "rev-parse", "--verify", f"{revision}^{{commit}}").strip()
    side = Side(name, commit, folder / commit[:12], folder / name)
    built = side.tree / "build" / "built"
    if not built.exists():
        print(f"building {name}: {commit[:12]}", flush=True)
        shutil.rmtree(side.tree, ignore_errors=True)
        run("git", "clone", "--quiet", "--shared", "--no-checkout", ROOT, side.tree)
        run("git", "-C", side.tree, "checkout", "--quiet", "--detach", commit)
        run("cmake", "--preset", "release", *OPTIONS, cwd=side.tree)
        run("cmake", "--build", "--preset", "release", cwd=side.tree)
        built.touch()
    shutil.rmtree(side.results, ignore_errors=True)
    side.results.mkdir(parents=True)
    return side


def run_example(side, name):
    """One example with its own script; then its FMUs on their own."""
    script, folder = side.tree / "examples" / name / "run.py", side.results / "examples" / name
    quick = ["--quick"] if "--quick" in script.read_text() or "fitting" in script.read_text() else []
    code = subprocess.run([sys.executable, script, folder, *quick], capture_output=True).returncode
    for fmu in sorted(folder.rglob("*.fmu")):
        code |= subprocess.run([sys.executable, "-m", "fmpy", "simulate", fmu, "--stop-time", UNTIL, "--output-interval", EVERY,
                                "--output-file", fmu.with_suffix(".fmu.csv")], capture_output=True).returncode
    return code


def run_scene(side, name):
    """One scene for a moment; samples by the reference solver too."""
    scene, folder = side.scenes()[name], side.results / "scenes" / name
    code = side.drape("run", scene, "-o", folder, "--until", UNTIL, "--every", EVERY, "--frames").returncode
    if scene.parent.name == "samples":
        code |= side.drape("reference", scene, "-o", folder / "reference", "--until", "0.02", "--every", "0.01").returncode
    return code


def compare_run(what, work, sides, name):
    """Runs something on both sides at once and compares the files that it leaves."""
    with ThreadPoolExecutor(len(sides)) as both:
        codes = list(both.map(lambda side: work(side, name), sides))
    folders = [side.results / f"{what}s" / name for side in sides]
    names = [{str(file.relative_to(folder)) for file in folder.rglob("*") if file.suffix in COMPARED} for folder in folders]
    differ = sorted(names[0] ^ names[1])
    differ += [file for file in sorted(names[0] & names[1])
               if (folders[0] / file).read_bytes() != (folders[1] / file).read_bytes()]
    if codes[0] != codes[1]:
        differ.insert(0, f"exit codes {codes[0]} and {codes[1]}")
    if differ:
        detail = ", ".join(differ[:SHOWN])
    elif codes[0] and not names[0]:
        detail = "runs on neither side: its example makes its mesh"
    else:
        detail = f"{len(names[0])} files, byte for byte" + ("; both end with an error" if codes[0] else "")
    return Row(f"{what} {name}", not differ, detail)


def compare_xml(sides, names):
    differ, same, held = [], 0, 0
    for name in names:
        before, after = (side.drape("variables", "--xml", side.scenes()[name]).stdout for side in sides)
        if HELD.sub("", before) != HELD.sub("", after):
            differ.append(name)
        elif before:  # a scene whose mesh is missing has none
            same, held = same + 1, held + (before != after)
    detail = f"{same} scenes" + (f", {held} of them but for version, guid and tool" if held else ", byte for byte")
    return Row("XML", same > 0 and not differ, ", ".join(differ[:SHOWN]) if differ else detail)


def compare_golden(sides):
    before, after = ([int(found, 0) for file in sorted(side.tree.glob("tests/**/golden_test.cpp"))
                      for found in HASH.findall(file.read_text())] for side in sides)
    return Row("golden hash", before == after and len(before) > 0, f"{before} and {after}")


def bench(side, quick):
    """Million particle-steps per second by row."""
    table, pinned = side.results / "bench.csv", ["taskset", "-c", "0"] if shutil.which("taskset") else []
    done = side.drape("bench", "kernel", "features", "--csv", table, *(["--quick"] if quick else []), prefix=pinned)
    if done.returncode:
        sys.exit(f"the benchmark of {side.name} ended with an error: {done.stderr}")
    with open(table) as rows:
        return {(row["group"], row["name"], row["kernel"]): float(row["million_particle_steps_per_s"])
                for row in csv.DictReader(rows)}


def compare_bench(sides, quick):
    """Runs of both sides by turns; one row for all, and one for every row of the benchmark that is slower."""
    speeds = {side.name: [] for side in sides}
    for turn in range(1 if quick else RUNS):
        for side in sides if turn % 2 == 0 else sides[::-1]:
            speeds[side.name].append(bench(side, quick))
    before, after = ({key: statistics.median(turn[key] for turn in turns) for key in turns[0]} for turns in speeds.values())
    ratios = {key: after[key] / before[key] for key in sorted(before.keys() & after.keys())}
    mean, least, most = statistics.geometric_mean(ratios.values()), min(ratios.values()), max(ratios.values())
    yield Row("benchmark", before.keys() == after.keys(),
              f"{len(ratios)} rows, after / before {mean:.3f} in the geometric mean, {least:.3f} to {most:.3f}")
    slower = {} if quick else {key: ratio for key, ratio in ratios.items() if ratio < SLOWER}
    yield from (Row(f"  {', '.join(key)}", False, f"after / before {ratio:.3f}") for key, ratio in slower.items())


def compare(sides, quick):
    scenes = [side.scenes().keys() for side in sides]
    yield Row("scenes", scenes[0] == scenes[1], f"{len(scenes[0])} and {len(scenes[1])}")
    shared = [name for name in scenes[0] if name in scenes[1]]
    yield from (compare_run("scene", run_scene, sides, name) for name in shared)
    if not quick:
        examples = [{file.parent.name for file in side.tree.glob("examples/*/run.py")} for side in sides]
        yield Row("examples", examples[0] == examples[1], f"{len(examples[0])} and {len(examples[1])}")
        yield from (compare_run("example", run_example, sides, name) for name in sorted(examples[0] & examples[1]))
    yield compare_xml(sides, shared)
    yield compare_golden(sides)
    yield from compare_bench(sides, quick)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before", metavar="BEFORE")
    parser.add_argument("after", metavar="AFTER")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--keep", type=Path, metavar="DIR")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep.resolve() if options.keep else Path(temporary)
        sides = [make_side("before", options.before, folder), make_side("after", options.after, folder)]
        print(*(f"{side.name:6s} {side.commit}" for side in sides), sep="\n")
        differ = 0
        for row in compare(sides, options.quick):
            print(f"{'same' if row.same else 'DIFFERS':8s} {row.what:34s} {row.detail}", flush=True)
            differ += not row.same
    print(f"{differ} differences" if differ else "no number differs")
    sys.exit(bool(differ))


if __name__ == "__main__":
    main()
