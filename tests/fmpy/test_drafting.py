"""The drafted skirt and dress: their measures, their place outside the form, and that they can be sewn."""
import math
import subprocess
import sys
import tomllib

import numpy as np
import pytest
from scenes import ROOT, read_csv

BODIES = [{}, {"bust": 0.76, "waist": 0.56, "hips": 0.82, "height": 1.55}, {"bust": 1.22, "waist": 1.06, "hips": 1.32, "height": 1.72}]
SIZE_12 = {"bust": 0.88, "waist": 0.68, "hips": 0.94, "height": 1.66}


def run_draft(name, folder, *options, **measures):
    script = ROOT / "examples" / name / "draft.py"
    options = [*options, *(f"--{key}={value}" for key, value in measures.items())]
    return subprocess.run([sys.executable, script, "-o", folder, *options], capture_output=True, text=True)


def drafted(name, folder, *options, **measures):
    done = run_draft(name, folder, *options, **measures)
    assert done.returncode == 0, done.stderr
    return tomllib.loads((folder / f"{name}.toml").read_text())


def pieces_of(scene):
    return {piece["name"]: piece for piece in scene["piece"]}


def edge_points(piece, edge, count=200):
    """Points along an edge, straight or a Bezier curve."""
    outline = np.array(piece["outline"])
    controls = [c["bezier"] for c in piece.get("curves", []) if c["edge"] == edge]
    points = np.array([outline[edge], *(controls[0] if controls else []), outline[(edge + 1) % len(outline)]])
    t, n = np.linspace(0, 1, count)[:, None], len(points) - 1
    return sum(math.comb(n, k) * t**k * (1 - t) ** (n - k) * points[k] for k in range(n + 1))


def length(piece, edges):
    return sum(np.linalg.norm(np.diff(edge_points(piece, e), axis=0), axis=1).sum() for e in edges)


def width(piece, y):
    """Of a symmetric piece at the height y: twice the largest x there."""
    points = np.vstack([edge_points(piece, e) for e in range(len(piece["outline"]))])
    return 2 * max(abs(points[np.abs(points[:, 1] - y) < 2e-3, 0]))


def wrapped(piece, points):
    """Where points start: arc lengths along the ellipse by a table of 1e5 chords, good to 1e-9 m."""
    place = piece["place"]
    a, b = place["cylinder"]["radius"]
    f = np.linspace(-np.pi, np.pi, 100001)
    line = np.stack([a * np.sin(f), b * np.cos(f)], axis=1)
    arc = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
    arc -= np.interp(0, f, arc)
    out = place["axis_x"][0]  # 1: a front, -1: a back
    angle = np.interp(points[:, 0], arc, f)
    middle = place["cylinder"]["axis_point"][2]
    return np.stack([out * a * np.sin(angle), place["origin"][1] + points[:, 1], middle + out * b * np.cos(angle)], axis=1)


@pytest.mark.parametrize("name", ["skirt", "dress"])
@pytest.mark.parametrize("measures", BODIES)
def test_sides_of_seams_fit(name, measures, tmp_path, drape):
    """Both sides of every seam are equally long; the side seams of the skirt, whose front and back are differently wide at the
    hips, differ by less than 1 %."""
    scene = drafted(name, tmp_path, "--weightless", **measures)
    drape("check", tmp_path / f"{name}.toml")
    pieces = pieces_of(scene)
    for seam in scene["seam"]:
        a, b = (length(pieces[seam[s]["piece"]], seam[s]["edges"]) for s in "ab")
        assert a == pytest.approx(b, rel=1e-2 if seam["name"].startswith("hip") else 1e-6), seam["name"]


@pytest.mark.parametrize("measures", BODIES)
def test_skirt_has_the_measures(measures, tmp_path):
    """Hips + 3 cm round the hips, waist + 1 cm round the sewn waist, in millimetres what the slope of the waist makes of it."""
    m = SIZE_12 | measures
    scene = drafted("skirt", tmp_path, "--weightless", **measures)
    pieces = pieces_of(scene)
    hip = -0.206 * m["height"] / 1.66
    assert width(pieces["front"], hip) + width(pieces["back"], hip) == pytest.approx(m["hips"] + 0.03, abs=1e-6)
    waist = sum(length(pieces[s["a"]["piece"]], s["a"]["edges"]) for s in scene["seam"] if s["name"].startswith("waist"))
    assert waist == pytest.approx(m["waist"] + 0.01, abs=3e-3)


def test_dress_has_the_measures(tmp_path):
    """Size 12: shoulders of 12.25 cm, half the bust + 5 cm from the middle of the back to that of the front (the front still has its
    turned part: from the waist up the side seams are as long as the back's), hips + 5 cm."""
    scene = drafted("dress", tmp_path, "--weightless")
    front, back = (pieces_of(scene)[p] for p in ("front", "back"))
    seams = {s["name"]: s for s in scene["seam"]}
    assert length(front, seams["shoulder_left"]["a"]["edges"]) == pytest.approx(0.1225, abs=1e-6)
    assert width(front, -0.7) + width(back, -0.7) == pytest.approx(0.94 + 0.05, abs=1e-6)
    sides = {}
    for key in "ab":  # the waist, where the side seam begins: taken in by 2.5 cm from the narrower of armscye and hips
        side = seams["side_lower_left"][key]
        piece = pieces_of(scene)[side["piece"]]
        sides[key] = min(np.abs(edge_points(piece, side["edges"][0])[:, 0]))
    assert 2 * (sides["a"] + sides["b"]) == pytest.approx(0.88 + 0.10 - 4 * 0.025, abs=1e-6)


@pytest.mark.parametrize("name", ["skirt", "dress"])
@pytest.mark.parametrize("measures", BODIES)
def test_starts_outside_the_form(name, measures, tmp_path):
    """Every point of the form lies inside the ellipse on which the cloth is wrapped, by more than 1 cm; pieces do not meet."""
    scene = drafted(name, tmp_path, **measures)
    assert scene["body"] == [{"name": "form", "mesh": "form.obj"}]
    form = np.array([line.split()[1:] for line in (tmp_path / "form.obj").read_text().splitlines() if line.startswith("v ")], float)
    for piece in scene["piece"]:
        outline = np.vstack([edge_points(piece, e, 20) for e in range(len(piece["outline"]))])
        start = wrapped(piece, outline)
        a, b = piece["place"]["cylinder"]["radius"]
        middle = piece["place"]["cylinder"]["axis_point"][2]
        low, high = start[:, 1].min(), start[:, 1].max()
        beside = form[(form[:, 1] >= low) & (form[:, 1] <= high)]
        assert np.hypot(beside[:, 0] / (a - 0.01), (beside[:, 2] - middle) / (b - 0.01)).max() < 1
        front_side = start[:, 2] - middle if piece["place"]["axis_x"][0] > 0 else middle - start[:, 2]
        assert front_side.min() > 0  # within its half of the ellipse


def sewn(drape, tmp_path, name, until, *options):
    drafted(name, tmp_path, "--weightless", *options)
    done = drape("run", tmp_path / f"{name}.toml", "-o", tmp_path / "out", "--until", until, "--every", until)
    assert done.stderr.count("\n") == 1 and "the fit has not come to rest" in done.stderr  # sewn, but so soon not at rest
    names, rows = read_csv(tmp_path / "out" / "outputs.csv")
    end = dict(zip(names, rows[-1], strict=True))
    gaps = {key: value for key, value in end.items() if key.endswith(".gap.max")}
    assert all(gap < 1e-3 for gap in gaps.values()), gaps
    assert all(value == 1 for key, value in end.items() if key.endswith(".closed"))
    return end


def test_skirt_can_be_sewn(drape, tmp_path):
    """Weightless, from where it is wrapped: darts, sides and waistband close."""
    end = sewn(drape, tmp_path, "skirt", 0.7, "--cell=0.02")
    assert end["strain.warp.max"] < 0.02


def test_dress_can_be_sewn(drape, tmp_path):
    """Cells of 10 mm: the bust darts fold a cell at their tips."""
    sewn(drape, tmp_path, "dress", 0.7, "--length=0.3")


def test_bad_measures(tmp_path):
    done = run_draft("skirt", tmp_path / "none", waist=68, hips=0.1, cell=0)
    assert done.returncode == 1
    assert done.stderr.splitlines() == [
        "error: --waist = 68 m; allowed: 0.5 to 1.4 m",
        "error: --hips = 0.1 m; allowed: 0.7 to 1.6 m",
        "error: --cell = 0 m; allowed: 0.002 to 0.05 m",
    ]
    done = run_draft("dress", tmp_path / "none", waist=1.2, length=2)
    assert done.returncode == 1
    assert done.stderr.splitlines() == [
        "error: --length = 2 m; allowed: 0.256 m, below the hips, to 0.990 m",
        "error: --waist = 1.2 m; allowed: less than --hips, 0.94 m: it hangs from there",
    ]
    assert not (tmp_path / "none").exists()
