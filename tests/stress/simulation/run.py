"""Runs one simulation in processes of its own: by `drape run`, or by FMPy where parameters are tuned on the way."""
import json
import os
import re
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from .fabrics import ROOT

sys.path.insert(0, str(ROOT / "tests" / "fmpy"))
from scenes import toml, write_inputs  # noqa: E402

HANG_SECONDS = 60  # of processor time for each thread
HANG_WALL = 5  # times as long by the clock: other programs run too, and a run that waits for ever uses no processor


@dataclass
class Ended:
    code: int  # of the process; negative: killed by that signal
    hung: bool
    text: str  # what it wrote to stderr
    seconds: float  # of processor time


def watched(command, folder, limit):
    """Runs a command with a limit of processor time, and one by the clock."""
    log = folder / "stderr.txt"
    wrapped = ["bash", "-c", 'ulimit -c 0 -t "$0"; exec "$@"', str(limit), *map(str, command)]
    with open(log, "w") as errors:
        process = subprocess.Popen(wrapped, stdout=subprocess.DEVNULL, stderr=errors, cwd=folder)
        late, status, usage = wait(process, limit * HANG_WALL)
    process.returncode = code = os.waitstatus_to_exitcode(status)
    seconds = usage.ru_utime + usage.ru_stime
    return Ended(code, late or (code < 0 and seconds > 0.8 * limit), log.read_text(errors="replace"), seconds)


def wait(process, limit):
    """Waits for the end, and kills after `limit` seconds. Time in which the suite or the run is stopped does not count."""
    waited, pause = 0.0, 0.02
    while waited < limit:
        ended, status, usage = os.wait4(process.pid, os.WNOHANG)
        if ended:
            return False, status, usage
        time.sleep(pause)
        stat = Path(f"/proc/{process.pid}/stat").read_text()
        if stat.rpartition(")")[2].split()[0] != "T":
            waited += pause
        pause = min(0.2, 1.2 * pause)
    process.kill()
    return True, *os.wait4(process.pid, 0)[1:]


def start_values(drape, scene):
    """{"pin.p.position": [x, y, z]} of all inputs of a scene."""
    table = subprocess.run([drape, "variables", scene], capture_output=True, text=True).stdout
    rows = [line.split("|") for line in table.splitlines() if "| input |" in line]
    return {re.sub(r"\[1\.\.\d\]", "", row[1].strip(" `")): [float(x) for x in row[-2].split(",")] for row in rows}


def write(sim, drape, folder):
    """Writes the scene with all that it needs."""
    folder.mkdir(parents=True, exist_ok=True)
    scene = folder / "scene.toml"
    scene.write_text(toml({key: value for key, value in sim.scene.items() if value}))
    for name, text in sim.meshes.items():
        (folder / name).write_text(text)
    if sim.path:
        moments, path = sim.path(start_values(drape, scene))
        if path(0.0):  # without: the scene was refused
            write_inputs(folder / "inputs.csv", path, moments)
    if sim.tuning:
        (folder / "tuning.json").write_text(json.dumps(sim.tuning))


def command_of(sim, drape, folder, out, settings):
    """The command of a run into the folder `out`."""
    scene = folder / "scene.toml"
    settings = [*sim.settings, *settings]
    if sim.tuning:
        return [sys.executable, Path(__file__).with_name("tuned.py"), drape, folder, out, *settings]
    command = [drape, "run", scene, "-o", out, "--until", repr(sim.until), "--every", repr(sim.every)]
    if (folder / "inputs.csv").exists():
        command += ["--inputs", folder / "inputs.csv"]
    return command + (["--set", *settings] if settings else [])


def run(sim, drape, folder, settings=(), longer=1):
    """Writes and runs a simulation. Its rows are in out/outputs.csv of the folder."""
    write(sim, drape, folder)
    out = folder / ("out" if not settings else "again")
    threads = max([int(s.split("=")[1]) for s in sim.settings if s.startswith("threads=")], default=1)
    ended = watched(command_of(sim, drape, folder, out, settings), folder, HANG_SECONDS * threads * longer)
    return ended, out / "outputs.csv"
