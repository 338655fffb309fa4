"""Order of convergence against ARKODE; see convergence.py for the scene and the error."""
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


def compared(name, exact):
    """The judge chooses its own steps, and keeps no balance."""
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
