"""`drape run` says how far it is and how it ended, keeps what it has written, and reads what ends."""
import os
import pty
import re
import signal
import subprocess
import time

import pytest
from scenes import HANGING, ROOT, pin_edge, read_csv, sheet, swinging_sheet, two_strips

COMMAND = ROOT / "build" / "drape"


def run(*arguments, seconds=60, **named):
    return subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, timeout=seconds, **named)


CLOSING = (r"sheet: (\S+) s of cloth in (\S+) s, (\S+) times its time; (\d+) steps; "
           r"reading (\S+) s, stepping (\S+) s, outputs (\S+?) s(?:, frames (\S+?) s)?(?:, report (\S+) s)?\n")


def closing_line(text):
    """Its numbers: cloth's time, seconds, ratio, steps, then the stages."""
    found = re.fullmatch(CLOSING, text)
    assert found, text
    return [float(number or 0) for number in found.groups()]


def test_closing_line(write, tmp_path):
    begin = time.perf_counter()
    done = run("run", write(swinging_sheet()), "-o", tmp_path / "run", "--until", 0.1, "--frames", "--report", tmp_path / "report.txt")
    spent = time.perf_counter() - begin
    assert done.returncode == 0 and done.stderr == ""
    cloth, seconds, ratio, steps, *stages = closing_line(done.stdout)
    assert cloth == 0.1 and seconds <= spent and ratio == pytest.approx(seconds / 0.1, rel=0.02)
    assert len(stages) == 5 and all(stage > 0 for stage in stages)
    assert sum(stages) == pytest.approx(seconds, rel=0.05)
    names, rows = read_csv(tmp_path / "run" / "outputs.csv")
    assert steps == rows[-1][names.index("step.count")]


def test_closing_line_after_a_failure(write, tmp_path):
    """The step limit falls below the given step where the cloth is jerked up."""
    scene = swinging_sheet(step=2e-5, duration=0.1)
    scene["pin"][0] |= {"drive": "position"}
    inputs = tmp_path / "jerk.csv"
    inputs.write_text("time,pin.left.position[3]\n0,1\n0.01,1\n0.02,1.15\n")
    done = run("run", write(scene), "-o", tmp_path / "run", "--inputs", inputs)
    assert done.returncode == 2 and done.stderr.startswith("error: ")
    assert 0 < closing_line(done.stdout)[0] < 0.1


def on_terminal(arguments, until, seconds=60):
    """What the command writes to a terminal of 100 columns until that holds `until`; then it is interrupted."""
    own, its = pty.openpty()
    subprocess.run(["stty", "cols", "100"], stdin=its, check=True)
    going = subprocess.Popen([COMMAND, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=its)
    os.close(its)
    text, end = "", time.monotonic() + seconds
    while time.monotonic() < end:
        try:
            text += os.read(own, 4096).decode()
        except OSError:  # the command has ended
            break
        if until and until in text and not going.poll():
            going.send_signal(signal.SIGINT)
            until = None
    os.close(own)
    try:
        return text, going.wait(timeout=seconds)
    finally:
        going.kill()


def test_progress_on_a_terminal(write, tmp_path):
    scene = write(swinging_sheet(duration=1000.0))
    text, code = on_terminal(["run", scene, "-o", tmp_path / "run", "--every", 0.01], until=" left; step ")
    assert code == 2
    *lines, last, end = re.split(r"\r(?!\n)", text)
    step = r"; step \S+ us, set by \w+ link of piece 'sheet'.*"
    assert re.fullmatch(r"  0\.0 %, 0 of 1000 s" + step, lines[1]), lines
    assert re.fullmatch(r"  \d\.\d %, \S+ of 1000 s, [\d:]+ left" + step, lines[2]), lines
    assert all(len(line) < 100 for line in lines)
    assert last.strip() == "" and re.fullmatch(r"error: interrupted at \S+ s; what was asked for is complete up to there\r?\n", end)
    text, code = on_terminal(["run", scene, "-o", tmp_path / "run", "--until", 0.3, "--no-progress"], until=None)
    assert code == 0 and text == ""


def test_progress_where_there_is_no_terminal(write, tmp_path):
    """None unless asked for; and a line for progress changes no result, not even forces of pins over a row."""
    scene = sheet(0.1, 0.1, 0.004, HANGING, duration=0.04)
    pin_edge(scene, "rod", 2)
    table = tmp_path / "run" / "outputs.csv"
    plain = run("run", write(scene), "-o", tmp_path / "run", "--every", 0.02)
    assert plain.returncode == 0 and plain.stderr == ""
    before = table.read_bytes()
    shown = run("run", write(scene), "-o", tmp_path / "run", "--every", 0.02, "--progress")
    _, first, *_, last = shown.stderr.splitlines()  # which ends lines at \r too
    assert shown.returncode == 0 and first.startswith("  0.0 %, 0 of 0.04 s; step ") and last.strip() == ""
    assert table.read_bytes() == before and b"pin.rod.force" in before
    both = run("run", write(scene), "-o", tmp_path / "run", "--progress", "--no-progress")
    assert both.returncode == 1 and both.stderr == "error: --progress and --no-progress are both given; allowed: one of them\n"


def test_progress_of_a_fit(write, tmp_path):
    """The unbalanced forces and the seams that are open; no time that is left. Pins on both sides hold the seam open."""
    scene = two_strips(gap=(0.01, 0, 0), mode="fit", duration=1000.0)
    scene["pin"] = [{"name": side, "piece": piece, "edges": [edge]} for side, piece, edge in (("a", "sheet", 1), ("b", "right", 3))]
    text, _ = on_terminal(["run", write(scene), "-o", tmp_path / "run", "--every", 0.05], until="open")
    assert re.search(r"of 1000 s(; residual \S+ of the load)?; 1 seam open", text), text
    assert " left" not in text and "set by" not in text


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
    frames = (tmp_path / "run" / "frames.pvd").read_text()
    assert report.read_text() and float(re.findall(r'timestep="([^"]*)"', frames)[-1]) == rows[-1][0]
    assert frames.endswith("</VTKFile>\n")
