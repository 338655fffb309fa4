"""Drape's laws in Numba and Taichi, and Newton's springs, against `drape bench peers`: side by side, in turn, medians.

    python3 tests/bench/peers.py [--quick] [--csv FILE]

Square cloth of N x N particles in cells b: weft, warp and diagonal links of width w pull with w k (l/b - 1); hinges along
both threads with kappa theta^2/2; leapfrog with gravity. Before it is measured, each peer swings a small cloth down from an
edge, and must end where `drape run` ends, to 1e-10 m. Numba comes twice: in plain loops over the links, as one writes them
first, and in rows, with Drape's own order of work, so that its compiler makes vectors of every loop. Newton has single
precision and its own springs (no hinges: it bends by springs over two cells), and no such check: its spring and integration
kernels are called alone. One core for all.
"""
import argparse
import csv
import importlib.util
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
DRAPE = ROOT / "build" / "drape"

CELL, DENSITY = 0.01, 0.15  # m, kg/m2; as tests/bench/cloths.cpp
WARP, WEFT, BIAS = 100.0, 80.0, 20.0  # N/m
BEND_WARP, BEND_WEFT = 4e-6, 2e-6  # N m
GRAVITY = -9.81
SIDE = 129
STEP = 2e-5  # s


def reexec_with_packages():
    """Runs this script again in an environment that has the peers, made where it is missing."""
    if all(importlib.util.find_spec(name) for name in ("numba", "taichi", "newton")):
        return
    python = ROOT / "build" / "peers" / "bin" / "python"
    if not python.exists():
        subprocess.run([sys.executable, "-m", "venv", python.parents[1]], check=True)
        subprocess.run([python, "-m", "pip", "install", "--quiet", "-r", HERE / "peers.txt"], check=True)
    os.execv(python, [str(python), *sys.argv])


if __name__ == "__main__":
    reexec_with_packages()

import numba  # noqa: E402
import numpy as np  # noqa: E402

# The series of psi in core/forces/bending.h.
P0, P1, P2, P3, P4, P5, P6, P7, P8, P9, P10, P11, P12, P13 = (
    1.0926714764020715, -0.10314079582768367, 0.011743165282346662, -0.001434957734289709, 0.0001819779796087013,
    -2.3612156859992877e-05, 3.11163578297139e-06, -4.1467602308018345e-07, 5.5733945603696164e-08,
    -7.54052908486172e-09, 1.0237755548669992e-09, -1.3986077184953492e-10, 2.0541559585752153e-11,
    -2.8263080717976547e-12,
)


class Cloth:
    """[n x n] places and velocities of a level cloth, inverse masses, 0 where held; links on the rim half as wide."""

    def __init__(self, n, held_edge=False, crumple=0.0):
        j, i = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
        self.n = n
        random = np.random.default_rng(1)
        shake = lambda: crumple * CELL * random.uniform(-1, 1, (n, n))  # noqa: E731
        self.x, self.y, self.z = i * CELL + shake(), j * CELL + shake(), shake()
        self.vx, self.vy, self.vz = (np.zeros((n, n)) for _ in range(3))
        self.half = np.ones(n)  # share of a link on the rim
        self.half[0] = self.half[-1] = 0.5
        self.inverse_mass = 1 / (DENSITY * CELL**2 * np.outer(self.half, self.half))
        if held_edge:
            self.inverse_mass[-1, :] = 0.0


# ---- Numba in plain loops: each link once, then all particles

plain = numba.njit(fastmath=True, error_model="numpy", boundscheck=False)


@plain
def plain_link(r, f, j0, i0, j1, i1, w, rest):
    dx, dy, dz = r[j1, i1, 0] - r[j0, i0, 0], r[j1, i1, 1] - r[j0, i0, 1], r[j1, i1, 2] - r[j0, i0, 2]
    s = w * (1.0 / rest - 1.0 / np.sqrt(dx * dx + dy * dy + dz * dz))
    f[j0, i0, 0] += s * dx
    f[j0, i0, 1] += s * dy
    f[j0, i0, 2] += s * dz
    f[j1, i1, 0] -= s * dx
    f[j1, i1, 1] -= s * dy
    f[j1, i1, 2] -= s * dz


@plain
def plain_hinge(r, f, j, i, dj, di, kappa):
    u, w = np.empty(3), np.empty(3)
    lu = lw = cosine = 0.0
    for k in range(3):
        u[k] = r[j, i, k] - r[j - dj, i - di, k]
        w[k] = r[j + dj, i + di, k] - r[j, i, k]
        lu += u[k] * u[k]
        lw += w[k] * w[k]
        cosine += u[k] * w[k]
    lu, lw = np.sqrt(lu), np.sqrt(lw)
    cosine = min(cosine / (lu * lw), 1.0)
    theta = np.arccos(cosine)
    m = kappa * (theta / np.sin(theta) if theta > 1e-6 else 1.0)
    for k in range(3):
        first = m / lu * (u[k] / lu * cosine - w[k] / lw)
        last = m / lw * (u[k] / lu - w[k] / lw * cosine)
        f[j - dj, i - di, k] += first
        f[j, i, k] -= first + last
        f[j + dj, i + di, k] += last


@plain
def plain_steps(r, v, im, half, bent, steps, h, h_first):
    n = r.shape[0]
    f = np.zeros_like(r)
    diagonal, rest = BIAS * CELL / np.sqrt(2.0), CELL * np.sqrt(2.0)
    for step in range(steps):
        kick = h_first if step == 0 else h
        f[:] = 0.0
        for j in range(n):
            for i in range(n):
                if i < n - 1:
                    plain_link(r, f, j, i, j, i + 1, WEFT * CELL * half[j], CELL)
                if j < n - 1:
                    plain_link(r, f, j, i, j + 1, i, WARP * CELL * half[i], CELL)
                if i < n - 1 and j < n - 1:
                    plain_link(r, f, j, i, j + 1, i + 1, diagonal, rest)
                    plain_link(r, f, j, i + 1, j + 1, i, diagonal, rest)
                if bent and 0 < i < n - 1:
                    plain_hinge(r, f, j, i, 0, 1, BEND_WEFT * half[j])
                if bent and 0 < j < n - 1:
                    plain_hinge(r, f, j, i, 1, 0, BEND_WARP * half[i])
        for j in range(n):
            for i in range(n):
                for k in range(3):
                    g = GRAVITY if k == 2 and im[j, i] > 0 else 0.0
                    v[j, i, k] += kick * (f[j, i, k] * im[j, i] + g)
                    r[j, i, k] += h * v[j, i, k]


class PlainPeer:
    name = "numba, plain loops"

    def __init__(self, cloth, hinges):
        self.cloth, self.hinges = cloth, hinges
        self.r = np.stack([cloth.x, cloth.y, cloth.z], axis=-1)
        self.v = np.zeros_like(self.r)

    def steps(self, count, first=False):
        plain_steps(self.r, self.v, self.cloth.inverse_mass, self.cloth.half, self.hinges, count, STEP,
                    STEP / 2 if first else STEP)

    def places(self):
        return self.r


# ---- Numba in rows, so that every loop is one that a compiler turns into vectors

inline = numba.njit(fastmath=True, inline="always", error_model="numpy")
compiled = numba.njit(fastmath=True, error_model="numpy", boundscheck=False)


@inline
def numba_links(ax, ay, az, bx, by, bz, n, w, rest, px, py, pz):
    for i in range(n):
        dx, dy, dz = bx[i] - ax[i], by[i] - ay[i], bz[i] - az[i]
        length = np.sqrt(dx * dx + dy * dy + dz * dz)
        s = w[i] * (1.0 / rest - 1.0 / length)
        px[i], py[i], pz[i] = s * dx, s * dy, s * dz


@compiled
def numba_stretch_shear(x, y, z, vx, vy, vz, im, half, steps, h, h_first):
    n = x.shape[0]
    px, py, pz = np.zeros((4, n + 1)), np.zeros((4, n + 1)), np.zeros((4, n + 1))  # weft, warp, rising, falling
    cx, cy, cz = np.zeros(n), np.zeros(n), np.zeros(n)  # what the row gets from the one below
    inner, rim = np.full(n, WEFT * CELL), np.full(n, WEFT * CELL / 2)
    warp, diagonal = WARP * CELL * half, np.full(n, BIAS * CELL / np.sqrt(2.0))
    none = np.zeros(n)
    for step in range(steps):
        kick = h_first if step == 0 else h
        cx[:], cy[:], cz[:] = 0.0, 0.0, 0.0
        for j in range(n):
            x0, y0, z0 = x[j], y[j], z[j]
            numba_links(x0, y0, z0, x0[1:], y0[1:], z0[1:], n - 1, rim if j in (0, n - 1) else inner, CELL,
                        px[0, 1:], py[0, 1:], pz[0, 1:])
            if j + 1 < n:
                x1, y1, z1 = x[j + 1], y[j + 1], z[j + 1]
                numba_links(x0, y0, z0, x1, y1, z1, n, warp, CELL, px[1, 1:], py[1, 1:], pz[1, 1:])
                numba_links(x0, y0, z0, x1[1:], y1[1:], z1[1:], n - 1, diagonal, CELL * np.sqrt(2.0), px[2, 1:],
                            py[2, 1:], pz[2, 1:])
                numba_links(x0[1:], y0[1:], z0[1:], x1, y1, z1, n - 1, diagonal, CELL * np.sqrt(2.0), px[3, 1:],
                            py[3, 1:], pz[3, 1:])
            else:
                for q in range(1, 4):
                    px[q, 1:], py[q, 1:], pz[q, 1:] = none, none, none
            numba_move(x0, vx[j], im[j], px, cx, n, h, kick, 0.0)
            numba_move(y0, vy[j], im[j], py, cy, n, h, kick, 0.0)
            numba_move(z0, vz[j], im[j], pz, cz, n, h, kick, GRAVITY)


@inline
def numba_move(r, v, im, p, c, n, h, kick, g):
    """The sums of a row, its step, and what it hands to the row above. p[q, i + 1] belongs to node i."""
    p[0, n] = p[2, n] = p[3, n] = 0.0  # the last node begins no link to the right
    for i in range(n):
        f = c[i] + p[0, i + 1] - p[0, i] + p[1, i + 1] + p[2, i + 1] + p[3, i]
        c[i] = -(p[1, i + 1] + p[2, i] + p[3, i + 1])
        v[i] += kick * (f * im[i] + (g if im[i] > 0 else 0.0))
        r[i] += h * v[i]


@inline
def numba_psi(y):
    if y >= 0.5:
        t = 4.0 * y - 3.0
        u = t * t
        even = ((((((P12 * u + P10) * u + P8) * u + P6) * u + P4) * u + P2) * u + P0)
        odd = ((((((P13 * u + P11) * u + P9) * u + P7) * u + P5) * u + P3) * u + P1)
        return even + t * odd
    return np.arccos(y) / np.sqrt(1.0 - y * y)


@inline
def numba_hinges(ax, ay, az, bx, by, bz, cx, cy, cz, n, kappa, fx, fy, fz, gx, gy, gz, lx, ly, lz):
    """Hinges a-b-c: adds to f on a, g on b and l on c."""
    for i in range(n):
        ux, uy, uz = bx[i] - ax[i], by[i] - ay[i], bz[i] - az[i]
        wx, wy, wz = cx[i] - bx[i], cy[i] - by[i], cz[i] - bz[i]
        iu = 1.0 / np.sqrt(ux * ux + uy * uy + uz * uz)
        iw = 1.0 / np.sqrt(wx * wx + wy * wy + wz * wz)
        ux, uy, uz, wx, wy, wz = ux * iu, uy * iu, uz * iu, wx * iw, wy * iw, wz * iw
        cosine = ux * wx + uy * wy + uz * wz
        m = kappa[i] * numba_psi(cosine)
        p, q = m * iu, -m * iw
        x0, y0, z0 = p * (ux * cosine - wx), p * (uy * cosine - wy), p * (uz * cosine - wz)
        x2, y2, z2 = q * (wx * cosine - ux), q * (wy * cosine - uy), q * (wz * cosine - uz)
        fx[i], fy[i], fz[i] = x0, y0, z0
        gx[i], gy[i], gz[i] = x0 + x2, y0 + y2, z0 + z2
        lx[i], ly[i], lz[i] = x2, y2, z2


@compiled
def numba_with_hinges(x, y, z, vx, vy, vz, im, half, steps, h, h_first):
    """As above with hinges; a row moves when those centred on the next are done. Links are called here as there: taken
    into one function they run a seventh slower."""
    n = x.shape[0]
    px, py, pz = np.zeros((4, n + 1)), np.zeros((4, n + 1)), np.zeros((4, n + 1))
    hx, hy, hz = np.zeros((6, n + 4)), np.zeros((6, n + 4)), np.zeros((6, n + 4))  # f, g, l of weft and warp hinges
    fx, fy, fz = np.zeros((3, n)), np.zeros((3, n)), np.zeros((3, n))
    inner, rim = np.full(n, WEFT * CELL), np.full(n, WEFT * CELL / 2)
    warp, diagonal = WARP * CELL * half, np.full(n, BIAS * CELL / np.sqrt(2.0))
    bend_inner, bend_rim = np.full(n, BEND_WEFT), np.full(n, BEND_WEFT / 2)
    bend_warp = BEND_WARP * half
    for step in range(steps):
        kick = h_first if step == 0 else h
        fx[:], fy[:], fz[:] = 0.0, 0.0, 0.0
        for j in range(n):
            x0, y0, z0 = x[j], y[j], z[j]
            k0, k1 = j % 3, (j + 1) % 3
            numba_links(x0, y0, z0, x0[1:], y0[1:], z0[1:], n - 1, rim if j in (0, n - 1) else inner, CELL,
                        px[0, 1:], py[0, 1:], pz[0, 1:])
            bend = bend_rim if j in (0, n - 1) else bend_inner
            numba_hinges(x0, y0, z0, x0[1:], y0[1:], z0[1:], x0[2:], y0[2:], z0[2:], n - 2, bend, hx[0, 2:], hy[0, 2:],
                         hz[0, 2:], hx[1, 2:], hy[1, 2:], hz[1, 2:], hx[2, 2:], hy[2, 2:], hz[2, 2:])
            last = j + 1 == n
            if not last:
                x1, y1, z1 = x[j + 1], y[j + 1], z[j + 1]
                numba_links(x0, y0, z0, x1, y1, z1, n, warp, CELL, px[1, 1:], py[1, 1:], pz[1, 1:])
                numba_links(x0, y0, z0, x1[1:], y1[1:], z1[1:], n - 1, diagonal, CELL * np.sqrt(2.0), px[2, 1:],
                            py[2, 1:], pz[2, 1:])
                numba_links(x0[1:], y0[1:], z0[1:], x1, y1, z1, n - 1, diagonal, CELL * np.sqrt(2.0), px[3, 1:],
                            py[3, 1:], pz[3, 1:])
            bent = 0 < j < n - 1
            if bent:
                xb, yb, zb = x[j - 1], y[j - 1], z[j - 1]
                numba_hinges(xb, yb, zb, x0, y0, z0, x[j + 1], y[j + 1], z[j + 1], n, bend_warp, hx[3], hy[3], hz[3],
                             hx[4], hy[4], hz[4], hx[5], hy[5], hz[5])
            numba_sum(px, hx, fx[k0], fx[k1], n, last)
            numba_sum(py, hy, fy[k0], fy[k1], n, last)
            numba_sum(pz, hz, fz[k0], fz[k1], n, last)
            if j > 0:
                below = (j + 2) % 3
                if bent:
                    for i in range(n):
                        fx[below, i] += hx[3, i]
                        fy[below, i] += hy[3, i]
                        fz[below, i] += hz[3, i]
                        fx[k0, i] -= hx[4, i]
                        fy[k0, i] -= hy[4, i]
                        fz[k0, i] -= hz[4, i]
                        fx[k1, i] += hx[5, i]
                        fy[k1, i] += hy[5, i]
                        fz[k1, i] += hz[5, i]
                numba_finish(x[j - 1], vx[j - 1], im[j - 1], fx[below], n, h, kick, 0.0)
                numba_finish(y[j - 1], vy[j - 1], im[j - 1], fy[below], n, h, kick, 0.0)
                numba_finish(z[j - 1], vz[j - 1], im[j - 1], fz[below], n, h, kick, GRAVITY)
        k = (n - 1) % 3
        numba_finish(x[n - 1], vx[n - 1], im[n - 1], fx[k], n, h, kick, 0.0)
        numba_finish(y[n - 1], vy[n - 1], im[n - 1], fy[k], n, h, kick, 0.0)
        numba_finish(z[n - 1], vz[n - 1], im[n - 1], fz[k], n, h, kick, GRAVITY)


@inline
def numba_sum(p, hinge, f, above, n, last):
    """Links and weft hinges of a row; hinge[q, i + 2] belongs to the hinge that begins at node i."""
    p[0, n] = p[2, n] = p[3, n] = 0.0
    if last:
        for i in range(n + 1):
            p[1, i] = p[2, i] = p[3, i] = 0.0
    for i in range(n):
        bend = (hinge[0, i + 2] if i < n - 2 else 0.0) - (hinge[1, i + 1] if 0 < i < n - 1 else 0.0) + (
            hinge[2, i] if i > 1 else 0.0)
        f[i] += p[0, i + 1] - p[0, i] + p[1, i + 1] + p[2, i + 1] + p[3, i] + bend
        above[i] = -(p[1, i + 1] + p[2, i] + p[3, i + 1])


@inline
def numba_finish(r, v, im, f, n, h, kick, g):
    for i in range(n):
        v[i] += kick * (f[i] * im[i] + (g if im[i] > 0 else 0.0))
        r[i] += h * v[i]


class RowsPeer:
    name = "numba, rows"

    def __init__(self, cloth, hinges):
        self.cloth, self.run_steps = cloth, numba_with_hinges if hinges else numba_stretch_shear

    def steps(self, count, first=False):
        c = self.cloth
        self.run_steps(c.x, c.y, c.z, c.vx, c.vy, c.vz, c.inverse_mass, c.half, count, STEP,
                       STEP / 2 if first else STEP)

    def places(self):
        return np.stack([self.cloth.x, self.cloth.y, self.cloth.z], axis=-1)


# ---- Taichi: every particle gathers its eight links, then all move

def taichi_peer(precision):
    import taichi as ti

    real = ti.f64 if precision == "double" else ti.f32
    ti.init(arch=ti.cpu, cpu_max_num_threads=1, default_fp=real, fast_math=True, log_level=ti.ERROR,
            offline_cache=False)

    @ti.data_oriented
    class TaichiPeer:
        name = f"taichi, {precision}"

        def __init__(self, cloth, hinges):
            assert not hinges
            self.n = cloth.n
            self.r, self.v = (ti.Vector.field(3, real, (self.n, self.n)) for _ in range(2))
            self.im = ti.field(real, (self.n, self.n))
            self.r.from_numpy(np.stack([cloth.x, cloth.y, cloth.z], axis=-1))
            self.im.from_numpy(cloth.inverse_mass)

        @ti.func
        def pull(self, a, b, w, rest):
            d = b - a
            return w * (1.0 / rest - 1.0 / d.norm()) * d

        @ti.kernel
        def run(self, steps: ti.i32, h: real, h_first: real):
            ti.loop_config(serialize=True)
            for step in range(steps):
                kick = h_first if step == 0 else h
                for j, i in ti.ndrange(self.n, self.n):
                    n = self.n
                    r = self.r[j, i]
                    f = ti.Vector([0.0, 0.0, 0.0])
                    weft = WEFT * CELL * (0.5 if j == 0 or j == n - 1 else 1.0)
                    warp = WARP * CELL * (0.5 if i == 0 or i == n - 1 else 1.0)
                    bias, rest = BIAS * CELL / 2**0.5, CELL * 2**0.5
                    if i > 0:
                        f += self.pull(r, self.r[j, i - 1], weft, CELL)
                    if i < n - 1:
                        f += self.pull(r, self.r[j, i + 1], weft, CELL)
                    if j > 0:
                        f += self.pull(r, self.r[j - 1, i], warp, CELL)
                        if i > 0:
                            f += self.pull(r, self.r[j - 1, i - 1], bias, rest)
                        if i < n - 1:
                            f += self.pull(r, self.r[j - 1, i + 1], bias, rest)
                    if j < n - 1:
                        f += self.pull(r, self.r[j + 1, i], warp, CELL)
                        if i > 0:
                            f += self.pull(r, self.r[j + 1, i - 1], bias, rest)
                        if i < n - 1:
                            f += self.pull(r, self.r[j + 1, i + 1], bias, rest)
                    im = self.im[j, i]
                    g = GRAVITY if im > 0 else 0.0
                    self.v[j, i] += kick * (f * im + ti.Vector([0.0, 0.0, g]))
                for j, i in ti.ndrange(self.n, self.n):
                    self.r[j, i] += h * self.v[j, i]

        def steps(self, count, first=False):
            self.run(count, STEP, STEP / 2 if first else STEP)

        def places(self):
            return self.r.to_numpy()

    return TaichiPeer


# ---- Newton: its own springs, semi-implicit, single precision; bending by springs over two cells

class NewtonPeer:
    name = "newton's springs, single"

    def __init__(self, cloth, hinges):
        import newton
        import warp
        from newton._src.solvers.semi_implicit.kernels_particle import eval_spring_forces

        warp.config.quiet = True
        self.eval_spring_forces = eval_spring_forces
        n, builder = cloth.n, newton.ModelBuilder()
        for j in range(n):
            for i in range(n):
                builder.add_particle((cloth.x[j, i], cloth.y[j, i], cloth.z[j, i]), (0, 0, 0),
                                     1 / cloth.inverse_mass[j, i])
        reach = [(0, 1, WEFT), (1, 0, WARP), (1, 1, BIAS), (1, -1, BIAS)]
        if hinges:
            reach += [(0, 2, 5.0), (2, 0, 5.0)]
        for dj, di, k in reach:
            for j in range(n - dj):
                for i in range(max(0, -di), n - max(0, di)):
                    builder.add_spring(j * n + i, (j + dj) * n + i + di, k, 0.0, 0.0)
        self.model = builder.finalize(device="cpu")
        self.solver = newton.solvers.SolverSemiImplicit(self.model)
        self.states = [self.model.state(), self.model.state()]

    def steps(self, count, first=False):
        for _ in range(count):
            now, then = self.states
            now.clear_forces()
            self.eval_spring_forces(self.model, now, now.particle_f)
            self.solver.integrate_particles(self.model, now, then, STEP)
            self.states.reverse()


# ---- Drape

SCENE = """[scene]
name = "peers"
duration = {duration}
step = {step}
communication = {step}
gravity = [0, 0, {gravity}]
[options]
clamp_correction = false
[fabric.f]
areal_density = {density}
thickness = 5e-4
warp = {{ elongation_percent = [0, 10], force = [0, {warp}] }}
weft = {{ elongation_percent = [0, 10], force = [0, {weft}] }}
bias = {{ elongation_percent = [0, 10], force = [0, {bias}], correction = [1, 1] }}
{bending}
[[piece]]
name = "sheet"
fabric = "f"
cell = {cell}
outline = [[0, 0], [{side}, 0], [{side}, {side}], [0, {side}]]
[[pin]]
name = "bar"
piece = "sheet"
edges = [2]
"""


def drape_places(n, hinges, steps):
    """Places of the particles of a cloth that hangs from its last row."""
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "scene.toml"
        strip, specimen = 0.05, 0.03
        bending = (f"bending = {{ rigidity_uN_cm2 = [{BEND_WARP * specimen * 1e10!r}, {BEND_WEFT * specimen * 1e10!r}] }}"
                   if hinges else "")
        scene.write_text(SCENE.format(duration=steps * STEP, step=STEP, gravity=GRAVITY, density=DENSITY,
                                      warp=0.1 * WARP * strip, weft=0.1 * WEFT * strip, bias=0.1 * BIAS * strip,
                                      bending=bending, cell=CELL, side=(n - 1) * CELL))
        out = pathlib.Path(folder) / "out"
        subprocess.run([DRAPE, "run", scene, "-o", out, "--nodes", "all", "--every", str(steps * STEP)], check=True,
                       stdout=subprocess.DEVNULL)
        with open(out / "outputs.csv", newline="") as file:
            rows = list(csv.reader(file))
    place = [float(v) for name, v in zip(rows[0], rows[-1]) if name.startswith("node.position")]
    return np.array(place).reshape(n, n, 3)


def check(peer_type, hinges, tolerance):
    n, steps = 17, 4000
    peer = peer_type(Cloth(n, held_edge=True), hinges)
    peer.steps(1, first=True)
    peer.steps(steps - 1)
    off = np.abs(peer.places() - drape_places(n, hinges, steps)).max()
    if not off <= tolerance:
        sys.exit(f"{peer.name} ends {off:.1e} m from drape run; allowed: {tolerance:g} m")
    return off


def drape_rates(quick):
    """Million particle-steps a second of `drape bench peers`, by name."""
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "peers.csv"
        subprocess.run([DRAPE, "bench", "peers", "--csv", table, *(["--quick"] if quick else [])], check=True,
                       stdout=subprocess.DEVNULL)
        with open(table, newline="") as file:
            return {row["name"]: float(row["million_particle_steps_per_s"]) for row in csv.DictReader(file)}


def rate_of(peer, seconds):
    count = 1
    while True:
        start = time.perf_counter()
        peer.steps(count)
        spent = time.perf_counter() - start
        if spent >= seconds / 4:
            return SIDE**2 * count / spent / 1e6
        count *= 2


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--quick", action="store_true", help="seconds in all, no figures to rely on")
    arguments.add_argument("--csv", type=pathlib.Path, help="also writes the rows to a file")
    options = arguments.parse_args()
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    turns, seconds = (1, 0.02) if options.quick else (7, 1.0)

    taichi_double = taichi_peer("double")
    checks = [(PlainPeer, False), (PlainPeer, True), (RowsPeer, False), (RowsPeer, True), (taichi_double, False)]
    for peer_type, hinges in checks:
        off = check(peer_type, hinges, 1e-10)
        print(f"{peer_type.name}{' with hinges' if hinges else ''}: within {off:.1e} m of drape run")

    groups = {
        "stretch and shear": [PlainPeer, RowsPeer, taichi_double, NewtonPeer],
        "with hinges": [PlainPeer, RowsPeer, NewtonPeer],
    }
    rows = []
    for law, types in groups.items():
        peers = [t(Cloth(SIDE, crumple=0.003), law == "with hinges") for t in types]
        for peer in peers:
            peer.steps(2)
        times = {law: [], **{p.name: [] for p in peers}}
        for _ in range(turns):
            times[law].append(drape_rates(options.quick)[law])
            for peer in peers:
                times[peer.name].append(rate_of(peer, seconds))
        medians = {name: statistics.median(values) for name, values in times.items()}
        for peer in peers:
            rows.append({"laws": law, "peer": peer.name, "drape": medians[law], "peer_rate": medians[peer.name],
                         "ratio": medians[law] / medians[peer.name]})
            print("{laws:20} drape {drape:7.1f}   {peer:26} {peer_rate:7.2f} million/s   {ratio:6.1f} x".format(**rows[-1]))
    if options.csv:
        with open(options.csv, "w", newline="") as file:
            table = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
            table.writeheader()
            table.writerows([{k: f"{v:.6g}" if isinstance(v, float) else v for k, v in row.items()} for row in rows])


if __name__ == "__main__":
    main()
