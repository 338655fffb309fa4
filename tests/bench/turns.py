"""Scenes that go on by turns in one FMPy process, so that what slows the machine down slows all of them down."""
import statistics
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "fmpy"))
from master import Fmu, Instance  # noqa: E402


class Run:
    def __init__(self, folder, number, text):
        scene = folder / f"variant{number}.toml"
        scene.write_text(text)
        packed = scene.with_suffix(".fmu")
        subprocess.run([ROOT / "build" / "drape", "pack", scene, "-o", packed], check=True, stdout=subprocess.DEVNULL)
        self.instance = Instance(Fmu(packed)).initialize()
        self.time = 0.0

    def advance(self, length):
        """Seconds a step."""
        steps, start = self.instance.get("step.count")[0], time.perf_counter()
        self.instance.slave.doStep(self.time, length)
        taken = time.perf_counter() - start
        self.time += length
        return taken / (self.instance.get("step.count")[0] - steps)


def microseconds(runs, settle, length, turns):
    """{name: median of microseconds a step} of runs by name, each of `turns` turns of `length` s after `settle` s."""
    for run in runs.values():
        run.advance(settle)
    times = {name: [] for name in runs}
    for _ in range(turns):
        for name, run in runs.items():
            times[name].append(1e6 * run.advance(length))
    return {name: statistics.median(values) for name, values in times.items()}
