"""The benchmark's scripts run; their figures are not checked here."""
import csv
import shutil
import subprocess
import sys

import pytest
from scenes import ROOT
from test_release import linux64

BENCH = ROOT / "tests" / "bench"


def run(*arguments):
    subprocess.run([sys.executable, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def test_whole(tmp_path):
    run(BENCH / "whole.py", "--quick", "--csv", tmp_path / "whole.csv")
    assert (tmp_path / "whole.csv").read_text().count("\n") == 8


def test_garment(tmp_path):
    run(BENCH / "garment.py", "--quick", "--csv", tmp_path / "garment.csv")
    assert (tmp_path / "garment.csv").read_text().count("\n") == 5


def test_layers(tmp_path):
    run(BENCH / "layers.py", "--quick", "--csv", tmp_path / "layers.csv")
    assert (tmp_path / "layers.csv").read_text().count("\n") == 5


@linux64
def test_builds(tmp_path):
    run(BENCH / "builds.py", "--quick", "--csv", tmp_path / "builds.csv")
    assert (tmp_path / "builds.csv").read_text().count("\n") == 12


def test_scenes(drape, tmp_path):
    scene = ROOT / "examples" / "hanging_wool" / "scene.toml"
    drape("bench", "scenes", "--quick", "--scene", scene, "--csv", tmp_path / "scenes.csv")
    assert (tmp_path / "scenes.csv").read_text().count("hanging_wool") == 2
    assert drape("bench", "scenes", "--scene", "nowhere.toml", check=False).returncode == 1


def test_absent(tmp_path):
    """A command without the benchmark beside it reports how to get it."""
    shutil.copy(ROOT / "build" / "drape", tmp_path)
    done = subprocess.run([tmp_path / "drape", "bench", "--quick", "kernel"], capture_output=True, text=True)
    assert done.returncode == 1 and done.stderr.count("\n") == 1 and "-DDRAPE_BENCH=ON" in done.stderr


def test_help_and_bad_words(drape):
    assert "Usage: drape bench" in drape("bench", "--help").stdout
    done = drape("bench", "kernels", check=False)
    assert done.returncode == 1 and "kernels" in done.stderr


def test_precision(drape, tmp_path):
    """Error against time for every method: in seconds, on small cloths."""
    table = tmp_path / "precision.csv"
    said = drape("bench", "precision", "--quick", "--csv", table).stdout
    assert said.count("best order") == 4
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))
    kernel = {(r["method"], r["order"]) for r in rows if r["forces"] == "kernel"}
    assert {("Drape", "2"), ("Drape", "4"), ("Drape", "6"), ("ERK", "8"), ("BDF, Krylov", "0")} <= kernel
    assert len({r["scene"] for r in rows}) == 4
    best = {o: min(float(r["error"]) for r in rows if r["method"] == "Drape" and r["order"] == o) for o in "246"}
    assert best["4"] < best["2"] / 10 and best["6"] < best["2"] / 10
    run(BENCH / "plot_precision.py", table, tmp_path / "precision.svg")
    assert (tmp_path / "precision.svg").exists()
    assert drape("bench", "precision", "kernel", check=False).returncode == 1


@pytest.mark.parametrize("script, table", [("plot.py", "epyc_zen5"), ("plot_precision.py", "epyc_zen5_precision")])
def test_plot(tmp_path, script, table):
    """The committed picture is that of the committed table."""
    results = BENCH / "results"
    run(BENCH / script, results / f"{table}.csv", tmp_path / "picture.svg")
    assert (tmp_path / "picture.svg").read_text() == (results / f"{table}.svg").read_text()
