"""Tables of the suite: a row of CSV for each run, a table by kind, a comparison with another run of the suite."""
import csv

from .verdict import (FELL, HUNG, MISSED, NOT_FINITE, ORDER_TWO, SOUND, STOPPED, UNEXPLAINED, pattern)

APART = ("body", "self-contact")  # kinds whose energies are counted apart
STOPPED_SHARE = 0.01  # of all runs that may stop

COLUMNS = ("seed", "kind", "outcome", "error", "error_quarter", "fall", "scale", "steps", "time", "seconds", "stability",
           "strain", "fabric", "cell", "outline", "particles", "speed", "drive", "body", "communication", "scene", "exit",
           "sentence")


def number(row, key):
    return float(row[key]) if row.get(key) not in (None, "") else None


def falls(row):
    """Whether missing energy falls with the step, at least as an error of order 2 does."""
    quarter = number(row, "error_quarter")
    return row["outcome"] == MISSED and quarter is not None and number(row, "error") >= ORDER_TWO * quarter


def bookkeeping(row):
    """Whether it is the work of driven pins that is summed too coarsely, as far as that can be seen from outside."""
    return falls(row) and bool(row.get("drive")) and row["kind"] not in APART


def told(row):
    """Whether a run itself told that it misses energy; with contact these are counted apart."""
    return row["outcome"] == MISSED and bool(row["sentence"]) and row["kind"] not in APART


def failures(rows):
    """What makes the suite fail, a sentence each."""
    said = []
    for outcome, text in ((NOT_FINITE, "not finite"), (HUNG, "hung"), (UNEXPLAINED, "ended without one sentence")):
        seeds = [row["seed"] for row in rows if row["outcome"] == outcome]
        if seeds:
            said.append(f"{len(seeds)} runs {text}: seeds {listed(seeds)}")
    for outcome, text in ((MISSED, "miss more than 1 % of their energy"), (FELL, "had dissipation fall")):
        seeds = [row["seed"] for row in rows if row["outcome"] == outcome and row["kind"] not in APART and not row["sentence"]]
        if seeds:
            said.append(f"{len(seeds)} runs without contact {text}: seeds {listed(seeds)}")
    stopped = [row["seed"] for row in rows if row["outcome"] == STOPPED or told(row)]
    if len(stopped) > max(1, STOPPED_SHARE * len(rows)):
        said.append(f"{len(stopped)} of {len(rows)} runs stopped, more than 1 %: seeds {listed(stopped)}")
    return said


def listed(seeds, most=30):
    return ", ".join(str(s) for s in seeds[:most]) + (", ..." if len(seeds) > most else "")


def by_kind(rows):
    """A Markdown table."""
    lines = ["| kind | runs | sound | stopped | no sentence | not finite | hang | over 1 % | of these falls with h | driven pins "
             "| dissipation fell | worst seed | worst | steps |", "|---|" + "---:|" * 13]
    kinds = sorted({row["kind"] for row in rows})
    for kind in [*kinds, "all"]:
        part = [row for row in rows if kind in (row["kind"], "all")]
        counts = [sum(row["outcome"] == o for row in part) for o in (SOUND, STOPPED, UNEXPLAINED, NOT_FINITE, HUNG, MISSED)]
        ended = [row for row in part if row["outcome"] in (SOUND, MISSED, FELL)]
        worst = max(ended, key=lambda row: number(row, "error"), default=None)
        cells = [kind, len(part), *counts, sum(falls(row) for row in part),
                 sum(bookkeeping(row) for row in part), sum(row["outcome"] == FELL for row in part),
                 worst["seed"] if worst else "", f"{number(worst, 'error'):.1e}" if worst else "",
                 f"{sum(number(row, 'steps') for row in part):.0f}"]
        lines.append("| " + " | ".join(str(c) for c in cells) + " |")
    return "\n".join(lines)


def by_sentence(rows):
    """How often each sentence ended a run, numbers left out."""
    found = {}
    for row in rows:
        if row["sentence"]:
            found.setdefault(pattern(row["sentence"]), []).append(row["seed"])
    lines = ["| sentence | runs | seeds |", "|---|---:|---|"]
    lines += [f"| {text} | {len(seeds)} | {listed(seeds, 8)} |" for text, seeds in sorted(found.items(), key=lambda x: -len(x[1]))]
    return "\n".join(lines) if found else ""


def compared(rows, other):
    """How many steps each took, over the steps of the other, for seeds that were sound in both."""
    before = {(row["seed"], row.get("scene")): row for row in other}
    ratios, changed = [], []
    for row in rows:
        old = before.get((row["seed"], row.get("scene")))
        if old and row["outcome"] != old["outcome"]:
            changed.append(f"  seed {row['seed']}, {row['kind']}: {old['outcome']} -> {row['outcome']}")
        elif old and row["outcome"] == SOUND and number(old, "steps"):
            ratios.append((number(row, "steps") / number(old, "steps"), row["seed"]))
    ratios.sort()
    if not ratios:
        return "\n".join(["no seed is the same simulation and sound in both", *changed])
    middle, high, (worst, seed) = ratios[len(ratios) // 2][0], ratios[int(0.95 * (len(ratios) - 1))][0], ratios[-1]
    text = [f"steps over those of the other run, {len(ratios)} seeds sound in both: median {middle:.3f}, 95 % {high:.3f}, "
            f"worst {worst:.3f} (seed {seed})"]
    return "\n".join(text + changed)


def whole(rows):
    return "\n\n".join(part for part in (by_kind(rows), by_sentence(rows)) if part)


def read(file):
    with open(file, newline="") as table:
        return [row | {"seed": int(row["seed"])} for row in csv.DictReader(table)]


def write(file, rows):
    """Appears whole: the suite may be ended at any time."""
    part = file.with_name(file.name + ".part")
    if file.suffix == ".md":
        part.write_text(whole(rows) + "\n")
    else:
        with open(part, "w", newline="") as table:
            out = csv.DictWriter(table, COLUMNS, restval="", extrasaction="ignore")
            out.writeheader()
            out.writerows(rows)
    part.replace(file)
