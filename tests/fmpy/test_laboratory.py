"""`drape fabric test`, `calibrate` and `smooth`, and the examples of the laboratory, which end with checks of their own."""
import os
import random
import re
import subprocess
import sys
import tomllib

import pytest
from scenes import ROOT, swinging_sheet

FABRICS = ROOT / "examples" / "fabrics"
FABRIC = """# a cloth of ours
areal_density = 0.2
thickness = 0.0004   # m
[warp]
elongation_percent = [0, 1, 2]
force = [0, 6, 15]   # N
[weft]
elongation_percent = [0, 2, 4]
force = [0, 8, 20]
[bias]
elongation_percent = [0, 2, 4, 6]
force = [0, 0.4, 0.9, 1.5]
"""


@pytest.fixture
def fabric(tmp_path):
    def write(text=FABRIC):
        file = tmp_path / "ours.toml"
        file.write_text(text)
        return file

    return write


def differences(output):
    """Of all points of all strips, in %."""
    return [float(x) for x in re.findall(r"^ +[\d.e-]+ +[\d.e-]+ +[\d.e-]+ +([+-][\d.]+)$", output, re.MULTILINE)]


@pytest.mark.parametrize("name", ["cotton", "half_wool", "quilting_cotton", "wool"])
def test_shipped_fabrics_give_back_their_diagrams(drape, name, tmp_path):
    picture = tmp_path / "diagrams.svg"
    out = drape("fabric", "test", FABRICS / f"{name}.toml", "--picture", picture, "--along", "weft").stdout
    found = differences(out)
    assert len(found) >= 9 and max(map(abs, found)) < 0.05
    assert "PT-2" in out and "41.5 degrees" in out and "calibrated" in out
    assert picture.read_text().startswith("<svg")


def test_calibration_keeps_the_text_and_is_found_again(drape, fabric):
    file = fabric()
    raw = differences(drape("fabric", "test", file, "--cell", 0.0125).stdout)
    assert max(map(abs, raw)) > 0.5
    drape("fabric", "calibrate", file, "--cell", 0.0125)
    lines = file.read_text().splitlines()
    kept = [line for line in FABRIC.splitlines() if line not in lines]
    assert kept == []
    assert re.search(r'^date = "\d{4}-\d\d-\d\d"$', file.read_text(), re.MULTILINE)
    again = differences(drape("fabric", "test", file, "--cell", 0.0125).stdout)
    assert len(again) == len(raw) == 7 and max(map(abs, again)) < 0.011


def test_check_tells_what_to_expect_without_calibration(drape, write, fabric):
    scene = swinging_sheet()
    name = next(iter(scene["fabric"]))
    scene["fabric"][name] = {"file": str(fabric())}
    raw = drape("check", write(scene)).stdout
    assert len(re.findall(rf"^fabric {name}: (warp|weft|bias) is not calibrated; a simulated strip pulls up to", raw, re.M)) == 3
    drape("fabric", "calibrate", fabric(), "--cell", 0.0125)
    assert "calibrated" not in drape("check", write(scene)).stdout


def test_check_tells_where_the_clamp_correction_does_not_hold(drape, write, fabric):
    """K = r (r - 1.25)/(r - 1)^2 rises as strips get shorter only down to r = 5/3."""
    scene = swinging_sheet()
    name = next(iter(scene["fabric"]))
    for gauge, told in ((0.075, True), (0.1, False)):
        scene["fabric"][name] = {"file": str(fabric(FABRIC + f"[strip]\nwidth = 0.05\ngauge = {gauge}\n"))}
        out = drape("check", write(scene)).stdout
        assert (f"fabric {name}: strip has gauge/width = 1.5; the clamp correction of bias holds from 1.667 on" in out) == told


def test_calibration_starts_afresh(drape, fabric):
    """Corrections of a diagram whose points have changed since are no error, and have no effect."""
    file = fabric()
    sweeps = drape("fabric", "calibrate", file, "--cell", 0.0125).stdout
    first = file.read_text()
    assert drape("fabric", "calibrate", file, "--cell", 0.0125).stdout == sweeps
    assert file.read_text() == first
    file.write_text(first.replace("[0, 2, 4, 6]", "[0, 2, 4, 6, 8]").replace("[0, 0.4, 0.9, 1.5]", "[0, 0.4, 0.9, 1.5, 2.3]"))
    assert "correction" in drape("fabric", "test", file, check=False).stderr
    drape("fabric", "calibrate", file, "--cell", 0.0125)
    assert len(differences(drape("fabric", "test", file, "--cell", 0.0125).stdout)) == 8


def test_slack_toes_are_pulled(drape, fabric):
    text = FABRIC.replace("[0, 8, 20]", "[0, 0, 20]").replace("[0, 0.4, 0.9, 1.5]", "[0, 0, 0.9, 1.5]")
    out = drape("fabric", "test", fabric(text), "--cell", 0.0125).stdout
    assert len(differences(out)) == 5 and len(re.findall(r" -$", out, re.MULTILINE)) == 2


def test_calibration_into_another_file(drape, fabric, tmp_path):
    file, other = fabric(), tmp_path / "other.toml"
    drape("fabric", "calibrate", file, "--cell", 0.0125, "-o", other)
    assert file.read_text() == FABRIC and "[calibration]" in other.read_text()


WARP = "force = [0, 6, 15]"
FAULTS = {
    "pull beyond the diagram": (FABRIC, ["test", "--pull", "5"], ["--pull", "2 percent", "warp", "4 percent", "weft"], 2),
    "cells too large": (FABRIC, ["test", "--cell", "0.02"], ["--cell", "0.02", "0.0125", "four cells"], 1),
    "cells too small": (FABRIC, ["calibrate", "--cell", "1e-5"], ["--cell", "1e-05", "0.00025"], 1),
    "no cell": (FABRIC, ["calibrate", "--cell", "-1"], ["--cell", "-1", "above 0"], 1),
    "short specimen": (FABRIC + "jaws = false\n[strip]\ngauge = 0.01\n", ["test"], ["0.003125", "0.0025"], 1),
    "strip too short for K": (FABRIC + "[strip]\ngauge = 0.06\n", ["calibrate"], ["gauge/width = 1.2", "above 1.25", "bias.jaws"], 1),
    "bias far out": (FABRIC.replace("[0, 2, 4, 6]", "[0, 41.4]").replace("[0, 0.4, 0.9, 1.5]", "[0, 5]"), ["test"],
                     ["fabric.ours.bias", "no odd law", "nearer to 0 percent"], 1),
    "no diagram": ("areal_density = 0.2\nthickness = 0.0004\n", ["calibrate"], ["no diagram"], 1),
    "faulty fabric": (FABRIC.replace(WARP, "force = [0, 6, 5]"), ["calibrate"], ["warp.force[2]", "5 N"], 1),
    "output is the input": (FABRIC, ["calibrate", "-o", "ours.toml"], ["--output", "ours.toml", "read from"], 1),
    "nowhere to write": (FABRIC, ["calibrate", "--cell", "0.0125", "-o", "no/where.toml"], ["no/where.toml"], 1),
    "picture over the input": (FABRIC, ["test", "--picture", "ours.toml"], ["--picture", "read from"], 1),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_bad_input(drape, fabric, tmp_path, fault):
    text, (command, *options), words, sentences = FAULTS[fault]
    file = fabric(text)
    done = drape("fabric", command, file, *options, check=False, cwd=tmp_path)
    assert done.returncode == 1, done.stdout
    lines = done.stderr.strip().splitlines()
    assert len(lines) == sentences, lines
    for word in words:
        assert word in done.stderr, (word, lines)
    assert file.read_text() == text


def test_calibration_that_does_not_converge_keeps_the_old_figures(drape, fabric):
    """The diagonals of this cloth pull harder than its stated warp."""
    text = FABRIC.replace(WARP, "force = [0, 0.05, 0.1]")
    file = fabric(text)
    done = drape("fabric", "calibrate", file, "--cell", 0.0125, check=False)
    assert done.returncode == 2
    assert "does not converge" in done.stderr and "reached" in done.stderr
    assert file.read_text() == text


def tester(noise=0.3, pretension=0.0, scale=1.0, count=801):
    """A fabric file whose warp is what a tester wrote, up to and beyond the break."""
    draw = random.Random(3)
    elongation = [0.0125 * k for k in range(count)]
    force = [scale * (12 * e + 3 * e**2.2) + pretension + draw.gauss(0, noise) for e in elongation]
    elongation, force = [*elongation, 10.3, 10.6], [*force, 60, 5]
    lists = f"elongation_percent = {[round(e, 5) for e in elongation]}\nforce = {[round(f, 5) for f in force]}   # N"
    return FABRIC.replace("elongation_percent = [0, 1, 2]\nforce = [0, 6, 15]   # N", lists)


def test_smooth_makes_a_diagram_of_a_record(drape, fabric, write, tmp_path):
    raw, out = fabric(tester(pretension=2.0)), tmp_path / "smooth.toml"
    scene = swinging_sheet()
    name = next(iter(scene["fabric"]))
    scene["fabric"][name] = {"file": str(raw)}
    refused = drape("check", write(scene), check=False)
    assert refused.returncode == 1 and len(refused.stderr.splitlines()) < 6 and "drape fabric smooth" in refused.stderr

    done = drape("fabric", "smooth", raw, "-o", out)
    assert "warp: 803 samples" in done.stdout and "a pretension of" in done.stdout and "the break" in done.stdout
    assert "estimated from the scatter" in done.stdout and "not calibrated" in done.stdout
    assert done.stderr == ""
    before, after = tomllib.loads(raw.read_text()), tomllib.loads(out.read_text())
    assert after["warp"]["raw"] == before["warp"]
    assert after["weft"] == before["weft"] and after["bias"] == before["bias"], "smooth already"
    assert [line for line in FABRIC.splitlines() if line.startswith("#") or "thickness" in line][0] in out.read_text()
    assert len(after["warp"]["force"]) <= 64
    scene["fabric"][name] = {"file": str(out)}
    checked = drape("check", write(scene))
    path = float(re.search(rf"^fabric {name}: slope path of warp ([\d.]+), weft", checked.stdout, re.M)[1])
    assert path <= 1.5 and checked.stderr == ""


def test_smooth_finds_the_same_again(drape, fabric, tmp_path):
    once, twice = tmp_path / "once.toml", tmp_path / "twice.toml"
    drape("fabric", "smooth", fabric(tester()), "-o", once, "--resolution", 0.3)
    drape("fabric", "smooth", once, "-o", twice, "--resolution", 0.3)
    assert twice.read_bytes() == once.read_bytes()
    coarser = drape("fabric", "smooth", once, "-o", twice, "--resolution", 3)
    assert "803 samples" in coarser.stdout, "the samples are smoothed again, not the points"
    points = [len(tomllib.loads(file.read_text())["warp"]["force"]) for file in (once, twice)]
    assert points[1] < points[0]


def test_smooth_leaves_a_smooth_fabric_as_it_is(drape, tmp_path):
    out = tmp_path / "cotton.toml"
    said = drape("fabric", "smooth", FABRICS / "cotton.toml", "-o", out).stdout
    assert said.count("smooth as they are") == 3
    assert out.read_bytes() == (FABRICS / "cotton.toml").read_bytes()


def test_smooth_calibrates_a_calibrated_file_anew(drape, fabric, tmp_path):
    file, out = fabric(), tmp_path / "out.toml"
    drape("fabric", "calibrate", file, "--cell", 0.0125)
    calibrated = file.read_text()
    noisy = calibrated.replace("elongation_percent = [0, 1, 2]", "elongation_percent = [0, 0.4, 0.8, 1.2, 1.6, 2]")
    file.write_text(noisy.replace("force = [0, 6, 15]", "force = [0, 2.1, 4.9, 7.1, 12.2, 15]"))
    said = drape("fabric", "smooth", file, "-o", out, "--resolution", 0.4).stdout
    assert "calibrated anew" in said and "sweep 1" in said
    again = differences(drape("fabric", "test", out, "--cell", 0.0125).stdout)
    assert max(map(abs, again)) < 0.011
    assert tomllib.loads(out.read_text())["calibration"]["cell"] == 0.0125


def test_check_warns_of_noise(drape, write, fabric):
    scene = swinging_sheet()
    name = next(iter(scene["fabric"]))
    noisy = FABRIC.replace("[0, 1, 2]", "[0, 0.5, 1, 1.5, 2]").replace("[0, 6, 15]", "[0, 4, 5, 12, 15]")
    scene["fabric"][name] = {"file": str(fabric(noisy))}
    warned = [line for line in drape("check", write(scene)).stderr.splitlines() if "slope" in line]
    assert len(warned) == 1 and "warp" in warned[0] and "drape fabric smooth" in warned[0]


def test_smooth_doubts_fractions(drape, fabric, tmp_path):
    text = tester().replace("elongation_percent = [0.0,", "extension_mm = [0.0,", 1)  # of 200 mm: 0.0 to 5.3 %
    assert drape("fabric", "smooth", fabric(text), "-o", tmp_path / "mm.toml").stderr == ""
    text = FABRIC.replace("elongation_percent = [0, 1, 2]", "elongation_percent = [0, 0.001, 0.002]")
    said = drape("fabric", "smooth", fabric(text), "-o", tmp_path / "fractions.toml").stderr
    assert len(said.splitlines()) == 1 and "fractions" in said and "0.002 %" in said


SMOOTH_FAULTS = {
    "negative": (["--resolution", "-1"], ["--resolution", "-1", "above 0 N"]),
    "zero": (["--resolution", "0"], ["--resolution", "above 0 N"]),
    "not a number": (["--resolution", "nan"], ["--resolution", "nan", "above 0 N"]),
    "more than all forces": (["--resolution", "21"], ["--resolution", "21", "20 N", "greatest force"]),
    "output is the input": (["-o", "ours.toml"], ["--output", "ours.toml", "read from"]),
    "output without a name": (["-o", ""], ["--output is empty"]),
    "output is a folder": (["-o", "."], ["cannot write", "Is a directory"]),
    "nowhere to write": (["-o", "no/where.toml"], ["no/where.toml"]),
}


@pytest.mark.parametrize("fault", SMOOTH_FAULTS)
def test_smooth_refuses_options(drape, fabric, tmp_path, fault):
    options, words = SMOOTH_FAULTS[fault]
    file = fabric()
    output = [] if "-o" in options else ["-o", "out.toml"]
    done = drape("fabric", "smooth", file, *output, *options, check=False, cwd=tmp_path)
    assert done.returncode == 1 and len(done.stderr.strip().splitlines()) == 1, done.stderr
    for word in words:
        assert word in done.stderr
    assert file.read_text() == FABRIC and sorted(p.name for p in tmp_path.iterdir()) == ["ours.toml"]


SMOOTH_FILES = {
    "no diagram": ("areal_density = 0.2\nthickness = 0.0004\n", ["no diagram"]),
    "two points": ("areal_density = 0.2\nthickness = 0.0004\n[warp]\nelongation_percent = [0, 1]\nforce = [0, 5]\n",
                   ["warp has 2 points", "at least 3"]),
    "no force": (FABRIC.replace("[0, 6, 15]", "[0, -1, -2]"), ["warp has no force above 0 N"]),
    "lists of two lengths": (FABRIC.replace("[0, 6, 15]", "[0, 6]"), ["warp.force has 2 entries", "as many"]),
    "no text": ("[warp\n", ["not valid TOML"]),
}


@pytest.mark.parametrize("fault", SMOOTH_FILES)
def test_smooth_refuses_files(drape, fabric, tmp_path, fault):
    text, words = SMOOTH_FILES[fault]
    done = drape("fabric", "smooth", fabric(text), "-o", tmp_path / "out.toml", check=False)
    assert done.returncode == 1 and len(done.stderr.strip().splitlines()) == 1, done.stderr
    for word in words:
        assert word in done.stderr
    assert not (tmp_path / "out.toml").exists()


def test_smooth_reads_no_pipe(drape, tmp_path):
    os.mkfifo(tmp_path / "pipe.toml")
    done = drape("fabric", "smooth", tmp_path / "pipe.toml", "-o", tmp_path / "out.toml", check=False)
    assert done.returncode == 1 and "not a regular file" in done.stderr


@pytest.mark.parametrize("example, options", [("strip_test", []), ("pt2", []), ("mesh_independence", ["--quick"])])
def test_example(tmp_path, example, options):
    script = ROOT / "examples" / example / "run.py"
    done = subprocess.run([sys.executable, script, tmp_path, *options], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert (tmp_path / f"{example}.png").read_bytes().startswith(b"\x89PNG")
