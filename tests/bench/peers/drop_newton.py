"""Newton: its springs under semi-implicit steps, and its Style3D solver; single precision, a sphere of its own.

Neither has a force -m c v. Contact is a penalty, stiff enough to keep particles within tenths of a millimetre and no stiffer
than the steps of the springs bear. Contact of cloth with cloth is off in both.
"""
from drop_scene import (BENDING, CELL, FRICTION, GRAVITY, RADIUS, SHEAR, SIDE, THICKNESS, YOUNG, clock, grid, links,
                        masses, rim_share)

FRAME = 1 / 60  # s
CONTACT = {"ke": 100.0, "kd": 0.02, "kf": 0.02}  # N/m, N s/m, N s/m of sliding until friction is reached; a particle
SPRING_DAMPING = 1e-4  # N s/m: 0.2 % of the critical one of a link
SPRING_STEPS = 96  # a frame: 174 us; the links bear 2/sqrt(4 (k + 2 d)/m) = 214 us, with contact 200 us


def start_model(newton):
    import warp

    warp.config.quiet = True
    builder = newton.ModelBuilder(up_axis=newton.Axis.Z, gravity=(0.0, 0.0, -GRAVITY))
    surface = builder.default_shape_cfg.copy()
    surface.mu = FRICTION
    for name, value in CONTACT.items():
        setattr(surface, name, value)
    builder.add_shape_sphere(-1, radius=RADIUS, cfg=surface)
    return builder


def finish_model(newton, builder):
    model = builder.finalize(device="cpu")
    for name, value in {**CONTACT, "mu": FRICTION}.items():
        setattr(model, f"soft_contact_{name}", value)
    model.particle_grid = None  # no contact of particles with particles
    return model


def move(newton, model, solver, seconds, substeps, search_each_step):
    """Places at the end, and what the frames took. A step whose result is dropped compiles the kernels before."""
    pipeline = newton.CollisionPipeline(model, soft_contact_margin=5 * THICKNESS)
    contacts, control = pipeline.contacts(), model.control()
    states = [model.state(), model.state()]

    def frame(steps):
        for k in range(steps):
            if search_each_step or k == 0:
                pipeline.collide(states[0], contacts)
            states[0].clear_forces()
            solver.step(states[0], states[1], control, contacts, FRAME / substeps)
            states.reverse()

    frame(1)
    states[:] = [model.state(), model.state()]
    spent, frames = [0.0, 0.0], max(1, round(seconds / FRAME))
    with clock(spent):
        for _ in range(frames):
            frame(substeps)
        places = states[0].particle_q.numpy().reshape(SIDE, SIDE, 3)
    return places, [s * seconds / (frames * FRAME) for s in spent]


def springs(seconds):
    import newton
    import warp

    builder = start_model(newton)
    builder.add_particles([warp.vec3(*r) for r in grid().reshape(-1, 3)], [warp.vec3()] * SIDE**2,
                          masses().ravel().tolist(), radius=[THICKNESS / 2] * SIDE**2)
    at = lambda j, i: j * SIDE + i  # noqa: E731
    for dj, di, stiffness in links():
        for j in range(SIDE - dj):
            for i in range(max(0, -di), SIDE - max(0, di)):
                k = rim_share(j, i, dj, di) * stiffness
                builder.add_spring(at(j, i), at(j + dj, i + di), k, SPRING_DAMPING, 0.0)
    # Newton's hinge pulls at the corners off its edge with ke theta e^2, at an arm b: rigidity ke b^3. Edges along threads.
    for j in range(1, SIDE - 1):
        for i in range(SIDE - 1):
            builder.add_edge(at(j - 1, i), at(j + 1, i), at(j, i), at(j, i + 1), edge_ke=BENDING / CELL**3, edge_kd=0.0)
            builder.add_edge(at(i, j + 1), at(i, j - 1), at(i, j), at(i + 1, j), edge_ke=BENDING / CELL**3, edge_kd=0.0)
    model = finish_model(newton, builder)
    solver = newton.solvers.SolverSemiImplicit(model, enable_tri_contact=False)
    return move(newton, model, solver, seconds, SPRING_STEPS, search_each_step=True)


def style3d(seconds):
    """A sheet of triangles that resist stretch along the threads and shear; ten steps of four iterations a frame."""
    import newton
    import warp
    from newton.solvers import style3d as cloth

    builder = start_model(newton)
    newton.solvers.SolverStyle3D.register_custom_attributes(builder)
    corner = grid()[0, 0]
    # Its triangles have no lateral contraction: the stiffness of the sheet pulled along a thread. Its bending energy is three
    # times that of a cylinder bent along the grid.
    cloth.add_cloth_grid(
        builder, pos=warp.vec3(*corner), rot=warp.quat_identity(), vel=warp.vec3(0.0, 0.0, 0.0), dim_x=SIDE - 1,
        dim_y=SIDE - 1, cell_x=CELL, cell_y=CELL, mass=masses().sum() / SIDE**2, particle_radius=THICKNESS / 2,
        tri_aniso_ke=warp.vec3(YOUNG, YOUNG, SHEAR), edge_aniso_ke=warp.vec3(BENDING / 3, BENDING / 3, 0.0))
    model = finish_model(newton, builder)
    solver = newton.solvers.SolverStyle3D(model, config=newton.solvers.SolverStyle3D.Config(iterations=4))
    solver.collision.stiff_vf = solver.collision.stiff_ee = solver.collision.stiff_ef = 0.0  # cloth with cloth
    return move(newton, model, solver, seconds, substeps=10, search_each_step=False)
