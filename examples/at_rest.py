"""A cloth in fit mode under FMPy: opened from its FMU, moved by its inputs, waited for until it is at rest, read."""
import shutil
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import fmpy
from fmpy.fmi2 import FMU2Slave

ROOT = Path(__file__).resolve().parents[1]
STEP, STEPS_MOST, RESIDUAL = 0.1, 200, 1e-5  # s; the residual of the fit at rest


def pack(scene, fmu):
    """Packs a scene as an FMU."""
    drape = ROOT / "build" / "drape"
    if not drape.exists():
        sys.exit(f"{drape} is missing: run `bash examples/quickstart.sh`")
    subprocess.run([drape, "pack", scene, "-o", fmu], check=True)


class Cloth:
    def __init__(self, description, unit):
        self.reference = {v.name: v.valueReference for v in description.modelVariables}
        self.outputs = [v.name for v in description.modelVariables if v.causality == "output"]
        self.unit, self.time = unit, 0.0

    def set(self, values):
        """Inputs by name; the next step leads there."""
        self.unit.setReal([self.reference[name] for name in values], list(values.values()))

    def get(self, names):
        return self.unit.getReal([self.reference[name] for name in names])

    def rest(self):
        """Steps until the cloth is at rest; False where it finds none. The first step moves the pins."""
        for step in range(STEPS_MOST):
            self.unit.doStep(self.time, STEP)
            self.time += STEP
            if step > 0 and self.get(["fit.residual"])[0] <= RESIDUAL:
                return True
        return False


@contextmanager
def opened(fmu):
    description = fmpy.read_model_description(fmu)
    folder = fmpy.extract(fmu)
    unit = FMU2Slave(guid=description.guid, unzipDirectory=folder, modelIdentifier=description.coSimulation.modelIdentifier)
    unit.instantiate()
    unit.setupExperiment(startTime=0.0)
    unit.enterInitializationMode()
    unit.exitInitializationMode()
    try:
        yield Cloth(description, unit)
        unit.terminate()
    finally:
        unit.freeInstance()
        shutil.rmtree(folder)
