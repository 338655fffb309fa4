"""What a host has set in its process changes no bit of an FMU: locale, rounding mode, flushing to zero."""
import os
import shutil
import subprocess
import sys

import pytest
from bodies import sheet_over_ball

MASTER = """
import ctypes, locale, sys
sys.path.insert(0, sys.argv[1])
from master import Fmu, Instance
kind, fmu = sys.argv[2], Fmu(sys.argv[3])
cloth = Instance(fmu)
if kind == "comma":
    locale.setlocale(locale.LC_ALL, "de_DE.UTF-8")
    assert locale.localeconv()["decimal_point"] == ","
    cloth = Instance(fmu)  # reads scene and mesh
libm = ctypes.CDLL("libm.so.6")
upward = 0x800
if kind == "upward":
    assert libm.fesetround(upward) == 0
cloth.initialize().run(0.02, 0.005)
if kind == "upward":
    assert libm.fegetround() == upward
    libm.fesetround(0)
print([value.hex() for value in cloth.get(*fmu.outputs())])
"""


def outputs(tmp_path, fmu, kind, **environment):
    here = os.path.dirname(os.path.abspath(__file__))
    done = subprocess.run([sys.executable, "-c", MASTER, here, kind, fmu.file], capture_output=True, text=True, cwd=tmp_path,
                          env=os.environ | environment)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture
def plain(pack, tmp_path):
    fmu = pack(sheet_over_ball(tmp_path))
    return fmu, outputs(tmp_path, fmu, "plain")


def test_rounding_mode(plain, tmp_path):
    fmu, expected = plain
    assert outputs(tmp_path, fmu, "upward") == expected


@pytest.mark.skipif(not shutil.which("localedef") or not os.path.exists("/usr/share/i18n/locales/de_DE"),
                    reason="no locale with a decimal comma can be made: the package `locales` is missing")
def test_decimal_comma(plain, tmp_path):
    fmu, expected = plain
    subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", tmp_path / "de_DE.UTF-8"], capture_output=True)
    assert outputs(tmp_path, fmu, "comma", LOCPATH=str(tmp_path)) == expected
