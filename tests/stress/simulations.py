"""Random simulations of many kinds, each from a seed of its own: none hangs, none leaves the finite numbers, and the energy
balance of each closes to 1 %. tests/stress/README.md tells what a seed holds and what is judged.

    .venv/bin/python tests/stress/simulations.py                       2,000 simulations: two hours on two cores
    .venv/bin/python tests/stress/simulations.py --seed 123            one, whose folder is kept
    .venv/bin/python tests/stress/simulations.py --seeds 0:500 --kind body --jobs 2 --report bodies.csv
"""
import argparse
import shutil
import sys
import tempfile
import traceback
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

from simulation import draft, kinds, report, run, verdict

ROOT = Path(__file__).resolve().parents[2]


def simulate(seed, drape, folder):
    """Runs a seed in a folder, and again with a quarter of the step where energy is missing. Returns a row of the report."""
    sim = kinds.simulation(seed)
    ended, outputs = run.run(sim, drape, folder)
    v = verdict.judge(ended.code, ended.hung, ended.text, verdict.read_rows(outputs))
    row = {"seed": seed, "kind": sim.kind, "outcome": v.outcome, "error": f"{v.error:.4g}", "fall": f"{v.fall:.4g}",
           "scale": f"{v.scale:.4g}", "steps": f"{v.steps:.0f}", "time": f"{v.time:.6g}", "seconds": f"{ended.seconds:.2f}",
           "exit": ended.code, "scene": draft.fingerprint(sim), "sentence": v.sentence, **sim.facts,
           **{name: f"{value:.4g}" for name, value in v.columns.items()}}
    if v.outcome == verdict.MISSED:
        ended, outputs = run.run(sim, drape, folder, [f"step.max={max(v.smallest_step / 4, 1e-9)!r}"], longer=6)
        again = verdict.judge(ended.code, ended.hung, ended.text, verdict.read_rows(outputs))
        if ended.code == 0 and again.outcome != verdict.NOT_FINITE:
            row["error_quarter"] = f"{again.error:.4g}"
    return row


def attempt(seed, drape, folder, keep):
    try:
        row = simulate(seed, drape, folder)
    except Exception:  # a fault of the suite: reported like a run without a sentence
        row = {"seed": seed, "kind": kinds.kind_of(seed), "outcome": verdict.UNEXPLAINED, "error": "0", "steps": "0",
               "sentence": traceback.format_exc().splitlines()[-1]}
        traceback.print_exc()
    if not keep:
        shutil.rmtree(folder, ignore_errors=True)
    return row


def told(row):
    quarter = f", {row['error_quarter']} with a quarter of the step" if row.get("error_quarter") else ""
    text = f"seed {row['seed']}, {row['kind']}: {row['outcome']}, {row['steps']} steps, {row.get('seconds', '')} s"
    return text + (f"; missing {row['error']}{quarter}" if row["outcome"] == verdict.MISSED else "") + (
        f"; {row['sentence']}" if row["sentence"] else "")


def chosen(options):
    """The seeds to run."""
    if options.seed is not None:
        return [options.seed]
    seeds = [seed for seed in range(*options.seeds) if options.kind in (None, kinds.kind_of(seed))]
    k, n = options.shard
    return seeds[len(seeds) * (k - 1) // n:len(seeds) * k // n]


def seed_range(text):
    first, end = (int(x) for x in text.split(":"))
    if not 0 <= first < end:
        raise ValueError
    return first, end


def shard(text):
    k, n = (int(x) for x in text.split("/"))
    if not 1 <= k <= n:
        raise ValueError
    return k, n


def options_of(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--drape", type=Path, default=ROOT / "build" / "drape", help="the command to test")
    parser.add_argument("--seeds", type=seed_range, default="0:2000", metavar="A:B", help="from A up to, without, B")
    parser.add_argument("--seed", type=int, help="one seed; its folder is kept")
    parser.add_argument("--kind", choices=list(kinds.KINDS), help="of these seeds, only those of a kind")
    parser.add_argument("--shard", type=shard, default="1/1", metavar="K/N", help="the K-th of N parts of these seeds")
    parser.add_argument("--jobs", type=int, default=1, help="runs at a time")
    parser.add_argument("--report", type=Path, metavar="FILE", help="a row a run (.csv), or the tables (.md)")
    parser.add_argument("--compare", type=Path, metavar="FILE.csv", help="steps over those of an earlier report")
    parser.add_argument("--folder", type=Path, help="where the folder of --seed goes")
    parser.add_argument("--quiet", action="store_true", help="only what is not sound, and the tables")
    return parser.parse_args(arguments)


def main(arguments=None):
    options = options_of(arguments)
    drape = options.drape.resolve()
    if not drape.exists():
        sys.exit(f"error: {drape} is missing; tests/run.sh builds it")
    keep = options.seed is not None
    base = options.folder or Path(tempfile.mkdtemp(prefix="drape_simulations_"))
    rows = []
    with ThreadPoolExecutor(options.jobs) as pool:
        jobs = [pool.submit(attempt, seed, drape, base / str(seed), keep) for seed in chosen(options)]
        for job in as_completed(jobs):
            rows.append(job.result())
            if not options.quiet or rows[-1]["outcome"] != verdict.SOUND:
                print(told(rows[-1]), flush=True)
            if options.report:
                report.write(options.report, sorted(rows, key=lambda row: row["seed"]))
    rows.sort(key=lambda row: row["seed"])
    print("\n" + report.whole(rows))
    if options.compare:
        print("\n" + report.compared(rows, report.read(options.compare)))
    if keep:
        print(f"\nkept: {base / str(options.seed)}")
    else:
        shutil.rmtree(base, ignore_errors=True)
    failed = report.failures(rows)
    print("\n" + "\n".join(f"FAILED: {sentence}" for sentence in failed) if failed else "\nall is well")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
