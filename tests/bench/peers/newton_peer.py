"""Newton: its own springs, semi-implicit, in single precision; bending by springs over two cells."""
from cloth import BIAS, STEP, WARP, WEFT


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
