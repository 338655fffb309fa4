"""One run of an FMU whose parameters are tuned while it moves. Started by run.py, in a process of its own.

    tuned.py DRAPE FOLDER OUT [NAME=VALUE ...]

FOLDER holds scene.toml and tuning.json: {"changes": [{"at", "group", "high", "ramp"}], "steps"}. A group is one parameter, or
one diagram; its number from 0 to 1 picks one of all that the FMU has. Rows go to OUT/outputs.csv, as `drape run` writes them;
what is tuned, and what of it the FMU refuses, goes to stderr. A refused value ends nothing: the FMU keeps the old one.
The run ends at the scene's duration, or once it has taken about "steps" steps; 0: no limit. The exit code is 0, or 2 with
the last message, or with what the FMU warns of at its end.
"""
import csv
import json
import math
import re
import subprocess
import sys
import tomllib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "fmpy"))
from master import DISCARD, OK, WARNING, Fmu, Instance  # noqa: E402

ROWS = 40


class Stopped(Exception):
    pass


def groups(fmu):
    """[[name, ...]]: tunable parameters, the points of a diagram together."""
    found = {}
    for name, v in fmu.variables.items():
        if v.causality == "parameter" and v.variability == "tunable" and name != "parameter_ramp":
            found.setdefault(re.sub(r"(force)\[\d+\]", r"\1", name), []).append(name)
    return list(found.values())


def tune(cloth, change):
    """Sets a group to an end of its range: a diagram to zero, or its upper half to the largest force."""
    found = groups(cloth.fmu)
    group = found[int(change["group"] * len(found))]
    if len(group) > 1 and change["high"]:
        group = group[len(group) // 2:]
    values = {"parameter_ramp": change["ramp"]}
    for name in group:
        v = cloth.fmu.variables[name]
        values[name] = float(v.max if change["high"] else v.min)
    end = "high" if change["high"] else "low"
    print(f"{group[0]} ... {group[-1]}, {len(group)} in all, to the {end} end at {cloth.time:.6g} s within {change['ramp']:.3g} s",
          file=sys.stderr)
    if any(cloth.set(name, value) != OK for name, value in values.items()):
        raise Stopped


def step(cloth, interval, tuned):
    """One interval. Values that are wrong only together are refused by the step after them: once, with a sentence."""
    status = cloth.step(interval)
    if status == DISCARD and tuned:
        refused = [text for level, _, text in cloth.log if level == DISCARD]
        if not refused:
            raise Stopped
        print(f"refused: {refused[-1]}", file=sys.stderr)
        status = cloth.step(interval)
    if status != OK:
        raise Stopped


def go(cloth, tuning, count, interval, record):
    """Steps by the communication interval; rows at even distances of time or steps, and at every change. A part between two
    changes that has taken its share of the steps is cut short. Returns the intervals at which that led to changes."""
    changes, taken = tuning["changes"], []
    share = tuning["steps"] / (len(changes) + 1) if tuning["steps"] else math.inf
    rows, begun, written, k = max(1, count // ROWS), 0.0, 0.0, 0
    while k < count:
        steps = cloth.get("step.count")[0]
        used_up = steps - begun >= share
        if used_up and len(taken) == len(changes):
            break
        changed = False
        if len(taken) < len(changes) and (used_up or k >= changes[len(taken)]["at"] / interval - 1e-6):
            tune(cloth, changes[len(taken)])
            taken.append(k)
            begun, changed = steps, True
        cloth.time = k * interval
        step(cloth, interval, changed)
        k += 1
        steps = cloth.get("step.count")[0]
        if changed or k % rows == 0 or k == count or steps - written > share / ROWS:
            written = steps
            record(k * interval)
    return taken, k


def plan_of(folder, again):
    """What to tune and when. A run made again with other steps takes the times at which the first one came to it."""
    plan = json.loads((folder / "tuning.json").read_text())
    if again:
        taken = json.loads((folder / "out" / "taken.json").read_text())
        interval = taken["interval"]
        for change, k in zip(plan["changes"], taken["at"]):
            change["at"] = k * interval
        plan |= {"changes": plan["changes"][:len(taken["at"])], "steps": 0, "count": taken["count"]}
    return plan


def main():
    drape, folder, out = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    out.mkdir(exist_ok=True)
    scene, file = folder / "scene.toml", out / "scene.fmu"
    packed = subprocess.run([drape, "pack", scene, "-o", file], stdout=subprocess.DEVNULL)
    if packed.returncode != 0:
        return packed.returncode
    plan = plan_of(folder, out.name == "again")
    keys = tomllib.loads(scene.read_text())["scene"]
    settings = {name: float(value) for name, value in (s.split("=") for s in sys.argv[4:])}
    interval, fmu = keys["communication"], Fmu(file)
    count = plan.get("count", round(keys["duration"] / interval))
    with open(out / "outputs.csv", "w", newline="") as rows, Instance(fmu) as cloth:
        names, table = fmu.outputs(), csv.writer(rows)
        table.writerow(["time", *names])

        def record(time):
            table.writerow([repr(time), *(repr(float(x)) for x in cloth.get(*names))])

        try:
            cloth.initialize(**settings)
            record(0.0)
            taken, count = go(cloth, plan, count, interval, record)
            before = len(cloth.log)
            cloth.status(cloth.slave.terminate)
            warned = [text for _, _, text in cloth.log[before:]]
        except Stopped:
            told = [text for status, _, text in cloth.log if status not in (OK, WARNING)]
            print(f"error: {told[-1] if told else ''}", file=sys.stderr)
            return 2
    (out / "taken.json").write_text(json.dumps({"at": taken, "count": count, "interval": interval}))
    print(*(f"error: {text}" for text in warned), sep="\n", end="\n" if warned else "", file=sys.stderr)
    return 2 if warned else 0


if __name__ == "__main__":
    sys.exit(main())
