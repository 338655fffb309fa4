"""Seams through FMI: they close, at a time or by a parameter; the same bits; the reference solver sews too."""
import math
import subprocess
import sys

import numpy as np
import pytest
from master import DISCARD, Instance, same_bits
from scenes import ROOT, read_csv, two_strips

GAP, CLOSED, LENGTH = "seam.join.gap.max", "seam.join.closed", "seam.join.length"


def test_closes_and_stays_closed(pack):
    """Parts on cells of different size: after the seam has closed its gap is rounding, and its length that of the edge."""
    fmu = pack(two_strips(damping=5.0))
    with Instance(fmu) as cloth:
        cloth.initialize()
        assert cloth.get(CLOSED)[0] == 0
        assert cloth.get(GAP)[0] == pytest.approx(0.005)
        cloth.run(0.2, 0.001)
        gap, closed, length = cloth.get(GAP, CLOSED, LENGTH)
    assert closed == 1
    assert gap < 1e-12
    assert length == pytest.approx(0.06, rel=0.02)  # it hangs from one corner


@pytest.mark.parametrize("ease", [1.0, 1.2])
def test_grouping_of_steps(pack, ease):
    """120 intervals in 1, 12 or 120 calls, through pull and weld."""
    fmu = pack(two_strips(ease=ease), nodes="all")
    ends = []
    for calls in (1, 12, 120):
        with Instance(fmu) as cloth:
            cloth.initialize().run(0.12, 0.12 / calls)
            ends.append(cloth.get(*[n for n in fmu.outputs() if not n.startswith("pin.")]))
    assert same_bits(ends[0], ends[1])
    assert same_bits(ends[0], ends[2])


def test_states_before_and_after_the_weld(pack):
    """A state saved while the seam is open is restored after it has closed, and the reverse."""
    fmu = pack(two_strips(), nodes="all")
    with Instance(fmu) as cloth:
        cloth.initialize().run(0.004, 0.001)
        assert cloth.get(CLOSED)[0] == 0
        pulled = cloth.slave.getFMUState()
        cloth.run(0.15, 0.001)
        assert cloth.get(CLOSED)[0] == 1
        welded, end = cloth.slave.getFMUState(), cloth.nodes()
        cloth.run(0.2, 0.001)
        later = cloth.nodes()
        cloth.slave.setFMUState(pulled)
        cloth.time = 0.004
        assert cloth.get(CLOSED)[0] == 0
        assert same_bits(cloth.run(0.15, 0.001).nodes(), end)
        cloth.slave.setFMUState(welded)
        assert same_bits(cloth.run(0.2, 0.001).nodes(), later)
        cloth.slave.reset()
        cloth.time = 0.0
        assert same_bits(cloth.initialize().run(0.15, 0.001).nodes(), end)


def test_closed_when_told_to(pack):
    """A seam with closed_at = inf moves as no seam does until `close` is 1."""
    scene = two_strips()
    scene["seam"][0]["closed_at"] = math.inf
    fmu = pack(scene, nodes="all")
    del scene["seam"]
    loose = pack(scene, nodes="all", name="loose")
    with Instance(loose) as other:
        unsewn = other.initialize().run(0.02, 0.001).nodes()
    with Instance(fmu) as cloth:
        cloth.initialize().run(0.02, 0.001)
        assert same_bits(cloth.nodes(), unsewn)
        assert cloth.set("seam.join.close", 0.5) == DISCARD
        assert "seam.join.close is 0.5; allowed: a whole number from 0 to 1" in cloth.log[-1][2]
        cloth.set("seam.join.close", 1.0)
        cloth.run(0.3, 0.001)
        assert cloth.get(CLOSED)[0] == 1


def test_closed_at_a_time(drape, write, tmp_path):
    scene = two_strips(damping=5.0)
    scene["seam"][0] |= {"closed_at": 0.05, "tape": 5.0}
    drape("run", write(scene), "-o", tmp_path / "run", "--until", 0.25, "--every", 0.005)
    names, rows = read_csv(tmp_path / "run" / "outputs.csv")
    column = {name: rows[:, names.index(name)] for name in ("time", GAP, CLOSED)}
    assert (column[CLOSED][column["time"] < 0.0501] == 0).all()
    assert column[CLOSED][-1] == 1


def test_reference_sews_too(drape, write, tmp_path):
    """The reference solver's run of a sewn and pinned cloth, before and after the weld, to the error of the step. The seam
    closes gently, so that the cloth does not buckle, which no two runs do alike."""
    scene = two_strips(damping=5.0, energy=True)
    scene["seam"][0] |= {"pull": 400.0, "speed": 5.0}
    file = write(scene)
    for command, folder in (("run", "run"), ("reference", "judge")):
        drape(command, file, "-o", tmp_path / folder, "--until", 0.06, "--every", 0.006, "--nodes", "all")
    names, fast = read_csv(tmp_path / "run" / "outputs.csv")
    judged, exact = read_csv(tmp_path / "judge" / "outputs.csv")
    closed = fast[:, names.index(CLOSED)]
    assert np.array_equal(closed, exact[:, judged.index(CLOSED)])
    for k, name in enumerate(judged):
        if name.startswith(("node.position", "seam")):
            assert np.abs(fast[:, names.index(name)] - exact[:, k]).max() < 2e-5, name
    gone = exact[:, judged.index("energy.input")] - exact[:, judged.index("energy.dissipated")]
    assert np.abs(fast[:, names.index("energy.balance_error")]).max() < 0.05 * np.abs(gone).max()


def test_masses_tuned_after_the_weld(pack):
    """Twice as heavy once it is sewn: the welds hold with the new masses, and the peg bears twice as much."""
    fmu = pack(two_strips(damping=40.0))
    with Instance(fmu) as cloth:
        cloth.initialize().run(1.0, 0.001)
        assert cloth.get(CLOSED)[0] == 1
        light = cloth.get("pin.peg.force[3]")[0]
        cloth.set("fabric.wool.areal_density", 2 * cloth.get("fabric.wool.areal_density")[0])
        cloth.run(2.5, 0.001)
        gap, closed, heavy = cloth.get(GAP, CLOSED, "pin.peg.force[3]")
    assert closed == 1 and gap < 1e-12
    assert light == pytest.approx(-0.15 * 2 * 0.06 * 0.06 * 9.81, rel=0.05)
    assert heavy == pytest.approx(2 * light, rel=0.05)


def test_energy_of_a_weld_at_the_start(drape, write, tmp_path):
    """Sides within gap_tol at time 0 are sewn before the first step: the balance begins with the cloth as it is then."""
    drape("run", write(two_strips(gap=(5e-5, 0, 0), energy=True)), "-o", tmp_path / "run", "--until", 0.02, "--every", 0.001)
    names, rows = read_csv(tmp_path / "run" / "outputs.csv")
    column = {name: rows[:, names.index(name)] for name in names}
    assert (column[CLOSED][1:] == 1).all()
    fallen = column["energy.gravity"][0] - column["energy.gravity"][-1]
    assert fallen > 0
    assert np.abs(column["energy.balance_error"]).max() < 1e-3 * fallen
    assert np.abs(column["energy.input"]).max() < 1e-9 * fallen  # a peg that stays does no work, and the seam has done some


def test_paper_ties(drape, write, tmp_path):
    """Particles on the outlines tied by rigid links: the seam closes, and keeps its length to the links'."""
    scene = two_strips(damping=20.0) | {"options": {"outline": "paper"}}
    drape("run", write(scene), "-o", tmp_path / "run", "--until", 0.5, "--every", 0.05)
    names, rows = read_csv(tmp_path / "run" / "outputs.csv")
    assert rows[-1, names.index(CLOSED)] == 1
    assert rows[-1, names.index(LENGTH)] == pytest.approx(0.06, rel=1e-4)
    refused = drape("reference", write(scene), "-o", tmp_path / "judge", "--until", 0.01, check=False)
    assert refused.returncode == 1
    assert "ties seams by rigid links, which the reference does not have" in refused.stderr


def test_sides_of_very_different_length_are_told(drape, write):
    said = drape("check", write(two_strips(ease=1.6)))
    assert "seam join: 11 pairs of particles, 0.06 m to 0.096 m, ease 1.6" in said.stdout
    assert "warning: seam.join sews 0.06 m to 0.096 m: the longer side is 1.6 times the shorter" in said.stderr
    assert "warning: seam" not in drape("check", write(two_strips(ease=1.4))).stderr


def test_picture_shows_the_seam(drape, write, tmp_path):
    drape("check", write(two_strips()), "--picture", tmp_path / "two.svg")
    picture = (tmp_path / "two.svg").read_text()
    assert picture.count('class="seam"') == 2
    assert "join a" in picture and "join b" in picture and "seam, its particles and its start" in picture


@pytest.mark.parametrize("example", ["frill", "two_strips", "tube", "sleeve"])
def test_example(example, tmp_path):
    """The examples end with checks of their own."""
    run = ROOT / "examples" / example / "run.py"
    done = subprocess.run([sys.executable, run, tmp_path], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert (tmp_path / f"{example}.png").exists()


def test_random_pairs():
    """Three of the hundred pairs of the stress run."""
    done = subprocess.run([sys.executable, ROOT / "tests" / "stress" / "sewing.py", "--pairs", "3"], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
