"""Numba in rows, with Drape's own order of work, so that every loop is one that a compiler turns into vectors."""
import numba
import numpy as np

from cloth import BEND_WARP, BEND_WEFT, BIAS, CELL, GRAVITY, STEP, WARP, WEFT

# The series of psi in core/forces/bending.h.
P0, P1, P2, P3, P4, P5, P6, P7, P8, P9, P10, P11, P12, P13 = (
    1.0926714764020715, -0.10314079582768367, 0.011743165282346662, -0.001434957734289709, 0.0001819779796087013,
    -2.3612156859992877e-05, 3.11163578297139e-06, -4.1467602308018345e-07, 5.5733945603696164e-08,
    -7.54052908486172e-09, 1.0237755548669992e-09, -1.3986077184953492e-10, 2.0541559585752153e-11,
    -2.8263080717976547e-12,
)

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
    """The sums of a row, its step, and what it passes to the row above. p[q, i + 1] belongs to node i."""
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
