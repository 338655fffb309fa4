"""A ball is thrown into a net of cloth; the master moves the ball, the cloth throws it back.

In every communication step H the cloth goes first: the ball is where its velocity takes it, and the cloth answers with the mean force
F over the step. The ball then takes this force, and its weight:

    x <- x + H v,   cloth: H -> F,   v <- v + H (F/m + g)

What the ball gains is what the cloth has lost, so over the whole run

    p_cloth + m v = sum H (weight of the cloth + weight of the ball - force on the frame).

A master that steps both at once has to give the ball the force of the step before. Momentum is then off by H F of the last step: the
order is printed.

    .venv/bin/python examples/ball_net/run.py [FOLDER]      results go to FOLDER, default build/ball_net
"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from look import picture
from stage import ROOT, ball, drape, mesh_write, opened, scene_put

HERE = Path(__file__).resolve().parent
SIDE, CELL, DENSITY = 0.6, 0.02, 0.2  # m, m, kg/m2
MASS, START, THROWN = 0.1, np.array([0.05, 0.0, 0.12]), np.array([0.3, 0.0, -3.0])  # kg, m, m/s
RADIUS, GRAVITY = 0.06, np.array([0.0, 0.0, -9.81])
UNTIL = 0.04  # s: while the ball is deep in the net


def node_masses():
    share = np.ones((round(SIDE / CELL) + 1,) * 2)
    share[[0, -1], :] /= 2
    share[:, [0, -1]] /= 2
    return (DENSITY * CELL**2 * share).ravel()


def throw(fmu, step, together, until=UNTIL):
    """Path of the ball [steps + 1 x 3], its velocity, the forces on it, and the error of momentum over the run (N s)."""
    x, v, before = START.copy(), THROWN.copy(), np.zeros(3)
    path, speed, forces = [x], [v], []
    masses = node_masses()
    with opened(fmu, start={"body.ball.velocity": v}) as unit:
        start, given = MASS * v, np.zeros(3)
        for _ in range(round(until / step)):
            x = x + step * v
            unit.set({"body.ball.position": x, "body.ball.velocity": v})
            unit.step(step)
            force = unit.vector("body.ball.force")
            v = v + step * ((before if together else force) / MASS + GRAVITY)
            before = force
            given += step * ((masses.sum() + MASS) * GRAVITY - unit.vector("pin.frame.force"))
            path.append(x), speed.append(v), forces.append(force)
        cloth = masses @ unit.nodes("node.velocity")
    error = np.linalg.norm(cloth + MASS * v - start - given)
    return np.array(path), np.array(speed), np.array(forces), error


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build" / "ball_net"
    scene, fmu = scene_put(folder, HERE / "scene.toml"), folder / "ball_net.fmu"
    mesh_write(folder / "ball.obj", *ball(RADIUS, 16))
    drape("pack", scene, "-o", fmu, "--nodes", "all")
    impulse = MASS * np.linalg.norm(THROWN)
    print("H, ms    cloth first: momentum    at once: momentum   order   (errors over the momentum of the throw)")
    errors = []
    for step in (0.002, 0.001, 0.0005):
        path, speed, forces, first = throw(fmu, step, together=False)
        *_, both = throw(fmu, step, together=True)
        errors.append((first / impulse, both / impulse))
        order = f"{np.log2(errors[-2][1] / both * impulse):7.2f}" if len(errors) > 1 else "      -"
        print(f"{1e3 * step:5.2f} {errors[-1][0]:22.1e} {errors[-1][1]:22.1e} {order}")
    print(f"\nlowest point {path[:, 2].min():.4f} m, largest force {np.linalg.norm(forces, axis=1).max():.2f} N")
    draw(scene, fmu, folder)
    assert all(first < 1e-9 for first, _ in errors), "momentum is lost between the cloth and the ball"


def draw(scene, fmu, folder):
    """The same throw by `drape run`, which follows the path of the ball."""
    step = 1e-3
    path, speed, *_ = throw(fmu, step, together=False, until=0.3)
    names = [f"body.ball.{what}[{k}]" for what in ("position", "velocity") for k in (1, 2, 3)]
    rows = [[step * k, *x, *v] for k, (x, v) in enumerate(zip(path, np.vstack([speed[:1], speed[:-1]])))]
    table = folder / "ball.csv"
    table.write_text("time," + ",".join(names) + "\n" + "".join(",".join(repr(float(value)) for value in row) + "\n" for row in rows))
    drape("run", scene, "-o", folder / "run", "--until", 0.3, "--every", 0.01, "--frames", "--inputs", table)
    picture(folder / "run", folder / "ball_net.png", field="tension_warp", times=[0.0, 0.04, 0.08], views=[(0.5, -1.0, 0.45)], up="z")


if __name__ == "__main__":
    main()
