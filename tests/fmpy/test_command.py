"""The command on faulty scenes: exit code 1, every problem at once, one sentence each with place and range."""
import math

import pytest
from scenes import swinging_sheet


def broken(change):
    scene = swinging_sheet()
    change(scene)
    return scene


def set_key(table, key, value):
    return lambda scene: table(scene).update({key: value})


def falling(scene):
    scene["fabric"]["wool"]["warp"] = {"elongation_percent": [0, 1, 2], "force": [0, 5, 4]}


SCENE = lambda s: s["scene"]
WOOL = lambda s: s["fabric"]["wool"]
PIECE = lambda s: s["piece"][0]

# what is wrong -> (how to break the scene, words that the sentence must hold)
FAULTS = {
    "unknown key": (set_key(SCENE, "dampping", 1.0), ["dampping", "damping"]),
    "missing fabric file": (set_key(WOOL, "file", "no_such_file.toml"), ["no_such_file.toml"]),
    "negative density": (set_key(WOOL, "areal_density", -0.15), ["areal_density", "-0.15", "allowed", "kg/m"]),
    "density not a number": (set_key(WOOL, "areal_density", math.nan), ["areal_density", "nan"]),
    "falling diagram": (falling, ["warp", "4", "5"]),
    "cell larger than the piece": (set_key(PIECE, "cell", 0.2), ["cell", "0.2", "m"]),
    "step above the limit": (set_key(SCENE, "step", 0.001), ["step", "0.001", "s"]),
    "step of zero": (set_key(SCENE, "step", 0.0), ["step", "0"]),
    "unknown fabric": (set_key(PIECE, "fabric", "wol"), ["wol", "wool"]),
    "negative duration": (set_key(SCENE, "duration", -1.0), ["duration", "-1", "s"]),
    "wrong type": (set_key(SCENE, "damping", "strong"), ["damping"]),
    "pin off the piece": (lambda s: s["pin"][0].update(at=[[0.5, 0.5]]), ["pin", "0.5"]),
    "pin on no edge": (lambda s: s["pin"].append({"name": "x", "piece": "sheet", "edges": [9]}), ["pin", "9"]),
}


COMMANDS = ["check", "run", "pack", "reference"]
# ARKODE chooses its own steps.
CASES = [(f, c) for f in FAULTS for c in COMMANDS if (f, c) != ("step above the limit", "reference")]


@pytest.mark.parametrize("fault, command", CASES)
def test_one_fault(drape, write, tmp_path, fault, command):
    change, words = FAULTS[fault]
    out = ["-o", tmp_path / "out"] if command != "check" else []
    done = drape(command, write(broken(change)), *out, check=False)
    sentences = done.stderr.strip().splitlines()
    assert done.returncode == 1
    assert len(sentences) == 1, sentences
    for word in words:
        assert word in sentences[0], (word, sentences[0])
    assert not (tmp_path / "out").exists()


def test_all_faults_at_once(drape, write):
    names = ["unknown key", "negative density", "falling diagram", "negative duration", "pin off the piece"]

    def all_of_them(scene):
        for name in names:
            FAULTS[name][0](scene)

    done = drape("check", write(broken(all_of_them)), check=False)
    sentences = done.stderr.strip().splitlines()
    assert done.returncode == 1
    assert len(sentences) == len(names)
    for name in names:
        assert any(all(word in sentence for word in FAULTS[name][1]) for sentence in sentences), name


def test_scene_that_is_not_there(drape, tmp_path):
    done = drape("check", tmp_path / "nothing.toml", check=False)
    assert done.returncode == 1
    assert "nothing.toml" in done.stderr


def test_text_that_is_not_toml(drape, write):
    done = drape("check", write("[scene\nname = 3"), check=False)
    assert done.returncode == 1
    assert "scene.toml:1:" in done.stderr


def test_check_tells_what_the_scene_is(drape, write):
    done = drape("check", write(swinging_sheet()))
    for word in ("sheet", "121", "step"):  # 11 x 11 particles
        assert word in done.stdout


def test_last_row_is_the_end_state(drape, write, tmp_path):
    """--until is no multiple of --every."""
    drape("run", write(swinging_sheet()), "-o", tmp_path / "run", "--until", 0.005, "--every", 0.002)
    times = [float(line.split(",")[0]) for line in (tmp_path / "run" / "outputs.csv").read_text().splitlines()[1:]]
    assert times == pytest.approx([0.0, 0.002, 0.004, 0.005], rel=1e-12)


def test_set_is_the_start_value(drape, write, tmp_path):
    scene = swinging_sheet()
    drape("run", write(scene, "a"), "-o", tmp_path / "a", "--until", 0.01, "--set", "damping=7")
    scene["scene"]["damping"] = 7.0
    drape("run", write(scene, "b"), "-o", tmp_path / "b", "--until", 0.01)
    assert (tmp_path / "a" / "outputs.csv").read_bytes() == (tmp_path / "b" / "outputs.csv").read_bytes()


def test_help_and_version(drape):
    assert "check" in drape("--help").stdout
    assert "0.1.0" in drape("--version").stdout
