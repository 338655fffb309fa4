"""What all kinds of simulations share: cloth on a grid, its place, its pins, and a duration that fits the budget."""
import math
import zlib
from dataclasses import dataclass, field
from typing import Callable

from . import fabrics, outlines
from .fabrics import log_uniform

CELLS = (0.00125, 0.04)  # m
COMMUNICATION = (1e-6, 1e-5, 1e-4, 5e-4, 1e-3, 2e-3, 5e-3, 1e-2)  # s
SECONDS = (0.4, 1.6)  # of processor time, from which the duration is found
STEP_COST, PARTICLE_COST = 5e-6, 0.22e-6  # s, of a step and of a particle in it, with energies
LONGEST = 5.0  # s, of simulated time
ROWS = 40


@dataclass
class Simulation:
    seed: int
    kind: str
    scene: dict
    until: float = 0.0
    every: float = 0.0
    settings: list = field(default_factory=list)  # NAME=VALUE
    meshes: dict = field(default_factory=dict)  # file: OBJ text
    path: Callable | None = None  # start values -> (times, function of time that gives the inputs)
    tuning: dict | None = None  # of a run by FMPy
    facts: dict = field(default_factory=dict)  # columns of the report


def fingerprint(sim):
    """Equal where two versions of the suite make the same simulation of a seed."""
    told = repr((sim.scene, sim.until, sim.every, sim.settings, sim.meshes, sim.tuning, sim.facts))
    return f"{zlib.crc32(told.replace(str(fabrics.ROOT), '').encode()):08x}"


@dataclass
class Draft:
    rng: object
    sim: Simulation
    fabric: fabrics.Fabric
    cell: float
    size: float  # m, of a square of the same area
    particles: int
    corners: list  # m, of the outline of the first piece
    speed: float = 0.0  # m/s, the fastest that is told to move
    cost: float = 1.0  # of a step, over that of the same cloth without contact


def direction(rng):
    """A unit vector, all directions alike."""
    z, t = rng.uniform(-1, 1), rng.uniform(0, 2 * math.pi)
    r = math.sqrt(1 - z * z)
    return [r * math.cos(t), r * math.sin(t), z]


def scaled(vector, factor):
    return [factor * x for x in vector]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def place(rng, how=None):
    how = how or rng.choice(["level", "hanging", "any"])
    if how == "level":
        x, y = [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]
    elif how == "hanging":
        x, y = [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]
    else:
        x = direction(rng)
        y = cross(x, direction(rng))
        y = scaled(y, 1 / math.hypot(*y))
    return {"origin": [0.0, 0.0, 0.0], "axis_x": x, "axis_y": y}


def begin(rng, sim, *, particles=(16, 2500), rough=None, how=None, loop=None):
    """A draft with one piece: a random outline, or `loop` on a cell of random size."""
    fabric = fabrics.random_fabric(rng, rough)
    cell = log_uniform(rng, *CELLS)
    holes, grain, number = [], 0.0, None
    if loop is None:
        number = rng.randrange(outlines.COUNT)
        shape, holes, grain = outlines.outline(number)
        count = log_uniform(rng, *particles)
        factor = cell * math.sqrt(count / outlines.area(shape))
    else:
        shape, factor = loop, cell
        count = outlines.area(shape) + 3
    corners, holes = [scaled(p, factor) for p in shape], [[scaled(p, factor) for p in hole] for hole in holes]
    if "thickness" in fabric.keys:
        fabric.keys["thickness"] = fabric.thickness = min(fabric.thickness, 0.2 * cell)
    piece = {"name": "cloth", "fabric": "f", "cell": cell, "outline": corners, "grain": grain, "place": place(rng, how)}
    if holes:
        piece["holes"] = holes
    options = {"bias_model": rng.choice(["tension", "paper"])} if fabric.rough_bias else {}
    sim.scene = {"scene": {"name": "s", "energy": True}, "options": options, "fabric": {"f": fabric.keys}, "piece": [piece],
                 "pin": []}
    sim.facts |= {"fabric": fabric.kind, "cell": cell, "outline": "" if number is None else number}
    size = math.sqrt(outlines.area(corners))
    return Draft(rng, sim, fabric, cell, size, int(count), corners)


def pin(d, how=None, **keys):
    """Holds the first piece at a corner, at two, or along an edge."""
    how = how or d.rng.choice(["corner", "two corners", "edge", "clamp"])
    count = len(d.corners)
    k = d.rng.randrange(count)
    item = {"name": "p", "piece": "cloth", **keys}
    if how in ("edge", "clamp"):
        d.sim.scene["pin"].append(item | {"edges": [k]} | ({"hold": "clamp"} if how == "clamp" else {}))
        return
    d.sim.scene["pin"].append(item | {"at": [d.corners[k]]})
    if how == "two corners":
        other = (k + d.rng.randrange(1, count)) % count
        d.sim.scene["pin"].append({"name": "q", "piece": "cloth", "at": [d.corners[other]]})


def throw(d, low=0.3, high=10):
    speed = log_uniform(d.rng, low, high)
    d.sim.scene["piece"][0]["velocity"] = scaled(direction(d.rng), speed)
    d.speed = max(d.speed, speed)


def dampen(d, springs=True):
    """Half of all cloths are damped by mass, a quarter along springs: xi = beta omega/2 up to 1."""
    if d.rng.random() < 0.5:
        d.sim.scene["scene"]["damping"] = log_uniform(d.rng, 0.1, 1000)
    if springs and d.rng.random() < 0.25:
        at_rest = 2 * math.sqrt(d.fabric.start / d.fabric.density) / d.cell
        omega = max(at_rest, fabrics.step_estimate(d.fabric, d.cell, 0, d.size)[1])
        d.fabric.keys["damping"] = min(1e-2, 2 * log_uniform(d.rng, 1e-3, 1) / omega)


def variants(d):
    """Some of the settings that change a law or the grid."""
    rng, options = d.rng, d.sim.scene["options"]
    if rng.random() < 0.15:
        options["bias_model"] = rng.choice(["tension", "paper"])
    if rng.random() < 0.1:
        options["outline"] = "paper"
    if rng.random() < 0.1:
        options["scaling"] = "paper_area"
    if rng.random() < 0.1:
        options["clamp_correction"] = False
    if rng.random() < 0.2:
        d.sim.scene["scene"]["imperfection"] = {"amplitude": 0.01 * d.cell, "seed": rng.randrange(1000)}
    if d.speed > 0 and rng.random() < 0.1:  # what neither falls nor moves has no energy to judge by
        d.sim.scene["scene"]["gravity"] = [0.0, 0.0, 0.0]


def last(d, communication=None, shortest=0.0):
    """Finds duration, communication and rows; to be called when all else is known. Returns the duration."""
    rng, sim = d.rng, d.sim
    step, omega = fabrics.step_estimate(d.fabric, d.cell, d.speed, d.size)
    xi = d.fabric.keys.get("damping", 0) * omega / 2
    step *= math.sqrt(1 + 4 * xi * xi) - 2 * xi
    steps = max(20, log_uniform(rng, *SECONDS) / (STEP_COST + PARTICLE_COST * d.particles) / d.cost)
    duration = min(LONGEST, steps * step)
    q = communication or rng.choice([c for c in COMMUNICATION if c <= duration / 2] or [COMMUNICATION[0]])
    duration = max(shortest, min(duration, steps * q))
    sim.every = q * max(1, round(duration / ROWS / q))
    sim.until = sim.every * max(1, round(duration / sim.every))
    sim.scene["scene"] |= {"communication": q, "duration": sim.until}
    if d.particles > 500 and rng.random() < 0.2 or d.particles > 10000:
        sim.settings.append(f"threads={rng.randint(2, 4)}")
    sim.facts |= {"particles": d.particles, "speed": d.speed, "communication": q}
    return sim.until
