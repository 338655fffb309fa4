"""The kinds of simulations. A seed names one: its kind is its place in a fixed list, all else is drawn from the seed."""
import math
import random

from . import motion
from .draft import Simulation, begin, dampen, direction, last, pin, scaled, throw, variants
from .fabrics import log_uniform, step_estimate

SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]


def plain(rng, sim):
    d = begin(rng, sim)
    pin(d)
    dampen(d)
    variants(d)
    last(d)


def thrown(rng, sim):
    d = begin(rng, sim)
    if rng.random() < 0.85:
        pin(d)
    throw(d)
    dampen(d)
    variants(d)
    last(d)


def drive_of(rng):
    return rng.choice(["position", "velocity", "both"])


def jerked(rng, sim):
    d = begin(rng, sim)
    pin(d, drive=drive_of(rng))
    dampen(d)
    variants(d)
    d.speed = 3.0  # the speed is drawn with the duration: about the middle
    until = last(d)
    moments, sim.path, speed = motion.jerk(rng, until, "pin.p", sim.scene["pin"][0]["drive"])
    finish_path(sim, moments, speed)


def shaken(rng, sim):
    d = begin(rng, sim)
    pin(d, drive=drive_of(rng))
    dampen(d)
    variants(d)
    d.speed = 2.0
    until = last(d)
    q = sim.facts["communication"]
    moments, sim.path, speed = motion.shake(rng, until, "pin.p", sim.scene["pin"][0]["drive"], q)
    finish_path(sim, moments, speed)


def rotating(rng, sim):
    d = begin(rng, sim)
    pin(d, "clamp", drive=drive_of(rng))
    dampen(d)
    variants(d)
    d.speed = 10 * d.size
    until = last(d)
    moments, sim.path, rate = motion.spin(rng, until, "pin.p", sim.facts["communication"])
    finish_path(sim, moments, rate * d.size)


def finish_path(sim, moments, speed):
    """Keeps the speed, and the path together with its moments."""
    at = sim.path
    sim.path = lambda start: (moments, at(start))
    sim.facts["speed"] = speed
    sim.facts["drive"] = sim.scene["pin"][0].get("drive", "") if sim.scene["pin"] else ""


def body(rng, sim):
    """A sphere, cube or bar below level cloth: it rises, or the cloth falls or is thrown on it."""
    d = begin(rng, sim, particles=(9, 900), how="level")
    d.cost = 3
    reach = d.size * log_uniform(rng, 0.15, 0.7)
    shape = rng.choice(["sphere", "cube", "bar"])
    if shape == "sphere":
        points, faces = motion.ball(reach)
    else:
        points, faces = motion.box(rng, [reach] * 3 if shape == "cube" else [2 * reach, reach / 5, reach / 5])
    sim.meshes["body.obj"] = motion.obj(points, faces)
    top = max(p[2] for p in points)
    gap = log_uniform(rng, 1, 20) * 1e-3 + 0.1 * d.cell
    centre = [rng.uniform(-0.2, 0.2) * d.size, rng.uniform(-0.2, 0.2) * d.size, -top - gap]
    item = {"name": "b", "mesh": "body.obj", "position": centre}
    if rng.random() < 0.3:
        item["damping"] = round(rng.uniform(0, 1), 2)
    if rng.random() < 0.3:
        item["friction"] = rng.choice([0.0, 0.5, [0.6, 0.4]])
    sim.scene["body"] = [item]
    if rng.random() < 0.5:
        pin(d)
    dampen(d)
    variants(d)
    how = rng.choice(["rises", "rises", "thrown", "falls"])
    sim.facts["body"] = f"{shape} {how}"
    if how == "rises":
        rising_body(rng, d, item)
        return
    if how == "thrown":
        throw(d)
        speed = d.speed
        sim.scene["piece"][0]["velocity"] = [0.3 * speed * rng.uniform(-1, 1), 0.3 * speed * rng.uniform(-1, 1), -speed]
    last(d)


def rising_body(rng, d, item):
    sim = d.sim
    drive = drive_of(rng)
    item |= {"moves": True, "drive": drive}
    speed = log_uniform(rng, 0.3, 50)
    way = [speed * x for x in (rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3), 1.0)]
    d.speed = speed
    until = last(d)
    stop = rng.uniform(0.3, 1) * min(until, 2 * d.size / speed)

    def place(t):
        return scaled(way, min(t, stop))

    def rate(t):
        return scaled(way, float(0 < t < stop))

    sim.path = motion.drawn_path("body.b", drive, place, rate)
    finish_path(sim, [0.0, min(1e-6, stop / 10), stop, stop + 1e-6, 2 * until], speed)
    sim.facts["drive"] = drive


def self_contact(rng, sim):
    """Cloth thrown about a pin, two sheets one of which falls on the other, or pins that approach each other."""
    how = rng.choice(["thrown", "two sheets", "pins approach"])
    d = begin(rng, sim, particles=(16, 500), how="level" if how == "two sheets" else None)
    sim.scene["scene"]["self_contact"] = True
    sim.facts["body"] = how
    d.cost = 6
    dampen(d)
    if how == "two sheets":
        pin(d, "two corners")
        other = dict(sim.scene["piece"][0], name="other", velocity=[0.0, 0.0, -log_uniform(rng, 0.3, 5)])
        gap = 3 * d.fabric.thickness + log_uniform(rng, 1e-4, 1e-2)
        other["place"] = {**other["place"], "origin": [0.1 * d.size, 0.05 * d.size, gap]}
        sim.scene["piece"].append(other)
        d.speed, d.particles = -other["velocity"][2], 2 * d.particles
        last(d)
        return
    pin(d, "two corners" if how == "pins approach" else None)
    if how == "thrown":
        throw(d, 0.3, 5)
        last(d)
        return
    sim.scene["pin"][0]["drive"] = "velocity"
    a, b = (p["at"][0] for p in sim.scene["pin"])
    axes = sim.scene["piece"][0]["place"]
    apart = [(b[0] - a[0]) * x + (b[1] - a[1]) * y for x, y in zip(axes["axis_x"], axes["axis_y"])]
    d.speed = log_uniform(rng, 0.1, 3)
    until = last(d)
    way, stop = scaled(apart, 1 / math.hypot(*apart)), 0.8 * math.hypot(*apart) / d.speed
    sim.path = motion.drawn_path("pin.p", "velocity", None, lambda t: scaled(way, d.speed * float(0 < t < stop)))
    finish_path(sim, sorted({0.0, min(1e-3, stop / 2), stop, stop + 1e-3, 2 * until + stop}), d.speed)


def seam(rng, sim):
    """Two quadrangles sewn along an edge; ease up to 2, cells that differ by up to 3, apart and turned."""
    d = begin(rng, sim, particles=(30, 600), how="level", loop=SQUARE)
    count, ease = log_uniform(rng, 30, 600), rng.choice([1.0, rng.uniform(1, 2)])
    length = d.cell * math.sqrt(count)
    ratio = rng.choice([1.0, log_uniform(rng, 1 / 1.7, 1.7)])
    pieces = sim.scene["piece"]
    pieces[0]["outline"] = d.corners = quadrangle(rng, length)
    turn, gap = rng.uniform(-0.5, 0.5), [rng.uniform(0, 0.1) * length for _ in range(3)]
    c, s = math.cos(turn), math.sin(turn)
    pieces.append({"name": "other", "fabric": "f", "cell": d.cell * ratio, "outline": quadrangle(rng, length * ease),
                   "grain": rng.choice([0.0, rng.uniform(-3, 3)]),
                   "place": {"origin": [length * 1.1 + gap[0], gap[1], gap[2]], "axis_x": [c, s, 0.0], "axis_y": [-s, c, 0.0]}})
    pieces[0]["grain"] = rng.choice([0.0, rng.uniform(-3, 3)])
    d.size, d.particles, d.cost = length, int(count * (1 + ease**2 / ratio**2)), 2
    d.cell = min(d.cell, d.cell * ratio)
    join = {"name": "j", "a": {"piece": "cloth", "edges": [1]}, "b": {"piece": "other", "edges": [3], "reverse": True}}
    if rng.random() < 0.3:
        join["tape"] = log_uniform(rng, 1, 1000)
    if rng.random() < 0.3:
        join["closed_at"] = log_uniform(rng, 1e-3, 0.05)
    sim.scene["seam"] = [join]
    if rng.random() < 0.5:
        pin(d, "corner")
    if rng.random() < 0.3:
        throw(d, 0.3, 5)
    d.speed = max(d.speed, 1.0)
    sim.facts["body"] = f"ease {ease:.2f}"
    dampen(d)
    last(d)
    sim.scene["scene"]["duration"] = 100.0  # by which the seam has to be closed: not within this run


def quadrangle(rng, length):
    """The right edge and the left one are `length` long, upright or leaning."""
    lean = rng.choice([0.0, rng.uniform(-0.2, 0.2)]) * length
    width = rng.uniform(0.5, 1.1) * length
    height = math.sqrt(length**2 - lean**2)
    return [[0.0, 0.0], [width, 0.0], [width + lean, height], [lean, height]]


def single_cell(rng, sim):
    w, h = rng.choice([1.0, rng.uniform(1, 1.6)]), rng.choice([1.0, rng.uniform(1, 1.6)])
    d = begin(rng, sim, loop=[[0, 0], [w, 0], [w, h], [0, h]])
    d.particles = 4
    if rng.random() < 0.8:
        pin(d, rng.choice(["corner", "two corners", "edge"]))
    if rng.random() < 0.7:
        throw(d)
    dampen(d)
    variants(d)
    last(d)


def long_communication(rng, sim):
    """The longest intervals, without inputs: rows, and advances, of 0.05 to 1 s; now and then 1 us."""
    d = begin(rng, sim, particles=(4, 60))
    pin(d)
    if rng.random() < 0.5:
        throw(d, 0.3, 5)
    dampen(d)
    variants(d)
    step = step_estimate(d.fabric, d.cell, d.speed, d.size)[0]
    longest = min(1.0, step * MOST_STEPS)
    q = 1e-6 if rng.random() < 0.2 else log_uniform(rng, longest / 20, longest)
    last(d, q, shortest=q)


MOST_STEPS = 2e5  # of an interval


def high_order(rng, sim):
    d = begin(rng, sim)
    order = sim.scene["scene"]["order"] = rng.choice([4, 6])
    d.cost = {4: 3, 6: 6}[order]
    driven = rng.random() < 0.3
    pin(d, **({"drive": drive_of(rng)} if driven else {}))
    if rng.random() < 0.5:
        throw(d)
    dampen(d, springs=False)
    variants(d)
    d.speed = max(d.speed, 2.0 if driven else 0.0)
    until = last(d)
    if driven:
        q, drive = sim.facts["communication"], sim.scene["pin"][0]["drive"]
        moments, sim.path, speed = motion.shake(rng, until, "pin.p", drive, q)
        finish_path(sim, moments, max(speed, d.speed))


def paper(rng, sim):
    """The scheme of the paper, with its other variants or without."""
    d = begin(rng, sim, particles=(9, 1500))
    sim.scene["scene"]["integrator"] = "paper"
    pin(d)
    if rng.random() < 0.4:
        throw(d)
    dampen(d, springs=False)
    if rng.random() < 0.3:
        sim.scene["options"] = {"scaling": "paper_area", "outline": "paper", "bias_model": "paper"}
    else:
        variants(d)
    last(d)


def wind(rng, sim):
    d = begin(rng, sim, how=rng.choice(["hanging", "any"]))
    sim.scene["air"] = {"normal": round(rng.uniform(0.1, 2), 2), "tangential": rng.choice([0.0, 0.1, 0.3])}
    pin(d)
    strength = log_uniform(rng, 1, 50)
    way = scaled(direction(rng), strength)
    sim.scene["scene"]["wind"] = way
    dampen(d)
    variants(d)
    d.speed = strength / 5
    until = last(d)
    sim.facts["speed"] = strength
    if rng.random() < 0.5:
        moments, sim.path = motion.gusts(rng, until, way)
        finish_path(sim, moments, strength)


def kinked(rng, sim):
    d = begin(rng, sim, rough=True)
    pin(d)
    if rng.random() < 0.5:
        throw(d, 0.3, 3)
    dampen(d)
    variants(d)
    last(d)


def tuned(rng, sim):
    """One to three groups of parameters go to an end of their range while the cloth moves; by FMPy."""
    d = begin(rng, sim, particles=(4, 300))
    pin(d)
    if rng.random() < 0.3:
        sim.scene["air"] = {"normal": 1.2, "tangential": 0.1}
    if rng.random() < 0.5:
        throw(d, 0.3, 3)
    dampen(d)
    until = last(d, communication=1e-5)
    steps = SECONDS_OF_TUNED / (5e-6 + 0.22e-6 * d.particles)
    sim.tuning = {
        "changes": [{"at": until * share, "group": rng.random(), "high": rng.random() < 0.5,
                     "ramp": rng.choice([0.0, 0.0, until * log_uniform(rng, 0.01, 1)])}
                    for share in sorted(rng.uniform(0, 0.7) for _ in range(rng.randint(1, 3)))],
        "steps": int(steps),
    }


SECONDS_OF_TUNED = 1.5


def large(rng, sim):
    d = begin(rng, sim, particles=(2e4, 1e6))
    pin(d)
    throw(d)
    dampen(d)
    d.cost = 0.3
    last(d)


KINDS = {
    "plain": (plain, 3), "thrown": (thrown, 6), "jerked pin": (jerked, 4), "shaken": (shaken, 4),
    "rotating clamp": (rotating, 3), "body": (body, 5), "self-contact": (self_contact, 3), "seam": (seam, 3),
    "single cell": (single_cell, 3), "long communication": (long_communication, 2), "order 4/6": (high_order, 3),
    "paper": (paper, 2), "wind": (wind, 3), "kinked": (kinked, 3), "tuned": (tuned, 2), "large": (large, 1),
}
SLOTS = [kind for kind, (_, share) in KINDS.items() for _ in range(share)]
random.Random("slots").shuffle(SLOTS)


def kind_of(seed):
    return SLOTS[seed % len(SLOTS)]


def simulation(seed):
    sim = Simulation(seed, kind_of(seed), {})
    KINDS[sim.kind][0](random.Random(f"simulation {seed}"), sim)
    return sim
