"""FMUs whose parts are missing, cut off or foreign: one sentence in the log, no instance, no crash."""
import shutil
import subprocess
import sys

import pytest
from bodies import sheet_over_ball
from conftest import BINARIES

# In a process of its own, which a crash would end.
INSTANTIATE = """
import sys
from pathlib import Path
from fmpy import instantiate_fmu, read_model_description
def log(environment, instance, status, category, message):
    print(message.decode())
try:
    instantiate_fmu(sys.argv[1], read_model_description(sys.argv[1]), "CoSimulation", logger=log)
except Exception as failure:
    sys.exit("no instance" if "instantiate" in str(failure) else str(failure))
"""


@pytest.fixture
def fmu(pack, tmp_path):
    return pack(sheet_over_ball(tmp_path))


def refused(fmu):
    """The sentences in the log of an FMU that gives no instance."""
    done = subprocess.run([sys.executable, "-c", INSTANTIATE, fmu.folder], capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stderr) == (1, "no instance\n"), done
    return done.stdout.splitlines()


def test_whole(fmu):
    done = subprocess.run([sys.executable, "-c", INSTANTIATE, fmu.folder], capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@pytest.mark.parametrize("share", [0, 0.001, 0.2, 0.5, 0.9])
def test_a_library_that_is_cut_off(fmu, share):
    library = fmu.library.with_name("libdrape_contact.so")
    bytes_ = library.read_bytes()
    library.write_bytes(bytes_[: int(share * len(bytes_))])
    (sentence,) = refused(fmu)
    assert "body.ball needs the contact library: " in sentence and "libdrape_contact.so" in sentence
    assert share < 0.1 or "the file is cut off" in sentence


def test_a_library_that_is_missing(fmu):
    fmu.library.with_name("libdrape_contact.so").unlink()
    (sentence,) = refused(fmu)
    assert "body.ball needs the contact library: " in sentence and "No such file" in sentence


def test_a_library_of_another_kind(fmu):
    shutil.copy(BINARIES / "drape_fmi2.so", fmu.library.with_name("libdrape_contact.so"))
    (sentence,) = refused(fmu)
    assert "is of another version" in sentence
    fmu.library.with_name("libdrape_contact.so").write_text("no library")
    (sentence,) = refused(fmu)
    assert "libdrape_contact.so" in sentence


@pytest.mark.parametrize("name", ["scene.toml", "body_ball.obj"])
@pytest.mark.parametrize("harm", ["missing", "cut off"])
def test_a_resource_that_is_damaged(fmu, name, harm):
    file = fmu.folder / "resources" / name
    text = file.read_text()
    file.unlink()
    if harm == "cut off":
        file.write_text(text[: len(text) // 2])
    sentences = refused(fmu)
    assert sentences and any(name in sentence or "body.ball.mesh" in sentence for sentence in sentences), sentences
