"""MuJoCo: its flex of elastic triangles in double precision, on its own sphere.

Options as in its own example of cloths on a sphere, but for contact by constraints: the passive contact of that example has no
friction, and the cloth slides off. Contact of cloth with cloth is off.
"""
import numpy as np
from drop_scene import (BENDING, BRAKING, CELL, FRICTION, GRAVITY, POISSON, RADIUS, SIDE, START, THICKNESS, YOUNG, clock,
                        masses)

STEP = 0.002  # s
# A plate of thickness t resists stretch by E t per width and bending by E t^3/(12 (1 - nu^2)): E and t that give both.
PLATE = (12 * (1 - POISSON**2) * BENDING / YOUNG) ** 0.5  # m
MODEL = f"""<mujoco>
  <option timestep="{STEP}" gravity="0 0 {-GRAVITY}" solver="CG" tolerance="1e-6" iterations="400" integrator="discrete"/>
  <size memory="1G"/>
  <worldbody>
    <geom type="sphere" size="{RADIUS}" friction="{FRICTION}"/>
    <flexcomp name="sheet" type="grid" dim="2" count="{SIDE} {SIDE} 1" spacing="{CELL} {CELL} {CELL}"
              pos="{START[0]} {START[1]} {START[2]}" mass="{masses().sum()}" radius="{THICKNESS / 2}">
      <contact selfcollide="none" friction="{FRICTION}" solref="0.01 1" solimp=".95 .99 .0001"/>
      <elasticity young="{YOUNG / PLATE}" poisson="{POISSON}" thickness="{PLATE}" elastic2d="both" damping="1e-4"/>
    </flexcomp>
  </worldbody>
</mujoco>"""


def drop(seconds):
    import mujoco

    model = mujoco.MjModel.from_xml_string(MODEL)
    model.dof_damping[:] = BRAKING * np.repeat(model.body_mass[model.flex_vertbodyid], 3)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    order = np.lexsort(np.round(data.flexvert_xpos[:, :2], 6).T)  # by rows along y
    spent, steps = [0.0, 0.0], max(1, round(seconds / STEP))
    with clock(spent):
        for _ in range(steps):
            mujoco.mj_step(model, data)
    mujoco.mj_kinematics(model, data)
    mujoco.mj_flex(model, data)
    return data.flexvert_xpos[order].reshape(SIDE, SIDE, 3), spent
