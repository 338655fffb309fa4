"""Judges a run by its exit code, its sentence and its outputs.csv."""
import csv
import math
import re
from dataclasses import dataclass, field

MISSING = 0.01  # of the largest energy seen: more than this unaccounted for is a failure
FALLING = 1e-6  # of the same: dissipated energy may not fall by more
POTENTIALS = ("kinetic", "stretch", "shear", "bending", "contact", "input")
ORDER_TWO = 10  # a quarter of the step leaves 1/16 of an error of second order; at least a tenth counts

UNACCOUNTED = "that no force accounts for"  # so `drape run` ends a run that has missed energy, with exit code 2

# What can become of a run.
SOUND, STOPPED, UNEXPLAINED, HUNG, NOT_FINITE, MISSED, FELL = (
    "sound", "stopped", "no sentence", "hang", "not finite", "energy missing", "dissipation fell")


@dataclass
class Verdict:
    outcome: str
    sentence: str = ""  # where it stopped
    error: float = 0.0  # largest |energy.balance_error| over the largest energy seen
    fall: float = 0.0  # largest fall of energy.dissipated, over the same
    scale: float = 0.0  # J, the largest energy seen
    steps: float = 0.0
    time: float = 0.0  # s, of the last row
    smallest_step: float = 0.0  # s
    columns: dict = field(default_factory=dict)  # largest values, for the report


def read_rows(file):
    """The rows of an outputs.csv as dictionaries; a row that the end of a killed run cut off is left out."""
    if not file.exists():
        return []
    with open(file, newline="") as table:
        rows = list(csv.DictReader(table))
    return [{k: float(v) for k, v in row.items()} for row in rows if None not in row.values() and "" not in row.values()]


def sentences(text):
    return [line for line in text.splitlines() if line.startswith("error:")]


def pattern(sentence):
    """A sentence without its numbers and places, so that equal causes count together."""
    text = re.sub(r"^error: (\S*\.(toml|csv|obj)(:\d+)*: )?", "", sentence)
    return re.sub(r"[-+]?\d+(\.\d+)?(e[-+]?\d+)?", "#", text)[:160]


def energies(rows):
    """(scale, error, fall) of a run: see the README of this folder."""
    scale, error, fall, highest = 0.0, 0.0, 0.0, 0.0
    start = rows[0]["energy.gravity"]
    for row in rows:
        seen = sum(abs(row.get(f"energy.{kind}", 0.0)) for kind in POTENTIALS) + abs(row["energy.gravity"] - start)
        scale = max(scale, seen)
        error = max(error, abs(row["energy.balance_error"]))
        highest = max(highest, row["energy.dissipated"])
        fall = max(fall, highest - row["energy.dissipated"])
    return scale, error / scale if scale else float(error > 0), fall / scale if scale else float(fall > 0)


def judge(code, hung, text, rows):
    """The verdict on a run that ended with this exit code, wrote `text` to stderr and these rows."""
    v = Verdict(SOUND)
    if rows:
        v.steps, v.time = rows[-1]["step.count"], rows[-1]["time"]
        v.smallest_step = min(row["step.size"] for row in rows)
        v.columns = {"stability": max(row["step.stability"] for row in rows),
                     "strain": max(abs(row[f"strain.{way}.{end}"]) for row in rows for way in ("warp", "weft", "bias")
                                   for end in ("min", "max") if f"strain.{way}.{end}" in row)}
    finite = all(math.isfinite(x) for row in rows for x in row.values())
    if rows and finite:
        v.scale, v.error, v.fall = energies(rows)
    told = sentences(text)
    if hung:
        v.outcome = HUNG
    elif not finite:
        v.outcome = NOT_FINITE
    elif code == 2 and len(told) == 1 and UNACCOUNTED in told[0] and v.error > MISSING:
        v.outcome, v.sentence = MISSED, told[0]
    elif code != 0:
        expected = told if code == 1 else told[:1]  # a refused scene has a sentence for each problem
        said = told and told == expected and all(len(line) > len("error: ") + 10 for line in told)
        v.outcome = STOPPED if code in (1, 2) and said else UNEXPLAINED
        v.sentence = told[0] if told else f"exit code {code}: {text.strip()[-200:]}"
    elif len(rows) < 2:
        v.outcome, v.sentence = UNEXPLAINED, "exit code 0, but fewer than two rows"
    elif v.error > MISSING:
        v.outcome = MISSED
    elif v.fall > FALLING:
        v.outcome = FELL
    return v
