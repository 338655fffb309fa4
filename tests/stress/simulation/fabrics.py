"""Random fabrics: shipped ones, some like real ones, rough ones and straight ones.

Magnitudes. Areal density and bending rigidity: the 5, 25, 50, 75 and 95 % quantiles of 618 fabrics (Feng, Huang, Xu, Wang 2022,
Learning-Based Bending Stiffness Parameter Estimation by a Drape Tester, ACM Transactions on Graphics 41(6)). Ends of
diagrams: breaking limits of 50 mm strips in product standards, 12 to 20 % at 300 to 600 N per 0.15 kg/m2 (GOST 737-69 and
others; see examples/fabrics/cotton.toml), of which laboratory diagrams cover the first part.
"""
import math
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
SHIPPED = ("cotton", "half_wool", "plain_wool", "quilting_cotton", "wool")
SHARES = (0.05, 0.25, 0.5, 0.75, 0.95)
AREAL_DENSITY = (0.0307, 0.104, 0.197, 0.294, 0.488)  # kg/m2
WARP_RIGIDITY = (1.10e-6, 4.12e-6, 13.8e-6, 35.9e-6, 109.6e-6)  # N m
WEFT_RIGIDITY = (0.89e-6, 3.32e-6, 8.76e-6, 23.7e-6, 49.7e-6)  # N m
STRIP = 0.05  # m, width of the tensile specimen
SPECIMEN = 0.03  # m, width of the bending specimen


@dataclass
class Fabric:
    kind: str
    keys: dict  # of the scene
    density: float  # kg/m2
    thickness: float  # m
    rigidity: float  # N m, the larger one
    threads: list  # [(strain, N/m)] of warp and weft
    bias: list  # [(strain, N/m)]
    start: float = 0.0  # N/m, the steeper slope of warp and weft at zero
    rough_bias: bool = False  # no odd law has such a diagram; it is for bias_model "tension" and "paper"


def log_uniform(rng, low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def quantile(rng, values):
    """A value between the first and the last quantile, as frequent as among the fabrics that were measured."""
    share = rng.uniform(SHARES[0], SHARES[-1])
    k = max(i for i in range(len(SHARES) - 1) if SHARES[i] <= share)
    z = (share - SHARES[k]) / (SHARES[k + 1] - SHARES[k])
    return values[k] * (values[k + 1] / values[k]) ** z


def points(diagram):
    return [(e / 100, f / STRIP) for e, f in zip(diagram["elongation_percent"], diagram["force"])]


def diagram(strains, tensions):
    return {
        "elongation_percent": [0.0, *(100 * e for e in strains)],
        "force": [0.0, *(min(1e6, STRIP * t) for t in tensions)],
    }


def smooth_diagram(rng, end_strain, end_tension):
    """T = a e + b e^p, as yarns straighten first."""
    count, power, share = rng.randint(4, 25), rng.uniform(1.5, 3.5), rng.uniform(0.05, 0.6)
    strains = [end_strain * (k / count) for k in range(1, count + 1)]
    return diagram(strains, [end_tension * (share * e / end_strain + (1 - share) * (e / end_strain) ** power) for e in strains])


def trellis_diagram(rng, end_strain, modulus, noise):
    """The 45 degree strip of a trellis with the shear stress t = G g [1 + (g/g0)^2], g the shear angle: with the stretch
    l = sqrt(1 + sin g) along the pull, F/width = 2 t l/cos g. Slopes vary by the share `noise`. An odd law has to exist:
    diagrams of any shape have none."""
    count, bend = rng.randint(8, 24), rng.uniform(0.3, 1)
    strains, tensions, before, t = [], [], 0.0, 0.0
    for k in range(1, count + 1):
        stretch = 1 + end_strain * k / count
        g = math.asin(stretch**2 - 1)
        now = 2 * modulus * g * (1 + (g / bend) ** 2) * stretch / math.cos(g)
        t += (now - before) * rng.uniform(1 - noise, 1 + noise)
        before = now
        strains.append(stretch - 1)
        tensions.append(t)
    return diagram(strains, tensions)


ROUGH = ("plateau", "flat", "plain", "plain", "stiff")


def rough_diagram(rng, end_strain, slope):
    """Any diagram that does not fall: kinks, plateaus, nearly flat and very stiff parts, points at uneven distances."""
    count = rng.randint(2, 29)
    gaps = [log_uniform(rng, 0.03, 1) for _ in range(count)]
    strains, tensions, e, t = [], [], 0.0, 0.0
    for k, gap in enumerate(gaps):
        part = rng.choice(ROUGH)
        if k == 0 and part == "plateau":
            part = "flat"
        rise = {"plateau": 0.0, "flat": log_uniform(rng, 1e-3, 0.1), "plain": log_uniform(rng, 0.3, 3),
                "stiff": log_uniform(rng, 5, 100)}[part]
        step = end_strain * gap / sum(gaps)
        e, t = e + step, t + slope * rise * step
        strains.append(e)
        tensions.append(t)
    return diagram(strains, tensions)


def shipped(rng):
    name = rng.choice(SHIPPED)
    # Slopes for the estimate of the step only: N/m at small and at large strain.
    soft, stiff = {"cotton": (4e3, 4e4), "half_wool": (3e3, 1.5e4), "plain_wool": (1e3, 4e3), "quilting_cotton": (6e3, 4e4),
                   "wool": (1.6e4, 6e5)}[name]
    density = {"plain_wool": 0.168, "half_wool": 0.2}.get(name, 0.15)
    end = {"wool": 0.0136}.get(name, 0.06)
    law = [(0, 0), (end / 4, soft * end / 4), (end, soft * end / 4 + stiff * end * 3 / 4)]
    keys = {"file": str(ROOT / "examples" / "fabrics" / f"{name}.toml")}
    return Fabric(name, keys, density, 5e-4, 1.2e-5, law, [(0, 0), (0.07, 0.07 * 1000)])


def made(rng, kind):
    density = quantile(rng, AREAL_DENSITY)
    laws, rough_bias = {}, kind == "rough" and rng.random() < 0.5
    for way in ("warp", "weft"):
        end, tension = log_uniform(rng, 0.02, 0.2), density / 0.15 * log_uniform(rng, 300, 3000)
        if kind == "rough":
            laws[way] = rough_diagram(rng, end, tension / end)
        elif kind == "straight":
            laws[way] = diagram([end], [tension])
        else:
            laws[way] = smooth_diagram(rng, end, tension)
    end, modulus = log_uniform(rng, 0.05, 0.15), density / 0.15 * log_uniform(rng, 10, 150)
    if rough_bias:
        laws["bias"] = rough_diagram(rng, end, 4 * modulus)
    else:
        laws["bias"] = trellis_diagram(rng, end, modulus, 0.3 if kind == "rough" else 0.0)
    keys = {"areal_density": density, "thickness": log_uniform(rng, 1e-4, 1e-3), **laws}
    rigidity = [quantile(rng, WARP_RIGIDITY), quantile(rng, WEFT_RIGIDITY)] if rng.random() < 0.9 else [0.0, 0.0]
    if any(rigidity):
        keys["bending"] = {"rigidity_uN_cm2": [b * SPECIMEN * 1e10 for b in rigidity], "width": SPECIMEN}
    if rng.random() < 0.4:
        keys["compression"] = round(rng.uniform(0, 1), 3)
    if kind == "rough" and rng.random() < 0.5:
        keys["compression_blend"] = log_uniform(rng, 5e-4, 1e-2)
    if kind != "rough" and rng.random() < 0.1:
        del keys[rng.choice(["warp", "weft", "bias"])]
    threads = points(max((laws["warp"], laws["weft"]), key=lambda law: max_slope(points(law))))
    start = max(max_slope(points(laws[way]), 0) for way in ("warp", "weft"))
    return Fabric(kind, keys, density, keys["thickness"], max(rigidity), threads, points(laws["bias"]), start, rough_bias)


def max_slope(law, tension=math.inf):
    """N/m, the steepest part of a law that begins below a tension."""
    return max((t1 - t0) / (e1 - e0) for (e0, t0), (e1, t1) in zip(law, law[1:]) if t0 <= tension)


def random_fabric(rng, rough=None):
    kind = "rough" if rough else rng.choices(["shipped", "like real", "rough", "straight"], [3, 4, 2, 1])[0]
    fabric = shipped(rng) if kind == "shipped" else made(rng, kind)
    friction = rng.choice([None, 0.0, round(rng.uniform(0.05, 1), 2), [0.5, 0.3]])
    if friction is not None:
        fabric.keys["friction"] = friction
    return fabric


def step_estimate(fabric, cell, speed, length):
    """s, about the step that Drape will take: a third of 2/omega at the tension of a motion at `speed` of cloth of `length`.

    A wave of velocity v pulls with T = v sqrt(rho T'); the weight adds rho g times the length.
    """
    rho = fabric.density
    start = max_slope(fabric.threads, 0)
    tension = 3 * (speed * math.sqrt(rho * max(start, 1)) + rho * 9.81 * length)
    slope = max(max_slope(fabric.threads, tension), 1)
    inplane = (4 * slope + 8 * max_slope(fabric.bias, tension)) / (rho * cell**2)
    omega = math.sqrt(inplane + 32 * fabric.rigidity / (rho * cell**4))
    return 0.7 / omega, omega
