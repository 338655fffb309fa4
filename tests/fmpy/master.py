"""A small co-simulation master on FMPy: one instance, one call at a time, with the status of every call and the log."""
from pathlib import Path

import numpy as np
from fmpy import extract, instantiate_fmu, read_model_description
from fmpy.fmi1 import FMICallException
from scenes import scalars

OK, WARNING, DISCARD, ERROR = range(4)


class Fmu:
    """An FMU unpacked once for all its instances."""

    def __init__(self, file):
        self.file = Path(file)
        self.folder = Path(extract(str(file), unzipdir=str(self.file.with_suffix(""))))
        self.description = read_model_description(str(self.folder))
        self.variables = {v.name: v for v in self.description.modelVariables}

    @property
    def library(self):
        return self.folder / "binaries" / "linux64" / f"{self.description.coSimulation.modelIdentifier}.so"

    def outputs(self):
        return [v.name for v in self.description.modelVariables if v.causality == "output"]


class Instance:
    """One instance. Statuses are returned, never raised; `log` holds (status, category, message)."""

    def __init__(self, fmu, guid=None, log=None):
        self.fmu = fmu
        self.time = 0.0
        self.log = [] if log is None else log
        description = fmu.description
        if guid is not None:
            description = read_model_description(str(fmu.folder))
            description.guid = guid
        self.slave = instantiate_fmu(
            str(fmu.folder), description, "CoSimulation", debug_logging=True, logger=self._keep
        )

    def _keep(self, environment, instance, status, category, message):
        self.log.append((status, category.decode(), message.decode()))

    def __enter__(self):
        return self

    def __exit__(self, *exception):
        self.slave.freeInstance()

    def status(self, call, *arguments, **named):
        try:
            call(*arguments, **named)
        except FMICallException as failure:
            return failure.status
        return OK

    def initialize(self, stop_time=None, **start):
        """From instantiated to the first doStep; `start` values are set in initialization mode."""
        self.slave.setupExperiment(startTime=0.0, stopTime=stop_time)
        self.slave.enterInitializationMode()
        for name, value in start.items():
            assert self.set(name, value) == OK, self.log
        self.slave.exitInitializationMode()
        return self

    def set(self, name, value):
        return self.status(self.slave.setReal, [self.fmu.variables[name].valueReference], [value])

    def drive(self, inputs):
        """Sets vectors of inputs: {"wind": [x, y, z]}."""
        values = scalars(inputs)
        references = [self.fmu.variables[name].valueReference for name in values]
        assert self.status(self.slave.setReal, references, list(values.values())) == OK, self.log

    def get(self, *names):
        return np.array(self.slave.getReal([self.fmu.variables[name].valueReference for name in names]))

    def nodes(self, kind="position"):
        """[particles x 3] from node.position or node.velocity."""
        names = [name for name in self.fmu.variables if name.startswith(f"node.{kind}[")]
        return self.get(*names).reshape(-1, 3)

    def step(self, length, at=None):
        status = self.status(self.slave.doStep, self.time if at is None else at, length)
        if status == OK:
            self.time += length
        return status

    def run(self, until, length):
        """Equal steps up to a time; their ends are computed, not added up."""
        start = self.time
        count = round((until - start) / length)
        for k in range(count):
            self.time = start + k * length
            assert self.step(length) == OK, self.log
        self.time = until
        return self


def same_bits(a, b):
    """True if two arrays are equal to the last bit."""
    return np.array_equal(np.asarray(a, float).view(np.uint64), np.asarray(b, float).view(np.uint64))
