"""The drop that all peers are given: a square of linear cloth falls on a fixed sphere; and what is asked of its end."""
import contextlib
import time

import numpy as np

SIDE, LENGTH = 65, 0.5  # particles, m
CELL = LENGTH / (SIDE - 1)
DENSITY, THICKNESS, FRICTION = 0.15, 1e-3, 0.3  # kg/m2, m
STRETCH, SHEAR = 100.0, 50.0  # N/m: dF/dl of a link along a thread and of a diagonal
BENDING = 1e-6  # N m: bending rigidity per width
BRAKING = 0.5  # 1/s: c in the force -m c v
GRAVITY = 9.81
RADIUS = 0.15  # m, about the origin
START = (0.002, 0.003, RADIUS + 0.005)  # m: the middle of the cloth, a little off the axis
# The same sheet as a continuum. Links of stiffness k on squares and d on their diagonals give, per width, C11 = k + d and
# C12 = C66 = d. With k = 2 d that is isotropic: C11 - C12 = 2 C66. E = C11 (1 - nu^2), nu = C12/C11.
POISSON = SHEAR / (STRETCH + SHEAR)
YOUNG = (STRETCH + SHEAR) * (1 - POISSON**2)  # N/m
DEEPEST, ASIDE, LOWEST = THICKNESS, 0.02, (-0.2, 0.0)  # m: what a drape may be


def grid():
    """Places of the particles at the start, [row, column, 3]; rows along y."""
    along = np.linspace(-LENGTH / 2, LENGTH / 2, SIDE)
    y, x = np.meshgrid(along, along, indexing="ij")
    return np.stack([x, y, np.zeros_like(x)], axis=-1) + START


def masses():
    share = np.ones(SIDE)
    share[[0, -1]] = 0.5
    return DENSITY * CELL**2 * np.outer(share, share)


def links():
    """(rows, columns) that links reach, and their stiffness inside."""
    return [(0, 1, STRETCH), (1, 0, STRETCH), (1, 1, SHEAR), (1, -1, SHEAR)]


def rim_share(j, i, dj, di):
    """The width of the link of particle (j, i) over that of one inside: links along the rim are half as wide."""
    return 0.5 if (dj == 0 and j in (0, SIDE - 1)) or (di == 0 and i in (0, SIDE - 1)) else 1.0


def ends(dj, di):
    """The first and the last ends of the links that reach dj rows and di columns, as slices of a grid."""
    first = np.s_[: SIDE - dj, max(0, -di) : SIDE - max(0, di)]
    last = np.s_[dj:, max(0, di) : SIDE + min(0, di)]
    return first, last


def sphere(splits=5):
    """Points and triangles of an icosahedron, each triangle cut in four again and again, on the sphere: 20 x 4^splits."""
    g = (1 + 5**0.5) / 2
    corners = [(s, t * g, 0) for s in (-1, 1) for t in (-1, 1)]
    points = [np.roll(c, k) for k in range(3) for c in corners]
    near = lambda a, b: abs(np.linalg.norm(points[a] - points[b]) - 2) < 1e-9  # noqa: E731
    faces = [(a, b, c) for a in range(12) for b in range(a) for c in range(b) if near(a, b) and near(b, c) and near(a, c)]
    faces = [f if np.linalg.det([points[k] for k in f]) > 0 else f[::-1] for f in faces]
    points = [p / np.linalg.norm(p) for p in points]
    for _ in range(splits):
        middles, finer = {}, []
        for f in faces:
            m = []
            for pair in ((f[0], f[1]), (f[1], f[2]), (f[2], f[0])):
                key = tuple(sorted(pair))
                if key not in middles:
                    middles[key] = len(points)
                    middle = points[pair[0]] + points[pair[1]]
                    points.append(middle / np.linalg.norm(middle))
                m.append(middles[key])
            finer += [(f[0], m[0], m[2]), (f[1], m[1], m[0]), (f[2], m[2], m[1]), (m[0], m[1], m[2])]
        faces = finer
    return RADIUS * np.array(points), np.array(faces)


@contextlib.contextmanager
def clock(spent):
    """Adds what its block takes to spent: [wall, processor] seconds."""
    start = time.perf_counter(), time.process_time()
    yield
    spent[0] += time.perf_counter() - start[0]
    spent[1] += time.process_time() - start[1]


def judge(places, draped=True):
    """How the cloth ends, in m, and why that is no drape, if it is none. With draped=False the lowest point does not count."""
    end = {"lowest": np.nan, "deepest": np.nan, "aside": np.nan, "elongation": np.nan}
    if not np.isfinite(places).all():
        return end, "not finite"
    middle = places[SIDE // 2, SIDE // 2]
    end["lowest"] = places[..., 2].min()
    end["deepest"] = RADIUS - np.linalg.norm(places, axis=-1).min()
    end["aside"] = np.linalg.norm(middle - (0, 0, RADIUS))
    stretched = [0.0]
    for dj, di, _ in links():
        first, last = ends(dj, di)
        stretched.append(np.linalg.norm(places[last] - places[first], axis=-1).max() / (CELL * np.hypot(dj, di)) - 1)
    end["elongation"] = max(stretched)
    if end["deepest"] > DEEPEST:
        return end, f"{1e3 * end['deepest']:.1f} mm deep in the sphere"
    if end["aside"] > ASIDE:
        return end, f"its middle is {1e3 * end['aside']:.0f} mm off the top"
    if draped and not LOWEST[0] < end["lowest"] < LOWEST[1]:
        return end, f"its lowest point is at {end['lowest']:.3f} m"
    return end, ""
