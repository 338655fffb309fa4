"""A hundred random outlines of about unit size: convex, concave, with holes; the same ones in every run."""
import math
import random

COUNT = 100


def convex(rng):
    corners = rng.randint(4, 9)  # fewer may leave out the origin
    angles = sorted((k + rng.uniform(0.1, 0.9)) * 2 * math.pi / corners for k in range(corners))
    a, b = rng.uniform(0.4, 0.6), rng.uniform(0.4, 0.6)
    return [[a * math.cos(t), b * math.sin(t)] for t in angles]


def star(rng):
    corners = rng.randint(5, 12)
    return [[r * math.cos(t), r * math.sin(t)] for k in range(corners)
            for r, t in [(rng.uniform(0.25, 0.6), (k + rng.uniform(0, 0.5)) * 2 * math.pi / corners)]]


def rectangle(rng):
    w, h = rng.uniform(0.25, 0.6), rng.uniform(0.25, 0.6)
    return [[-w, -h], [w, -h], [w, h], [-w, h]]


def angle_shape(rng):
    """An L."""
    x, y = rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2)
    return [[-0.5, -0.5], [0.5, -0.5], [0.5, y + rng.uniform(-0.1, 0.1)], [x, y], [x + rng.uniform(-0.1, 0.1), 0.5], [-0.5, 0.5]]


def notched(rng):
    """A rectangle with a notch in its upper edge."""
    x, half, y = rng.uniform(-0.2, 0.2), rng.uniform(0.02, 0.15), rng.uniform(-0.3, 0.3)
    return [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [x + half, 0.5], [x, y], [x - half, 0.5], [-0.5, 0.5]]


def hole(rng, outline):
    """A polygon about the middle, well inside."""
    reach = rng.uniform(0.2, 0.5) * inner_radius(outline)
    corners = rng.randint(3, 6)
    return [[reach * math.cos(t), reach * math.sin(t)]
            for k in range(corners) for t in [(k + rng.uniform(0, 0.6)) * 2 * math.pi / corners]]


def inner_radius(outline):
    """Distance from the origin to the nearest edge."""
    nearest = math.inf
    for (ax, ay), (bx, by) in zip(outline, outline[1:] + outline[:1]):
        dx, dy = bx - ax, by - ay
        z = min(1, max(0, -(ax * dx + ay * dy) / (dx * dx + dy * dy)))
        nearest = min(nearest, math.hypot(ax + z * dx, ay + z * dy))
    return nearest


def area(outline):
    return abs(sum(ax * by - bx * ay for (ax, ay), (bx, by) in zip(outline, outline[1:] + outline[:1]))) / 2


def outline(number):
    """(outline, holes, grain): a shape, turned by any angle, with the warp in any direction or along y."""
    rng = random.Random(f"outline {number}")
    shape = [rectangle, convex, star, angle_shape, notched][number % 5](rng)
    holes = [hole(rng, shape)] if number % 5 < 3 and rng.random() < 0.4 and inner_radius(shape) > 0.1 else []
    turn = rng.choice([0, 0, rng.uniform(0, 2 * math.pi)])
    c, s = math.cos(turn), math.sin(turn)
    shape, holes = ([[[c * x - s * y, s * x + c * y] for x, y in loop] for loop in loops] for loops in ([shape], holes))
    grain = rng.choice([0.0, 0.0, math.pi / 4, rng.uniform(-math.pi, math.pi)])
    return shape[0], holes, grain
