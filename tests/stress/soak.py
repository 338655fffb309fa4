"""A long run of one FMU: memory stays flat, energy stays within what leapfrog keeps, and the clock stays exact.

    .venv/bin/python tests/stress/soak.py [--steps 20000000] [--cells 8]

A square of cloth with straight laws, undamped, hangs from two corners and is thrown. FMPy advances it by a hundredth of a second
at a time. Over the run, which takes a minute or two:

  memory   the resident set of the process grows by at most 1 MB after the first tenth
  energy   |energy.balance_error| stays below 0.5 % of the largest energy, what leapfrog's ripple comes to in stiff vibrations;
           its mean over the last fifth is within 0.2 % of that over the fifth before: nothing drifts
  clock    after N intervals of q the FMU still takes N q as its time, and refuses N q + 1e-5 q
"""
import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "fmpy"))
from master import OK, Fmu, Instance  # noqa: E402
from scenes import HORIZONTAL, ROOT, pin_points, sheet, toml  # noqa: E402

INTERVAL = 0.01  # s
RIPPLE, DRIFT, GROWTH = 5e-3, 2e-3, 1e6  # of the largest energy, twice; bytes
STRAIGHT = {
    "areal_density": 0.15, "thickness": 0.0005,
    "warp": {"elongation_percent": [0, 5], "force": [0, 10]},
    "weft": {"elongation_percent": [0, 5], "force": [0, 8]},
    "bias": {"elongation_percent": [0, 10], "force": [0, 4]},
    "bending": {"rigidity_uN_cm2": [2000, 900]},
}
ENERGIES = ["energy.kinetic", "energy.stretch", "energy.shear", "energy.bending"]


def resident():
    """Bytes."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * 4096


def square(cells):
    scene = sheet(0.01 * cells, 0.01 * cells, 0.01, HORIZONTAL, energy=True, communication=INTERVAL)
    scene["fabric"]["wool"] = STRAIGHT
    scene["piece"][0]["velocity"] = [0.2, 0.1, 0.2]
    pin_points(scene, "left", (0, 0.01 * cells))
    pin_points(scene, "right", (0.01 * cells, 0.01 * cells))
    return scene


def soak(cells, steps):
    """Faults, a line each."""
    with tempfile.TemporaryDirectory() as folder:
        file, packed = Path(folder) / "soak.toml", Path(folder) / "soak.fmu"
        file.write_text(toml(square(cells)))
        subprocess.run([ROOT / "build" / "drape", "pack", file, "-o", packed], check=True, stdout=subprocess.DEVNULL)
        cloth = Instance(Fmu(packed)).initialize()
    gravity = cloth.get("energy.gravity")[0]
    errors = np.full(int(steps), np.nan)  # of each interval: memory that the run does not ask for
    count, largest, taken, memory, started = 0, 0.0, 0.0, None, time.time()
    while taken < steps:
        if cloth.step(INTERVAL, at=count * INTERVAL) != OK:
            return [f"after {taken:.0f} steps: {cloth.log[-1]}"]
        taken, errors[count], now, *others = cloth.get("step.count", "energy.balance_error", "energy.gravity", *ENERGIES)
        count += 1
        largest = max(largest, sum(others) + abs(now - gravity))
        if memory is None and taken > 0.1 * steps:
            memory = resident()
    growth = resident() - memory
    errors, fifth = errors[:count], max(1, count // 5)
    ripple = np.abs(errors).max() / largest
    drift = abs(errors[-fifth:].mean() - errors[-2 * fifth:-fifth].mean()) / largest
    print(f"{taken:.3g} steps, {count * INTERVAL:.3g} s of cloth in {time.time() - started:.0f} s: ripple {ripple:.2e}, "
          f"drift {drift:.2e} of the largest energy; memory grew by {growth / 1e6:.2f} MB")
    faults = [f"{name} {value:.3g}; allowed: at most {allowed:g}"
              for name, value, allowed in [("ripple", ripple, RIPPLE), ("drift", drift, DRIFT), ("memory, bytes", growth, GROWTH)]
              if not value <= allowed]
    end = count * INTERVAL
    if cloth.step(INTERVAL, at=end + 1e-5 * INTERVAL) == OK:
        faults.append("the clock takes a time that is off by 1e-5 of an interval")
    if cloth.step(INTERVAL, at=end) != OK:
        faults.append(f"the clock refuses its own time: {cloth.log[-1]}")
    cloth.slave.freeInstance()
    return faults


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--steps", type=float, default=2e7)
    arguments.add_argument("--cells", type=int, default=8, help="along each side of the square")
    options = arguments.parse_args()
    faults = soak(options.cells, options.steps)
    for fault in faults:
        print(fault)
    print("FAILED" if faults else "all is well")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
