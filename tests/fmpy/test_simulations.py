"""The random simulations of the stress suite: what its judge finds in planted outputs, and a dozen of the seeds."""
import subprocess
import sys

import pytest
from scenes import ROOT

sys.path.insert(0, str(ROOT / "tests" / "stress"))
import simulations  # noqa: E402
from simulation import kinds, report, run, verdict  # noqa: E402

SUITE = ROOT / "tests" / "stress" / "simulations.py"
COLUMNS = ("time", "step.count", "step.size", "step.stability", "strain.warp.min", "strain.warp.max", "energy.kinetic",
           "energy.stretch", "energy.shear", "energy.bending", "energy.gravity", "energy.dissipated", "energy.input",
           "energy.balance_error")
SENTENCE = "error: by 0.1 s the seam 'j' has not closed: its largest gap is 0.01 m"
TOLD = f"error: at 1 s the cloth has lost 0.04 J {verdict.UNACCOUNTED}, 2 % of its largest energy"


def planted(file, rows):
    """An outputs.csv of a fall from 5 J of gravity, with these values put in: [{column: value}], a row each."""
    lines = [",".join(COLUMNS)]
    for k, row in enumerate(rows):
        values = dict.fromkeys(COLUMNS, 0.0) | {"time": 0.1 * k, "step.count": 100 * k, "step.size": 1e-3,
                                                "energy.gravity": 5.0 - k, "energy.kinetic": k}
        lines.append(",".join(str(x) for x in (values | row).values()))
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text("\n".join(lines) + "\n")
    return file


# At the end 1 J is kinetic and 1 J has come from gravity: 2 J are the largest energy seen.
@pytest.mark.parametrize("rows, outcome", {
    "sound": ([{}, {"energy.balance_error": 0.019, "energy.dissipated": 1e-6}], verdict.SOUND),
    "2 % missing": ([{}, {"energy.balance_error": -0.04}], verdict.MISSED),
    "2 % missing in between": ([{}, {"energy.balance_error": 0.08}, {}], verdict.MISSED),
    "NaN": ([{}, {"energy.shear": "nan"}], verdict.NOT_FINITE),
    "infinite": ([{}, {"strain.warp.max": "inf"}], verdict.NOT_FINITE),
    "falling dissipation": ([{"energy.dissipated": 0.1}, {"energy.dissipated": 0.1 - 1e-5}], verdict.FELL),
    "falls by rounding": ([{"energy.dissipated": 0.1}, {"energy.dissipated": 0.1 - 1e-6}], verdict.SOUND),
    "one row": ([{}], verdict.UNEXPLAINED),
}.values())
def test_planted_outputs(tmp_path, rows, outcome):
    rows = verdict.read_rows(planted(tmp_path / "outputs.csv", rows))
    assert verdict.judge(0, False, "", rows).outcome == outcome


@pytest.mark.parametrize("code, hung, text, outcome", [
    (2, False, SENTENCE, verdict.STOPPED), (1, False, SENTENCE, verdict.STOPPED), (2, False, "", verdict.UNEXPLAINED),
    (2, False, "error: \n", verdict.UNEXPLAINED), (2, False, SENTENCE + "\n" + SENTENCE, verdict.UNEXPLAINED),
    (2, False, TOLD, verdict.STOPPED), (-11, False, "", verdict.UNEXPLAINED), (-9, True, "", verdict.HUNG)])
def test_ends(tmp_path, code, hung, text, outcome):
    rows = verdict.read_rows(planted(tmp_path / "outputs.csv", [{}, {}]))
    assert verdict.judge(code, hung, text, rows).outcome == outcome


def test_run_that_tells_of_its_energy(tmp_path):
    rows = verdict.read_rows(planted(tmp_path / "outputs.csv", [{}, {"energy.balance_error": -0.04}]))
    judged = verdict.judge(2, False, TOLD, rows)
    assert judged.outcome == verdict.MISSED and judged.sentence == TOLD


def test_row_cut_off(tmp_path):
    file = planted(tmp_path / "outputs.csv", [{}, {}, {}])
    file.write_text(file.read_text()[:-20])
    assert len(verdict.read_rows(file)) == 2


@pytest.mark.parametrize("command", ["while :; do :; done", "sleep 60"])
def test_hang(tmp_path, command):
    assert run.watched(["bash", "-c", command], tmp_path, 1).hung


def row(seed, kind="plain", outcome=verdict.SOUND, **values):
    return {"seed": seed, "kind": kind, "outcome": outcome, "error": "0", "steps": "100", "sentence": "", **values}


@pytest.mark.parametrize("bad, fails", [
    (row(7), False), (row(7, outcome=verdict.MISSED, error="0.02"), True), (row(7, outcome=verdict.HUNG), True),
    (row(7, "body", verdict.MISSED, error="0.02"), False), (row(7, "body", verdict.NOT_FINITE), True),
    (row(7, outcome=verdict.UNEXPLAINED), True), (row(7, outcome=verdict.FELL), True), (row(7, "self-contact", verdict.FELL), False),
    (row(7, outcome=verdict.STOPPED, sentence=SENTENCE), False),
    (row(7, outcome=verdict.MISSED, error="0.02", sentence=TOLD), False)])
def test_what_fails(bad, fails):
    rows = [bad, *(row(seed) for seed in range(100, 199))]
    assert bool(report.failures(rows)) == fails
    assert "seeds 7" in " ".join(report.failures(rows)) or not fails


def test_share_that_may_stop():
    stopped = [row(seed, outcome=verdict.STOPPED, sentence=SENTENCE) for seed in range(2)]
    assert report.failures([*stopped, *(row(seed) for seed in range(100, 298))]) == []
    assert "2 of 199" in report.failures([*stopped, *(row(seed) for seed in range(100, 297))])[0]
    assert "the seam 'j' has not closed: its largest gap is # m | 2 | 0, 1 |" in report.by_sentence(stopped)


def test_bookkeeping():
    """A sixteenth is left with a quarter of the step; only driven pins have their work summed."""
    missed = row(1, outcome=verdict.MISSED, error="0.032", error_quarter="0.002", drive="position")
    assert report.bookkeeping(missed) and report.falls(missed)
    assert report.falls(missed | {"drive": ""}) and not report.bookkeeping(missed | {"drive": ""})
    assert not report.falls(missed | {"error_quarter": "0.008"})
    assert not report.falls(missed | {"error_quarter": ""})


def test_comparison():
    old = [row(seed, steps="100") for seed in range(21)]
    new = [row(seed, steps=str(100 + seed)) for seed in range(20)] + [row(20, outcome=verdict.HUNG)]
    old.append(row(21, steps="100", scene="that of an older suite"))
    new.append(row(21, steps="900", scene="another"))
    told = report.compared(new, old)
    assert "20 seeds sound in both: median 1.100, 95 % 1.180, worst 1.190 (seed 19)" in told
    assert "seed 20, plain: sound -> hang" in told


def test_seeds_repeat():
    """A seed is the same simulation every time, and all kinds are among the first fifty."""
    again = [kinds.simulation(seed) for seed in range(50)]
    for seed, sim in enumerate(again):
        same = kinds.simulation(seed)
        assert (sim.scene, sim.until, sim.every, sim.settings, sim.tuning) == (
            same.scene, same.until, same.every, same.settings, same.tuning)
    assert {sim.kind for sim in again} == set(kinds.KINDS)


def test_shards_and_kinds():
    """Shards share out the seeds; a kind takes its own."""

    def chosen(*arguments):
        return simulations.chosen(simulations.options_of(arguments))

    parts = [chosen("--seeds", "10:121", "--shard", f"{k}/4") for k in (1, 2, 3, 4)]
    assert [seed for part in parts for seed in part] == list(range(10, 121))
    bodies = chosen("--seeds", "0:100", "--kind", "body")
    assert len(bodies) == 10 and all(kinds.kind_of(seed) == "body" for seed in bodies)


@pytest.mark.parametrize("words", [("--seeds", "5:5"), ("--seeds", "5"), ("--shard", "3/2"), ("--kind", "bodies")])
def test_bad_words(words):
    done = suite(*words)
    assert done.returncode != 0 and f"argument {words[0]}: " in done.stderr


def suite(*arguments):
    return subprocess.run([sys.executable, SUITE, *map(str, arguments)], capture_output=True, text=True)


@pytest.mark.parametrize("missing, code", [(0.001, 0), (0.04, 1)])
def test_exit_code(tmp_path, missing, code):
    """A command that writes planted outputs in place of drape; a quarter of its step leaves a sixteenth of the error."""
    for name, error in (("first", missing), ("again", missing / 16)):
        planted(tmp_path / f"{name}.csv", [{}, {"energy.balance_error": error}])
    fake = tmp_path / "drape"
    fake.write_text(f"""#!/bin/bash
[[ $1 == run ]] || exit 1
mkdir -p "$4"
case $4 in */out) cp {tmp_path}/first.csv "$4"/outputs.csv ;; *) cp {tmp_path}/again.csv "$4"/outputs.csv ;; esac
""")
    fake.chmod(0o755)
    seed = next(seed for seed in range(50) if kinds.kind_of(seed) == "plain")
    done = suite("--drape", fake, "--seed", seed, "--folder", tmp_path / "kept", "--report", tmp_path / "table.csv")
    assert done.returncode == code, done.stdout + done.stderr
    assert (tmp_path / "kept" / str(seed) / "scene.toml").exists()
    table = report.read(tmp_path / "table.csv")
    assert [r["seed"] for r in table] == [seed]
    assert report.falls(table[0]) == bool(code)


def test_a_dozen_seeds(tmp_path):
    """Of most kinds one; each takes about a second."""
    done = suite("--seeds", "0:12", "--jobs", 2, "--report", tmp_path / "table.csv")
    assert done.returncode == 0, done.stdout + done.stderr
    assert len(report.read(tmp_path / "table.csv")) == 12


def test_soak():
    """A twentieth of the soak: memory, energy and clock of a long run."""
    done = subprocess.run([sys.executable, ROOT / "tests" / "stress" / "soak.py", "--steps", "1e6"], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
