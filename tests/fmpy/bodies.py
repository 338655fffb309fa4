"""Meshes of bodies as OBJ text, and a sheet that touches one."""
import math

from scenes import HORIZONTAL, sheet


def ball(radius, n):
    """A ball about the origin of n rings of n triangles."""
    points = [(0, 0, radius)]
    for i in range(1, n):
        for j in range(n):
            t, f = math.pi * i / n, 2 * math.pi * j / n
            points.append((radius * math.sin(t) * math.cos(f), radius * math.sin(t) * math.sin(f), radius * math.cos(t)))
    points.append((0, 0, -radius))
    last = len(points) - 1

    def at(i, j):
        return 1 + (i - 1) * n + j % n

    faces = [(0, at(1, j), at(1, j + 1)) for j in range(n)]
    faces += [(last, at(n - 1, j + 1), at(n - 1, j)) for j in range(n)]
    faces += [(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)) for i in range(1, n - 1) for j in range(n)]
    return obj(points, faces)


def obj(points, faces):
    lines = ["v " + " ".join(repr(float(x)) for x in p) for p in points]
    lines += ["f " + " ".join(str(k + 1) for k in f) for f in faces]
    return "\n".join(lines) + "\n"


def sheet_over_ball(folder, moves=False, cell=0.01, **scene_keys):
    """0.1 m x 0.1 m of wool a thickness above a ball of 3 cm, off its middle."""
    (folder / "ball.obj").write_text(ball(0.03, 32))
    scene = sheet(0.1, 0.1, cell, HORIZONTAL | {"origin": [-0.04, -0.05, 0.0306]}, **scene_keys)
    scene["body"] = [{"name": "ball", "mesh": "ball.obj", "moves": moves}]
    return scene
