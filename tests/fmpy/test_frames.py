"""Frames, report and pictures of a run: fields on cloth whose strains and pressures are known, as PyVista reads them."""
import csv
import math
import os
import subprocess
import sys

os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")

import numpy as np
import pytest
import pyvista
from scenes import ROOT

LEVEL = {"origin": [0.0, 0.0, 0.0], "axis_x": [1.0, 0.0, 0.0], "axis_y": [0.0, 1.0, 0.0]}
PULL = 0.02  # strain


def cloth(**more):
    """0.1 m x 0.06 m without weight or shear: threads along x and y do not act on each other."""
    return {
        "scene": {"name": "sheet", "mode": "fit", "gravity": [0, 0, 0], "duration": 5.0},
        "fabric": {"linen": {
            "areal_density": 0.2, "thickness": 1e-3,
            "warp": {"elongation_percent": [0, 10], "force": [0, 50]},
            "weft": {"elongation_percent": [0, 2, 10], "force": [0, 20, 200]}}},
        "piece": [{"name": "sheet", "fabric": "linen", "cell": 0.01, "outline": [[0, 0], [0.1, 0], [0.1, 0.06], [0, 0.06]],
                   "place": LEVEL}],
    } | more


def frame(folder, name, number=-1):
    reader = pyvista.get_reader(str(folder / f"{name}.pvd"))
    reader.set_active_time_value(reader.time_values[number])
    return reader.read()[0]


def report_rows(file):
    with open(file) as text:
        return {(row["table"], row["what"], row["quantity"]): (float(row["value"]), row["unit"]) for row in csv.DictReader(text)}


@pytest.fixture
def pulled(drape, write, tmp_path):
    """Pulled along x by PULL, evenly: every weft link is strained by that, the diagonals by sqrt((1 + (1 + e)^2)/2) - 1."""
    pins = [{"name": "held", "piece": "sheet", "edges": [3]}, {"name": "jaw", "piece": "sheet", "edges": [1], "drive": "position"}]
    scene = write(cloth(pin=pins))
    table = tmp_path / "pull.csv"
    x = [f"pin.jaw.position[{k}]" for k in (1, 2, 3)]
    table.write_text(f"time,{','.join(x)}\n0,0.1,0.03,0\n0.5,{0.1 * (1 + PULL)},0.03,0\n")

    def run(*options):
        drape("run", scene, "-o", tmp_path / "run", "--until", 3, "--every", 1.5, "--frames", "--inputs", table, *options)
        return tmp_path / "run"

    return run


BIAS = math.sqrt((1 + (1 + PULL) ** 2) / 2) - 1


def test_fields_of_a_pulled_cloth(pulled):
    last = frame(pulled(), "frames")
    # the fit is at rest to 1e-5 of the load; the fields are single precision
    assert last["strain_weft"] == pytest.approx(PULL, rel=1e-4)
    assert last["strain_warp"] == pytest.approx(0, abs=1e-6)
    assert last["strain_bias"] == pytest.approx(BIAS, rel=1e-4)
    assert last["tension_weft"] == pytest.approx(20 / 0.05, rel=2e-4)  # a point of the diagram, N on 50 mm
    assert last["tension_warp"] == pytest.approx(0, abs=1e-3)
    assert last["pressure"] == pytest.approx(0, abs=0)


@pytest.mark.parametrize("limit, beyond", [(1.9, 100), (2.1, 0)])
def test_report_of_a_pulled_cloth(pulled, tmp_path, limit, beyond):
    pulled("--report", tmp_path / "report.csv", "--limit", limit)
    rows = report_rows(tmp_path / "report.csv")
    for quantity in ("min", "mean", "max"):
        assert rows["elongation", "sheet weft", quantity] == (pytest.approx(100 * PULL, rel=1e-4), "%")
        assert rows["elongation", "sheet warp", quantity][0] == pytest.approx(0, abs=1e-4)
        assert rows["elongation", "sheet bias", quantity][0] == pytest.approx(100 * BIAS, rel=1e-4)
    assert rows["elongation", "sheet weft", "beyond the limit"] == (pytest.approx(beyond), "% of area")
    assert rows["elongation", "sheet weft", "limit"][0] == pytest.approx(limit)
    assert rows["elongation", "sheet weft", "largest tension"] == (pytest.approx(400, rel=2e-4), "N/m")


def test_share_beyond_the_limit(drape, write, tmp_path):
    """Hanging cloth: the warp at the height y bears the weight below it, strain rho g y / k; the share with more than half of the
    largest is the upper half, as far as rows of cells go."""
    scene = cloth(pin=[{"name": "bar", "piece": "sheet", "edges": [2]}])
    scene["scene"]["gravity"] = [0, -9.81, 0]
    k, top = 50 / 0.05 / 0.1, 0.2 * 9.81 * 0.06  # N/m, N/m
    drape("run", write(scene), "-o", tmp_path / "run", "--report", tmp_path / "report.csv", "--limit", 100 * top / k / 2)
    rows = report_rows(tmp_path / "report.csv")
    assert rows["elongation", "sheet warp", "beyond the limit"][0] == pytest.approx(50)
    cells = [(i + 0.5) * 0.01 for i in range(6)]  # link i bears what lies below its middle
    assert rows["elongation", "sheet warp", "max"][0] == pytest.approx(100 * 0.2 * 9.81 * cells[-1] / k, rel=1e-4)
    assert rows["elongation", "sheet warp", "mean"][0] == pytest.approx(100 * top / k / 2, rel=1e-4)


def test_limit_is_the_tested_range(pulled, tmp_path):
    pulled("--report", tmp_path / "report.txt")
    text = (tmp_path / "report.txt").read_text().splitlines()
    row = next(line.split() for line in text if line.split()[:2] == ["sheet", "weft"])
    assert [float(value) for value in row[2:]] == pytest.approx([2, 2, 2, 10, 0, 400], rel=1e-3)
    bias = next(line.split() for line in text if line.split()[:2] == ["sheet", "bias"])
    assert bias[5:] == ["-", "0", "-"]  # no law, so no range


BOX = """v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1
f 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n"""


def test_pressure_on_a_table(drape, write, tmp_path):
    """At rest on a level table the pressure is the weight per area, rho g, everywhere."""
    (tmp_path / "box.obj").write_text(BOX)
    scene = cloth(body=[{"name": "table", "mesh": "box.obj", "position": [0, 0, -1.0005]}])
    scene["scene"] |= {"gravity": [0, 0, -9.81], "mode": "dynamic", "duration": 0.2}
    drape("run", write(scene), "-o", tmp_path / "run", "--every", 0.1, "--frames", "--report", tmp_path / "report.csv")
    assert frame(tmp_path / "run", "frames")["pressure"] == pytest.approx(0.2 * 9.81, rel=1e-4)
    bodies = frame(tmp_path / "run", "bodies")
    assert bodies.n_cells == 12 and bodies.bounds == pytest.approx((-1, 1, -1, 1, -2.0005, -0.0005), abs=1e-12)
    assert len(list((tmp_path / "run" / "bodies").iterdir())) == 1  # it stays: written once
    rows = report_rows(tmp_path / "report.csv")
    assert rows["contact", "all bodies", "area"] == (pytest.approx(0.006), "m2")
    assert rows["contact", "all bodies", "normal force"] == (pytest.approx(0.006 * 0.2 * 9.81, rel=1e-4), "N")
    assert rows["contact", "all bodies", "mean pressure"][0] == pytest.approx(rows["contact", "all bodies", "largest pressure"][0], rel=1e-4)
    assert rows["force of the cloth on bodies", "table", "force z"] == (pytest.approx(-0.006 * 0.2 * 9.81, rel=1e-4), "N")


def test_moving_body_and_open_seam(drape, write, tmp_path):
    """A box goes up by 0.3 m and turns by 90 degrees about z; two sheets, 20 mm apart, wait to be sewn."""
    (tmp_path / "box.obj").write_text(BOX)
    scene = cloth(body=[{"name": "lift", "mesh": "box.obj", "scale": 0.01, "position": [1, 0, 0], "moves": True}])
    other = scene["piece"][0] | {"name": "other", "place": LEVEL | {"origin": [0.12, 0, 0]}}
    scene["piece"] = [scene["piece"][0], other]
    scene["scene"] |= {"mode": "dynamic", "duration": 0.1}
    scene["seam"] = [{"name": "join", "closed_at": math.inf, "a": {"piece": "sheet", "edges": [1]},
                      "b": {"piece": "other", "edges": [3], "reverse": True}}]
    table = tmp_path / "lift.csv"
    names = [f"body.lift.position[{k}]" for k in (1, 2, 3)] + [f"body.lift.orientation[{k}]" for k in (1, 2, 3, 4)]
    half = math.sqrt(0.5)
    table.write_text(f"time,{','.join(names)}\n0,1,0,0,1,0,0,0\n0.1,1,0,0.3,{half},0,0,{half}\n")
    drape("run", write(scene), "-o", tmp_path / "run", "--every", 0.05, "--frames", "--inputs", table, "--report", tmp_path / "report.csv")
    first, last = (frame(tmp_path / "run", "bodies", k) for k in (0, -1))
    turned = np.stack([-first.points[:, 1] + 1, first.points[:, 0] - 1, first.points[:, 2] + 0.3], axis=1)
    assert last.points == pytest.approx(turned, abs=1e-9)
    seams = frame(tmp_path / "run", "seams")
    assert seams.n_cells == 2 and seams.n_points == 14  # both sides, 7 particles each
    assert seams["gap"] == pytest.approx(0.02, rel=1e-6)
    assert sorted(set(np.round(seams.points[:, 0], 9))) == [0.1, 0.12]
    rows = report_rows(tmp_path / "report.csv")
    assert rows["seams", "join", "largest gap"] == (pytest.approx(20), "mm")
    assert rows["seams", "join", "closed"][0] == 0
    assert frame(tmp_path / "run", "frames")["piece"].max() == 1


def test_old_frames_go(pulled, tmp_path):
    """Collections of another run in the same folder are not taken for those of this one."""
    (tmp_path / "run").mkdir()
    for name in ("seams", "bodies"):
        (tmp_path / "run" / f"{name}.pvd").write_text("of another scene")
    assert sorted(file.name for file in pulled().glob("*.pvd")) == ["frames.pvd"]


def test_bad_report(drape, write, tmp_path):
    scene = write(cloth())
    done = drape("run", scene, "-o", tmp_path / "out", "--report", scene, "--limit", -3, check=False)
    assert done.returncode == 1
    assert [line for line in done.stderr.splitlines()] == [
        "error: --limit is -3 %; allowed: above 0 %, at most 1000 %",
        f"error: --report is {scene}, which is read from; allowed: any other file",
    ]
    done = drape("run", scene, "-o", tmp_path / "out", "--limit", 3, check=False)
    assert done.returncode == 1 and "--limit" in done.stderr and "--report" in done.stderr
    done = drape("run", scene, "-o", tmp_path / "out", "--report", tmp_path / "none" / "report.txt", check=False)
    assert done.returncode == 1 and "cannot write" in done.stderr and "No such file" in done.stderr


def look(*arguments):
    return subprocess.run([sys.executable, ROOT / "examples" / "look.py", *map(str, arguments)], capture_output=True, text=True)


def test_picture(pulled, tmp_path):
    done = look(pulled(), "--field", "tension_weft", "--view", "top", "-o", tmp_path / "picture.png")
    assert done.returncode == 0, done.stderr
    assert 3000 < (tmp_path / "picture.png").stat().st_size < 150_000


def test_picture_of_nothing(tmp_path):
    done = look(tmp_path, "-o", tmp_path / "picture.png")
    assert done.returncode == 1 and done.stderr.count("error:") == 1 and "--frames" in done.stderr
    done = look(tmp_path, "--view", "0,0,0", "-o", tmp_path / "picture.png")
    assert done.returncode != 0 and "front" in done.stderr
