"""Fixtures: the built `drape` command, and FMUs packed from scenes into a test's own folder."""
import os
import signal
import subprocess
from pathlib import Path

import fmpy.fmi2
import fmpy.simulation
import pytest
from convergence import measure
from master import Fmu
from scenes import ROOT, toml

# The FMUs of the tests are those of the development build. `DRAPE_BUILD=release pytest tests/fmpy` runs them on the other.
BUILD = os.environ.get("DRAPE_BUILD", "development")
BINARIES = ROOT / "build" / {"development": "", "release": "release/linux64"}[BUILD]
PACKED = {"development": ["--build", "development"], "release": ["--build", "release", "--platforms", "linux64"]}[BUILD]

# A shell starts a job in the background with Ctrl-C ignored, which its children inherit. Some tests here press it.
signal.signal(signal.SIGINT, signal.default_int_handler)


class KeptCallbacks(fmpy.fmi2.fmi2CallbackFunctions):
    """FMPy passes every FMU's messages to the logger that was set last in the process, even after it has been freed."""

    kept = []

    def __init__(self):
        super().__init__()
        self.kept.append(self)


fmpy.simulation.fmi2CallbackFunctions = KeptCallbacks


@pytest.fixture(scope="session")
def drape():
    """Runs the command: drape("pack", scene, "-o", fmu) returns the finished process."""
    command = ROOT / "build" / "drape"
    if not command.exists():
        pytest.exit(f"{command} is missing: run `bash tests/run.sh`", returncode=1)

    def run(*arguments, check=True, **named):
        chosen = "--build" in arguments or "--platforms" in arguments
        choice = PACKED if arguments and arguments[0] == "pack" and not chosen else []
        done = subprocess.run([command, *map(str, arguments), *choice], capture_output=True, text=True, **named)
        assert not check or done.returncode == 0, done.stderr
        return done

    return run


@pytest.fixture
def write(tmp_path):
    """Writes a scene and returns its file."""

    def write(scene, name="scene"):
        file = tmp_path / f"{name}.toml"
        file.write_text(scene if isinstance(scene, str) else toml(scene))
        return file

    return write


@pytest.fixture
def pack(drape, write, tmp_path):
    """Packs a scene and returns the opened FMU."""

    def pack(scene, nodes="none", name="scene"):
        file = Path(tmp_path / f"{name}.fmu")
        drape("pack", write(scene, name), "-o", file, "--nodes", nodes)
        return Fmu(file)

    return pack


@pytest.fixture(scope="session")
def undamped(tmp_path_factory):
    """Step sizes and errors of both schemes without damping; see convergence.py."""
    folder = tmp_path_factory.mktemp("undamped")
    return {name: measure(folder, integrator=name) for name in ("leapfrog", "paper")}
