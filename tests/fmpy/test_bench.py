"""The benchmark's scripts run; their figures are not judged here."""
import subprocess
import sys

from scenes import ROOT

BENCH = ROOT / "tests" / "bench"


def run(*arguments):
    subprocess.run([sys.executable, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def test_whole(tmp_path):
    run(BENCH / "whole.py", "--quick", "--csv", tmp_path / "whole.csv")
    assert (tmp_path / "whole.csv").read_text().count("\n") == 8


def test_scenes(drape, tmp_path):
    scene = ROOT / "examples" / "hanging_wool" / "scene.toml"
    drape("bench", "scenes", "--quick", "--scene", scene, "--csv", tmp_path / "scenes.csv")
    assert (tmp_path / "scenes.csv").read_text().count("hanging_wool") == 2
    assert drape("bench", "scenes", "--scene", "nowhere.toml", check=False).returncode == 1


def test_plot(tmp_path):
    """The committed picture is that of the committed table."""
    run(BENCH / "plot.py", BENCH / "results" / "epyc_zen5.csv", tmp_path / "speed.svg")
    assert (tmp_path / "speed.svg").read_text() == (BENCH / "results" / "epyc_zen5.svg").read_text()
