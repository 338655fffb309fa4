"""Numba in plain loops, as one writes them first: each link once, then all particles."""
import numba
import numpy as np

from cloth import BEND_WARP, BEND_WEFT, BIAS, CELL, GRAVITY, STEP, WARP, WEFT

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
