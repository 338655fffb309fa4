"""What the README promises: its script runs, its tables are those of the program, the example passes its own check."""
import re
import subprocess
import sys

import pytest
from convergence import markdown
from scenes import ROOT

README = (ROOT / "README.md").read_text()


def block(language):
    """The text of the only fenced block of a language."""
    (text,) = re.findall(rf"```{language}\n(.*?)```", README, re.DOTALL)
    return text


def section(name):
    """The text between <!-- name --> and <!-- /name -->."""
    return re.search(rf"<!-- {name} -->\n(.*?)\n<!-- /{name} -->", README, re.DOTALL)[1]


def test_script():
    script = block("python")
    assert len(script.strip().splitlines()) <= 15
    done = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    packed, *lines = [line for line in done.stdout.strip().splitlines() if not line.startswith("win64: ")]
    assert re.match(r"linux64: [0-9.]+ MB, needs glibc 2\.\d+", packed)
    assert len(lines) == 16
    assert lines[0].startswith("0.00 s: tip at 1.000 m")
    height = [float(re.search(r"tip at ([\d.]+) m", line)[1]) for line in lines]
    assert height == sorted(height, reverse=True)
    assert height[-1] < 0.75


def test_scene():
    """The README's scene is the example's with some lines left out."""
    lines = iter((ROOT / "examples" / "hanging_wool" / "scene.toml").read_text().splitlines())
    shown = block("toml").splitlines()
    assert len(shown) > 15
    for line in shown:
        assert line in lines, f"{line!r} is not in the example's scene, or not in this order"


def test_variables(drape):
    scene = ROOT / "examples" / "hanging_wool" / "scene.toml"
    assert section("variables") == drape("variables", scene).stdout.strip()


def test_accuracy(undamped):
    """The printed figures, to 5 %: the last ones are near the rounding of the positions."""

    def figures(table):
        return [[float(x) for x in re.findall(r"[\d.]+(?:e-\d+)?", line)] for line in table.splitlines()[2:]]

    printed = figures(section("accuracy"))
    assert len(printed) == 8
    for there, here in zip(printed, figures(markdown(**undamped)), strict=True):
        assert there == pytest.approx(here, rel=0.05)


def test_pictures():
    names = re.findall(r"!\[[^]]*\]\(([^)]+)\)", README)
    assert names
    for name in names:
        assert (ROOT / name).read_bytes().startswith(b"<?xml" if name.endswith(".svg") else b"\x89PNG")
        assert (ROOT / name).stat().st_size < 300_000


def test_links():
    for target in re.findall(r"\]\(([^):]+)\)", README):
        assert (ROOT / target).exists(), target


def test_hanging_wool(tmp_path):
    """The example ends with a check of its own; a failed check gives a non-zero exit code. Its README
    has the pull on the peg that it prints."""
    example = ROOT / "examples" / "hanging_wool"
    done = subprocess.run([sys.executable, example / "run.py", tmp_path], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert sorted(p.suffix for p in tmp_path.iterdir()) == [".csv", ".fmu", ".png"]
    (printed,) = re.findall(r"largest pull on the peg: ([\d.]+) times the weight", done.stdout)
    (told,) = re.findall(r"([\d.]+) times its\s+weight", (example / "README.md").read_text())
    assert told == printed
