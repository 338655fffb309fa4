"""Order of convergence against ARKODE; see convergence.py for the scene and the error."""
from dataclasses import replace

import pytest
from convergence import CASES, COMMUNICATION, SWINGING, last_row, measure, reference, slope
from scenes import swinging_sheet


ORDER = {"leapfrog": 2.0, "paper": 1.0}


@pytest.mark.parametrize("integrator, order", ORDER.items())
def test_order(undamped, integrator, order):
    assert slope(undamped[integrator]) == pytest.approx(order, abs=0.05)


@pytest.mark.parametrize("integrator, order", ORDER.items())
def test_order_with_damping(tmp_path, integrator, order):
    assert slope(measure(tmp_path, integrator=integrator, damping=20.0)) == pytest.approx(order, abs=0.05)


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_order_of_the_whole_cloth(tmp_path, case):
    assert slope(measure(tmp_path, case)) == pytest.approx(2.0, abs=0.05)


@pytest.mark.parametrize(
    "name, steps, halvings",
    [("concave piece with a hole, grain 20 degrees", 25, 2), ("driven clamp", 50, 1)],
)
def test_order_4(tmp_path, name, steps, halvings):
    """Down to 8 us, where rounding begins to show (3e-14 m); the driven clamp from 16 us, since at 32 us the crossings of
    diagram points, where the law's third derivative jumps, still weigh (3.4 from 32 to 16 us, 3.9 on, 4.0 on)."""
    case = replace(CASES[name], steps=steps, halvings=halvings)
    assert slope(measure(tmp_path, case, order=4)) == pytest.approx(4.0, abs=0.3)


@pytest.mark.parametrize("damping", [0.0, 20.0])
def test_order_6(tmp_path, damping):
    """At 32 us, beyond leapfrog's own limit of 30 us, rounding is all that is left: coordinates of 1 m in a thousand steps
    of eleven kicks, 1e-16 m each, walk at random by 1e-14 m. Its order shows on softer cloth (composition_test.cpp)."""
    table = measure(tmp_path, replace(SWINGING, steps=25, halvings=0), order=6, damping=damping)
    assert table[0, 1] < 3e-14


def compared(name, exact):
    """The reference solver chooses its own steps, and has no energy balance."""
    return name in exact and not name.startswith(("time", "step."))


def test_every_output_converges_to_the_reference(drape, write, tmp_path):
    """With two steps h and h/2 an output of order 2 has (error at h) / (error at h/2) = 4 [1 + O((h omega)^2/16)], and
    h omega is 0.8 for the fastest motion of the lattice."""
    exact = reference(tmp_path, energy=True, damping=20.0)
    until = SWINGING.until
    errors = []
    for step in (SWINGING.longest_step / 2, SWINGING.longest_step / 4):
        scene = write(swinging_sheet(communication=COMMUNICATION, step=step, energy=True, damping=20.0))
        drape("run", scene, "-o", tmp_path / "run", "--until", until, "--every", until)
        row = last_row(tmp_path / "run" / "outputs.csv")
        errors.append({name: abs(row[name] - exact[name]) for name in row if compared(name, exact)})
    names = [name for name in errors[0] if errors[0][name] > 0]
    ratio = {name: errors[0][name] / errors[1][name] for name in names}
    assert len(ratio) >= 20
    assert ratio == {name: pytest.approx(4.0, rel=0.04) for name in ratio}
