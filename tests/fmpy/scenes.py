"""The scenes of these tests as dictionaries, their TOML text, and the outputs.csv of a run."""
import csv
import json
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
    """The text of a scene: [scene] and [fabric.<name>] tables, [[piece]], [[pin]] and [[probe]] lists."""
    tables = [("[scene]", scene["scene"])]
    tables += [(f"[fabric.{name}]", fabric) for name, fabric in scene["fabric"].items()]
    for key in scene.keys() - {"scene", "fabric"}:
        tables += [(f"[[{key}]]", item) for item in scene[key]]
    lines = []
    for head, body in tables:
        lines += [head, *(f"{key} = {_value(v)}" for key, v in body.items()), ""]
    return "\n".join(lines)


def read_csv(file):
    """Column names and values [rows x columns] of an outputs.csv."""
    with open(file, newline="") as lines:
        names, *rows = csv.reader(lines)
    return names, np.array(rows, dtype=float)
