"""Taichi: every particle gathers its eight links, then all move."""
import numpy as np

from cloth import BIAS, CELL, GRAVITY, STEP, WARP, WEFT


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
