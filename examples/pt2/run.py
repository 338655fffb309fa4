"""A strip of quilting cotton on the PT-2: FMPy lifts the support, and the wings hang down from it.

Packs scene.toml as an FMU, lifts the support by 20 mm, waits until the strip is at rest, reads the drop of its ends and
the force on the support, works out EI, draws the strip, and checks drop and weight.

    .venv/bin/python examples/pt2/run.py [FOLDER]      results go to FOLDER, default build/pt2
"""
import os
import sys
import tomllib
from pathlib import Path

os.environ.setdefault("MPLBACKEND", "Agg")

import numpy as np
from matplotlib import pyplot

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from stage import ROOT, drape, opened

LIFT, WING, SUPPORT, WIDTH, G = 0.02, 0.07, 0.02, 0.03, 9.81  # m, m/s^2


def elastica(delta, step=1e-2):
    """The heavy elastica whose end hangs at the angle delta from the vertical: beta, and its course [points x 2] out and
    down from the clamp, over l. With v from the free end: phi'' = v sin phi, phi(0) = delta, phi'(0) = 0, and phi =
    pi/2 at v = beta^(1/3). Runge and Kutta's fourth order."""
    rate = lambda v, y: np.array([y[1], v * np.sin(y[0]), np.sin(y[0]), np.cos(y[0])])
    v, course = 0.0, [np.array([delta, 0.0, 0.0, 0.0])]
    while course[-1][0] < np.pi / 2:
        y = course[-1]
        k1 = rate(v, y)
        k2 = rate(v + step / 2, y + step / 2 * k1)
        k3 = rate(v + step / 2, y + step / 2 * k2)
        k4 = rate(v + step, y + step * k3)
        course.append(y + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4))
        v += step
    a, b = course[-2], course[-1]
    u = (np.pi / 2 - a[0]) / (b[0] - a[0])
    course[-1] = a + u * (b - a)
    length = v - step + u * step
    places = np.array([y[2:] for y in course])
    return length**3, (places[-1] - places)[::-1] / length


def elastica_where(quantity, wanted):
    """By bisection in the logarithm of delta; the quantity rises as the end comes nearer to the vertical."""
    low, high = 1e-9, 40.0
    for _ in range(40):
        middle = (low + high) / 2
        if quantity(*elastica(np.pi / 2 * np.exp(-middle))) < wanted:
            low = middle
        else:
            high = middle
    return elastica(np.pi / 2 * np.exp(-low))


def hang(fmu):
    """Lifts the support within the first step; the outputs at rest by name."""
    with opened(fmu) as strip:
        strip.set({"pin.support.position[3]": LIFT})
        strip.rest()
        return dict(zip(strip.outputs, strip.get(*strip.outputs)))


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build" / "pt2"
    folder.mkdir(parents=True, exist_ok=True)
    fmu = folder / "pt2.fmu"
    drape("pack", HERE / "scene.toml", "-o", fmu)
    fabric = tomllib.loads((ROOT / "examples" / "fabrics" / "quilting_cotton.toml").read_text())
    rigidity, density = fabric["bending"]["rigidity_uN_cm2"][0], fabric["areal_density"]
    row = hang(fmu)

    ends = np.array([[row[f"probe.{side}.position[{k}]"] for k in (2, 3)] for side in ("left", "right")])
    drop = LIFT - ends[:, 1].mean()
    load = density * WIDTH * G * WING**3 * 1e10  # uN cm2: beta EI
    beta, shape = elastica_where(lambda b, _: b, load / rigidity)
    read = elastica_where(lambda _, places: places[-1, 1], drop / WING)[0]
    weight = density * WIDTH * (2 * WING + SUPPORT) * G
    carried = -row["pin.support.force[3]"]
    print(f"drop of the ends f = {1e3 * drop:.2f} mm, f/l = {drop / WING:.4f}; the elastica's {1e3 * WING * shape[-1, 1]:.2f} mm")
    print(f"EI = {load:.4g}/A(f/l) = {load:.4g}/{read:.2f} = {load / read:.0f} uN cm2; put in: {rigidity} uN cm2")
    print(f"the support carries {1e3 * carried:.4f} mN, the strip weighs {1e3 * weight:.4f} mN")

    figure, panel = pyplot.subplots(figsize=(6, 3.4), layout="constrained")
    for side in (-1, 1):
        panel.plot(1e3 * side * (SUPPORT / 2 + WING * shape[:, 0]), 1e3 * (LIFT - WING * shape[:, 1]), color="#1c5fc0",
                   label="heavy elastica" if side > 0 else None)
    panel.plot(1e3 * (ends[:, 0] - WING - SUPPORT / 2), 1e3 * ends[:, 1], "o", color="#c0281c", fillstyle="none", label="ends of the strip")
    panel.plot([-1e3 * SUPPORT / 2, 1e3 * SUPPORT / 2], [1e3 * LIFT] * 2, color="black", linewidth=4, solid_capstyle="butt")
    panel.set(aspect="equal", xlabel="mm", ylabel="mm", xlim=(-45, 45))
    panel.grid(alpha=0.3)
    panel.legend(loc="center")
    figure.savefig(folder / "pt2.png", dpi=90)

    assert row["fit.residual"] <= 1e-5, "the strip is not at rest"
    assert abs(carried / weight - 1) < 1e-4, "the support does not carry the strip"
    # of second order in the cell: 1.9e-3 of l at b = l/28, 4.8e-4 at l/56
    assert abs(drop / WING - shape[-1, 1]) < 2.5e-3, "the ends are not where the elastica ends"


if __name__ == "__main__":
    main()
