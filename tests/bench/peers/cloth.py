"""The cloth that every peer moves: that of tests/bench/cloths.cpp."""
import numpy as np

CELL, DENSITY = 0.01, 0.15  # m, kg/m2; as tests/bench/cloths.cpp
WARP, WEFT, BIAS = 100.0, 80.0, 20.0  # N/m
BEND_WARP, BEND_WEFT = 4e-6, 2e-6  # N m
GRAVITY = -9.81
SIDE = 129
STEP = 2e-5  # s


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
