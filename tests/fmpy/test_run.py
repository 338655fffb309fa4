"""`drape run` says how it ended, keeps what it has written, and reads what ends."""
import os
import signal
import subprocess
import time

import pytest
from scenes import ROOT, read_csv, swinging_sheet, two_strips

COMMAND = ROOT / "build" / "drape"


def run(*arguments, seconds=60, **named):
    return subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, timeout=seconds, **named)


def test_closing_line(write, tmp_path):
    done = run("run", write(swinging_sheet()), "-o", tmp_path / "run", "--until", 0.01)
    assert done.returncode == 0 and done.stderr == ""
    assert "0.01 s of cloth in " in done.stdout and " steps" in done.stdout


def test_fit_that_does_not_rest(write, tmp_path):
    scene = swinging_sheet()
    scene["scene"] |= {"mode": "fit", "duration": 0.02}
    for until, code, word in ((0.02, 2, "error"), (0.01, 0, "warning")):
        done = run("run", write(scene), "-o", tmp_path / "run", "--until", until)
        assert done.returncode == code and done.stderr.count("\n") == 1
        assert f"{word}: by {until} s the fit has not come to rest: forces of " in done.stderr


def test_seam_that_does_not_close(write, tmp_path):
    done = run("run", write(two_strips(gap=(0.01, 0, 0), duration=0.002)), "-o", tmp_path / "run")
    name = two_strips()["seam"][0]["name"]
    assert done.returncode == 2 and f"the seam '{name}' has not closed: its largest gap is " in done.stderr


def test_seam_that_is_not_due(write, tmp_path):
    scene = two_strips(gap=(0.01, 0, 0), duration=0.002)
    scene["seam"][0] |= {"closed_at": 1.0}
    done = run("run", write(scene), "-o", tmp_path / "run")
    assert done.returncode == 0 and done.stderr == ""


@pytest.fixture
def pipe(tmp_path):
    file = tmp_path / "pipe.csv"
    os.mkfifo(file)
    return file


def test_what_never_ends_is_not_read(write, tmp_path, pipe):
    scene = write(swinging_sheet())
    for arguments in (["check", pipe], ["check", "/dev/zero"], ["run", scene, "-o", tmp_path / "run", "--inputs", pipe],
                      ["run", scene, "-o", tmp_path / "run", "--inputs", "/dev/zero"], ["import", pipe, "-o", tmp_path / "a.toml"],
                      ["fabric", "test", "/dev/zero"]):
        done = run(*arguments, seconds=10)
        assert done.returncode == 1 and "is not a regular file" in done.stderr, arguments


def test_what_is_read_is_not_overwritten(write, tmp_path):
    scene = write(swinging_sheet())
    (tmp_path / "run").mkdir()
    table = tmp_path / "run" / "outputs.csv"
    table.write_text("time,wind[1]\n0,1\n")
    for command in ("run", "reference"):
        done = run(command, scene, "-o", tmp_path / "run", "--inputs", table)
        assert done.returncode == 1 and "which is read from" in done.stderr
        assert table.read_text() == "time,wind[1]\n0,1\n"
        done = run(command, scene, "-o", tmp_path / "other", "--inputs", "")
        assert done.returncode == 1 and done.stderr == "error: --inputs is empty; allowed: the name of a CSV file\n"


def test_full_device(write, tmp_path):
    done = run("run", write(swinging_sheet()), "-o", tmp_path / "run", "--until", 0.002, "--report", "/dev/full")
    assert done.returncode == 2 and "No space left on device" in done.stderr
    done = run("check", write(swinging_sheet()), "--picture", "/dev/full")
    assert done.returncode == 2 and "No space left on device" in done.stderr


def test_interrupt(write, tmp_path):
    """The row in work is ended, then the files; the exit code tells."""
    report = tmp_path / "report.txt"
    going = subprocess.Popen([COMMAND, "run", write(swinging_sheet()), "-o", tmp_path / "run", "--until", "1000", "--every", "0.001", "--frames",
                              "--report", report], stderr=subprocess.PIPE, text=True)
    table = tmp_path / "run" / "outputs.csv"
    while not table.exists() or table.read_bytes().count(b"\n") < 5:
        time.sleep(0.02)
        assert going.poll() is None
    going.send_signal(signal.SIGINT)
    _, told = going.communicate(timeout=30)
    assert going.returncode == 2 and "interrupted at " in told
    names, rows = read_csv(table)
    assert table.read_text().endswith("\n") and len(rows) >= 4 and all(len(row) == len(names) for row in rows)
    assert report.read_text() and f'timestep="{rows[-1][0]:g}"' in (tmp_path / "run" / "frames.pvd").read_text()
    assert (tmp_path / "run" / "frames.pvd").read_text().endswith("</VTKFile>\n")
