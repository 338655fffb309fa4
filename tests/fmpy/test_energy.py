"""The energy balance closes in runs that are hard on the step, and on the books."""
import sys

import pytest
from bodies import obj
from scenes import HORIZONTAL, ROOT, pin_points, sheet

sys.path.insert(0, str(ROOT / "tests" / "stress"))
from simulation import verdict  # noqa: E402


def balance(drape, write, scene, tmp_path, *options):
    """Largest balance error and largest fall of the energy dissipated, over the largest energy; and the rows."""
    scene["scene"]["energy"] = True
    drape("run", write(scene), "-o", tmp_path / "run", *options)
    rows = verdict.read_rows(tmp_path / "run" / "outputs.csv")
    _, error, fall = verdict.energies(rows)
    return error, fall, rows


def thrown_wool(velocity, duration):
    scene = sheet(0.04, 0.04, 0.01, HORIZONTAL, duration=duration)
    scene["piece"][0]["velocity"] = list(velocity)
    pin_points(scene, "pin", (0, 0.04), (0.04, 0.04))
    return scene


# At 0.4 of the step limit, cloth thrown like this gained 85 % of its energy.
@pytest.mark.parametrize("velocity", [(5, 3, 0), (1, 0, 0)])
def test_thrown_wool_keeps_its_energy(drape, write, tmp_path, velocity):
    error, _, _ = balance(drape, write, thrown_wool(velocity, 1.0), tmp_path)
    assert error < 0.01


# Undamped, slow and free, cloth takes 0.7 of the step limit once it has been seen to be calm.
def test_slow_wool_takes_long_steps_and_keeps_its_energy(drape, write, tmp_path):
    error, _, rows = balance(drape, write, thrown_wool((0.05, 0, 0), 0.5), tmp_path)
    assert error < 1e-3
    assert 0.5 < max(row["step.stability"] for row in rows[len(rows) // 2:]) <= 0.7


def kinked_strip():
    """Steep and flat parts of a diagram by turns, stressed at the start."""
    scene = sheet(0.01, 0.04, 0.004, HORIZONTAL, duration=0.01)
    kinks = {"elongation_percent": [0, 0.03, 0.05, 0.2, 0.25, 0.4], "force": [0, 6, 9, 36, 36.1, 40]}
    scene["fabric"]["wool"] |= {"areal_density": 0.05, "warp": kinks, "weft": kinks}
    scene["scene"]["imperfection"] = {"amplitude": 4e-4, "seed": 7}
    pin_points(scene, "pin", (0, 0))
    return scene


# The first step already knows the motion.
def test_kinks_keep_their_energy(drape, write, tmp_path):
    scene = kinked_strip()
    error, _, _ = balance(drape, write, scene, tmp_path)
    assert error < 0.01


BOX = [(x, y, z) for x in (-0.1, 0.1) for y in (-0.1, 0.1) for z in (-0.1, 0.0)]
BOX_FACES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


# A body is driven through a point that a pin holds: the pin takes the impulse of contact back in the same step, so
# contact does its work at the velocity that the pin leaves.
def test_body_that_presses_on_a_pin_dissipates(drape, write, tmp_path):
    (tmp_path / "box.obj").write_text(obj(BOX, BOX_FACES))
    scene = sheet(0.06, 0.06, 0.01, HORIZONTAL | {"origin": [-0.03, -0.03, 0]}, duration=0.05)
    pin_points(scene, "pin", (0.03, 0.03))
    scene["body"] = [{"name": "box", "mesh": "box.obj", "moves": True, "position": [0, 0, -0.03]}]
    inputs = tmp_path / "inputs.csv"
    inputs.write_text("time,body.box.position[3]\n0,-0.03\n0.05,0.0005\n")
    error, fall, rows = balance(drape, write, scene, tmp_path, "--inputs", inputs)
    assert max(row["contact.count"] for row in rows) > 0
    assert fall < 1e-9 and error < 0.01


# Steps of half the limit, whatever the motion, feed energy into kinks.
def test_energy_that_nothing_accounts_for_fails_the_run(drape, write, tmp_path):
    scene = kinked_strip()
    scene["scene"] |= {"energy": True, "step": 5e-7}
    done = drape("run", write(scene), "-o", tmp_path / "run", check=False)
    assert done.returncode == 2
    assert "that no force accounts for" in done.stderr and "allowed: at most 1 %" in done.stderr
