"""The scenes of these tests as dictionaries, their TOML text, and the outputs.csv of a run."""
import csv
import json
import math
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
WOOL = ROOT / "examples" / "fabrics" / "wool.toml"

HORIZONTAL = {"origin": [0.0, 0.0, 1.0], "axis_x": [1.0, 0.0, 0.0], "axis_y": [0.0, 1.0, 0.0]}
HANGING = {"origin": [0.0, 0.0, 1.0], "axis_x": [1.0, 0.0, 0.0], "axis_y": [0.0, 0.0, 1.0]}


def sheet(width, height, cell, place, **scene_keys):
    """A rectangle of the measured wool, free in space; its warp runs along y of the piece."""
    return {
        "scene": {"name": "sheet", **scene_keys},
        "fabric": {"wool": {"file": str(WOOL)}},
        "piece": [
            {
                "name": "sheet",
                "fabric": "wool",
                "cell": cell,
                "outline": [[0, 0], [width, 0], [width, height], [0, height]],
                "place": place,
            }
        ],
        "pin": [],
        "probe": [],
    }


def pin_points(scene, name, *points):
    scene["pin"].append({"name": name, "piece": "sheet", "at": [list(p) for p in points]})


def pin_edge(scene, name, edge):
    scene["pin"].append({"name": name, "piece": "sheet", "edges": [edge]})


def probe(scene, name, point):
    scene["probe"].append({"name": name, "piece": "sheet", "at": list(point)})


def swinging_sheet(**scene_keys):
    """0.1 m x 0.1 m of wool, level, held at two corners and let go: all laws act, and no fold in the first 0.1 s."""
    scene = sheet(0.1, 0.1, 0.01, HORIZONTAL, **scene_keys)
    pin_points(scene, "left", (0, 0.1))
    pin_points(scene, "right", (0.1, 0.1))
    probe(scene, "hem", (0.03, 0.0))
    return scene


def concave_sheet(**scene_keys):
    """An L of wool with a hole, its warp turned by 20 degrees against the outline, hung up at two points within cells."""
    scene = sheet(0.09, 0.09, 0.01, HORIZONTAL, **scene_keys)
    scene["piece"][0] |= {
        "outline": [[0, 0], [0.09, 0], [0.09, 0.035], [0.04, 0.04], [0.035, 0.09], [0, 0.09]],
        "holes": [[[0.012, 0.012], [0.027, 0.014], [0.024, 0.029]]],
        "grain": math.radians(20),
    }
    pin_points(scene, "left", (0.004, 0.086))
    pin_points(scene, "right", (0.083, 0.006))
    probe(scene, "corner", (0.03, 0.05))
    return scene


def driven_sheet(**scene_keys):
    """A sheet whose left edge, a clamp, is driven in position and velocity."""
    scene = sheet(0.06, 0.06, 0.01, HORIZONTAL, **scene_keys)
    pin_edge(scene, "pole", 3)
    scene["pin"][0] |= {"hold": "clamp", "drive": "both"}
    probe(scene, "tip", (0.06, 0.03))
    return scene


def flag(wind=(2.0, 0.5, 0.0), **scene_keys):
    """A flag at a pole along z, in wind."""
    scene = sheet(0.08, 0.05, 0.01, HANGING, wind=list(wind), **scene_keys)
    scene["air"] = {"normal": 1.2, "tangential": 0.1}
    pin_edge(scene, "pole", 3)
    probe(scene, "tip", (0.08, 0.0))
    return scene


def damped_sheet(**scene_keys):
    """The swinging sheet, 0.06 m wide, with damping along its springs: xi = beta omega/2 up to about 0.1."""
    scene = sheet(0.06, 0.06, 0.01, HORIZONTAL, **scene_keys)
    scene["fabric"]["wool"]["damping"] = 2e-6
    pin_points(scene, "left", (0, 0.06))
    pin_points(scene, "right", (0.06, 0.06))
    probe(scene, "hem", (0.03, 0.0))
    return scene


def two_strips(ratio=1.4, ease=1.0, gap=(0.004, 0.0, 0.003), **scene_keys):
    """Two pieces side by side, the right one on cells `ratio` times as large, its edge `ease` times as long, `gap` apart."""
    scene = sheet(0.06, 0.06, 0.01, HORIZONTAL, **scene_keys)
    right = {
        "name": "right",
        "fabric": "wool",
        "cell": 0.01 * ratio,
        "outline": [[0, 0], [0.06, 0], [0.06, 0.06 * ease], [0, 0.06 * ease]],
        "place": HORIZONTAL | {"origin": [0.06 + gap[0], gap[1], 1.0 + gap[2]]},
    }
    scene["piece"].append(right)
    scene["seam"] = [
        {
            "name": "join",
            "a": {"piece": "sheet", "edges": [1]},
            "b": {"piece": "right", "edges": [3], "reverse": True},
        }
    ]
    pin_points(scene, "peg", (0, 0.06))
    return scene


def pole_path(time):
    """Where the pole of the driven sheet is to be: it swings along x and z and turns about the y axis through its middle.

    Shift (0.01, 0, 0.005) m (1 - cos wt) and angle 0.4 (1 - cos wt): at rest at the start.
    """
    w = 2 * math.pi / 0.1
    c, s = math.cos(w * time), math.sin(w * time)
    angle, rate = 0.4 * (1 - c), 0.4 * w * s
    return {
        "pin.pole.position": [0.01 * (1 - c), 0.03, 1 + 0.005 * (1 - c)],
        "pin.pole.velocity": [0.01 * w * s, 0.0, 0.005 * w * s],
        "pin.pole.orientation": [math.cos(angle / 2), 0.0, math.sin(angle / 2), 0.0],
        "pin.pole.angular_velocity": [0.0, rate, 0.0],
    }


def scalars(vectors):
    """{"a": [1, 2]} -> {"a[1]": 1, "a[2]": 2}."""
    return {f"{name}[{k}]": value for name, values in vectors.items() for k, value in enumerate(values, 1)}


def write_inputs(file, path, times):
    """A CSV of inputs with a row at each time; `path` gives the vectors at a time."""
    rows = [{"time": t, **scalars(path(t))} for t in times]
    lines = [",".join(rows[0]), *(",".join(repr(float(x)) for x in row.values()) for row in rows)]
    file.write_text("\n".join(lines) + "\n")
    return file


def _value(v):
    if isinstance(v, bool):
        return str(v).lower()
    if isinstance(v, str):
        return json.dumps(v)
    if isinstance(v, dict):
        return "{ " + ", ".join(f"{k} = {_value(x)}" for k, x in v.items()) + " }"
    if isinstance(v, (list, tuple)):
        return "[" + ", ".join(_value(x) for x in v) + "]"
    return repr(v)


def toml(scene):
    """The text of a scene: [scene], [air] and [fabric.<name>] tables, [[piece]], [[pin]] and [[probe]] lists."""
    tables = []
    for key, value in scene.items():
        if key == "fabric":
            tables += [(f"[fabric.{name}]", fabric) for name, fabric in value.items()]
        elif isinstance(value, dict):
            tables.append((f"[{key}]", value))
        else:
            tables += [(f"[[{key}]]", item) for item in value]
    lines = []
    for head, body in tables:
        lines += [head, *(f"{key} = {_value(v)}" for key, v in body.items()), ""]
    return "\n".join(lines)


def read_csv(file):
    """Column names and values [rows x columns] of an outputs.csv."""
    with open(file, newline="") as lines:
        names, *rows = csv.reader(lines)
    return names, np.array(rows, dtype=float)
