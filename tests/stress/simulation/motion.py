"""How pins, clamps, bodies and the wind move: inputs over time, and the meshes of bodies."""
import math

from .draft import direction, scaled
from .fabrics import log_uniform

SHAKE_HERTZ, SHAKE_AMPLITUDE = (1.0, 20.0), (0.002, 0.1)  # Hz, m
ANGULAR = (1.0, 60.0)  # rad/s


def times(until, spacing):
    """0, spacing, ... to the end and beyond it; not more than 4,000."""
    count = min(4000, max(1, math.ceil(until / spacing)))
    return [k * until / count for k in range(count + 2)]


def moved(start, offset):
    return [a + b for a, b in zip(start, offset)]


def drawn_path(name, drive, place, rate):
    """Inputs of a pin or body that goes along `place`, m from its start, with the velocity `rate`."""

    def at(start):
        def inputs(t):
            values = {}
            if f"{name}.position" in start:
                values[f"{name}.position"] = moved(start[f"{name}.position"], place(t))
            if f"{name}.velocity" in start:
                values[f"{name}.velocity"] = rate(t)
            return values

        return inputs

    return at


def jerk(rng, until, name, drive, speeds=(0.3, 20.0)):
    """At rest, then at once at full speed, then at once at rest; there and back, or once. Returns path and speed."""
    speed, way = log_uniform(rng, *speeds), direction(rng)
    begin = rng.uniform(0, 0.3) * until
    length = min(0.3 / speed, rng.uniform(0.05, 0.3) * until)
    back = rng.random() < 0.5

    def place(t):
        out = min(max(t - begin, 0), length) * speed
        return scaled(way, out - (min(max(t - begin - length, 0), length) * speed if back else 0))

    def rate(t):
        moving = begin <= t < begin + length
        returning = back and begin + length <= t < begin + 2 * length
        return scaled(way, speed * (moving - returning))

    turns = [begin, begin + length, begin + 2 * length]
    before = [max(0.0, t - 1e-3 * length) for t in turns]  # rows are joined by lines
    return sorted({0.0, *turns, *before, 2 * until + turns[-1]}), drawn_path(name, drive, place, rate), speed


def shake(rng, until, name, drive, spacing):
    hertz, amplitude, way = log_uniform(rng, *SHAKE_HERTZ), log_uniform(rng, *SHAKE_AMPLITUDE), direction(rng)
    w = 2 * math.pi * hertz
    path = drawn_path(name, drive, lambda t: scaled(way, amplitude * math.sin(w * t)),
                      lambda t: scaled(way, amplitude * w * math.cos(w * t)))
    return times(until, max(spacing, 1 / (60 * hertz))), path, amplitude * w


def spin(rng, until, name, spacing):
    """A clamp that turns about an axis through its middle, from rest to its full rate within a tenth of the time."""
    rate, axis = log_uniform(rng, *ANGULAR) * rng.choice([-1, 1]), direction(rng)
    rise = max(1e-9, rng.choice([0.0, 0.1, 0.3]) * until)

    def angle(t):
        return rate * (t - rise / 2 if t > rise else t * t / (2 * rise))

    def at(start):
        def inputs(t):
            half = angle(t) / 2
            values = {
                f"{name}.orientation": [math.cos(half), *scaled(axis, math.sin(half))],
                f"{name}.angular_velocity": scaled(axis, rate * min(1, t / rise)),
                f"{name}.position": start.get(f"{name}.position"),
                f"{name}.velocity": [0.0, 0.0, 0.0],
            }
            return {key: value for key, value in values.items() if key in start}

        return inputs

    return times(until, max(spacing, 0.1 / abs(rate))), at, abs(rate)


def gusts(rng, until, wind):
    """The wind changes between ten random strengths."""
    moments = [k * until / 9 for k in range(11)]
    strengths = [rng.uniform(0, 1) for _ in moments]

    def at(start):
        def inputs(t):
            k = min(range(len(moments)), key=lambda i: abs(moments[i] - t))
            return {"wind": scaled(wind, strengths[k])}

        return inputs

    return moments, at


def box(rng, half):
    """Corners and triangles of a box, turned by a random rotation."""
    a, b = direction(rng), direction(rng)
    x = a
    along = sum(p * q for p, q in zip(a, b))
    y = [q - along * p for p, q in zip(a, b)]
    y = scaled(y, 1 / math.hypot(*y))
    z = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]
    corners = [[sx * half[0] * p + sy * half[1] * q + sz * half[2] * r for p, q, r in zip(x, y, z)]
               for sx in (-1, 1) for sy in (-1, 1) for sz in (-1, 1)]
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]


def ball(radius, rings=16):
    points = [[0, 0, radius]]
    for i in range(1, rings):
        for j in range(2 * rings):
            t, f = math.pi * i / rings, math.pi * j / rings
            points.append([radius * math.sin(t) * math.cos(f), radius * math.sin(t) * math.sin(f), radius * math.cos(t)])
    points.append([0, 0, -radius])
    end, wide = len(points) - 1, 2 * rings

    def at(i, j):
        return 1 + (i - 1) * wide + j % wide

    faces = [(0, at(1, j), at(1, j + 1)) for j in range(wide)]
    faces += [(end, at(rings - 1, j + 1), at(rings - 1, j)) for j in range(wide)]
    for i in range(1, rings - 1):
        for j in range(wide):
            faces += [(at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1))]
    return points, faces


def obj(points, faces):
    lines = ["v " + " ".join(repr(float(x)) for x in p) for p in points]
    return "\n".join(lines + ["f " + " ".join(str(k + 1) for k in f) for f in faces]) + "\n"
