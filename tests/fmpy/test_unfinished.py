"""A fit without rest, an open seam and missing energy: the command, its report and the log of the FMU say the same."""
import csv

import pytest
from fmpy.fmi2 import fmi2OK
from master import WARNING, Instance
from scenes import pin_edge, sheet, swinging_sheet, two_strips


def fit_without_rest():
    scene = swinging_sheet(duration=0.02)
    scene["scene"] |= {"mode": "fit"}
    return scene


def open_seam():
    return two_strips(gap=(0.01, 0, 0), duration=0.002)


def missing_energy():
    """A thrown cloth at a given step close to its limit, which gains 2 % of its energy: a given step is not refined."""
    level = {"origin": [0.0, 0.0, 0.0], "axis_x": [1.0, 0.0, 0.0], "axis_y": [0.0, 0.0, 1.0]}
    scene = sheet(0.15, 0.28, 0.0345, level, duration=0.02)
    scene["scene"] |= {"energy": True, "step": 1e-4}
    scene["piece"][0]["velocity"] = [0.0, 0.0, 0.3]
    pin_edge(scene, "top", 2)
    return scene


def closed_seam():
    return two_strips(gap=(0, 0, 0), duration=0.002)


def seam_not_due():
    scene = open_seam()
    scene["seam"][0] |= {"closed_at": 1.0}
    return scene


def warnings_of(fmu, until):
    """What the log gains at fmi2Terminate."""
    with Instance(fmu) as cloth:
        cloth.initialize(stop_time=until).run(until, until / 2)
        before = len(cloth.log)
        assert cloth.status(cloth.slave.terminate) == fmi2OK
        for status, category, _ in cloth.log[before:]:
            assert (status, category) == (WARNING, "logStatusWarning")
        return [message for _, _, message in cloth.log[before:]]


@pytest.mark.parametrize("scene, words", [(fit_without_rest, "the fit has not come to rest: forces of "),
                                          (open_seam, "the seam 'join' has not closed: its largest gap is "),
                                          (missing_energy, " J that no force accounts for, ")])
def test_the_fmu_says_what_the_command_says(drape, pack, write, tmp_path, scene, words):
    until = scene()["scene"]["duration"]
    done = drape("run", write(scene()), "-o", tmp_path / "run", "--every", until / 2, check=False)
    told = [line.removeprefix("error: ") for line in done.stderr.splitlines()]
    assert done.returncode == 2 and len(told) == 1 and words in told[0]
    assert warnings_of(pack(scene()), until) == told


@pytest.mark.parametrize("scene", [closed_seam, seam_not_due])
def test_nothing_is_missing(pack, scene):
    assert warnings_of(pack(scene()), 0.002) == []


def report_of(drape, write, tmp_path, scene):
    report = tmp_path / "report.csv"
    drape("run", write(scene), "-o", tmp_path / "run", "--report", report, check=False)
    with open(report, newline="") as lines:
        return {(r["table"], r["quantity"]): float(r["value"]) for r in csv.DictReader(lines)}


def test_the_report_tells_it(drape, write, tmp_path):
    rows = report_of(drape, write, tmp_path, fit_without_rest())
    assert rows["fit", "unbalanced forces"] > rows["fit", "allowed"] == 1e-5 and rows["fit", "at rest"] == 0
    for scene, due, closed in ((open_seam(), 1, 0), (closed_seam(), 1, 1), (seam_not_due(), 0, 0)):
        rows = report_of(drape, write, tmp_path, scene)
        assert (rows["seams", "told to close"], rows["seams", "closed"]) == (due, closed)
        assert not any(table == "fit" for table, _ in rows)
