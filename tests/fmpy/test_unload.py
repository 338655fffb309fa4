"""An FMU whose last instance is freed leaves its process: no mapping, no file, no memory."""
import os
import re
import subprocess
import sys

from bodies import sheet_over_ball
from scenes import ROOT

ROUNDS = 200
MASTER = """
import shutil, sys
from pathlib import Path
sys.path.insert(0, sys.argv[1])
import fmpy.fmi2
import fmpy.simulation
from master import Fmu, Instance
file, rounds = Path(sys.argv[2]), int(sys.argv[3])


def resident():
    return int(Path("/proc/self/statm").read_text().split()[1]) * 4096


after = []
for k in range(rounds):
    folder = file.parent / f"round_{k}"
    folder.mkdir()
    shutil.copy(file, folder)
    with Instance(Fmu(folder / file.name)) as cloth:
        cloth.initialize().step(1e-3)
        assert any(str(folder) in line and "drape_contact" in line for line in open("/proc/self/maps"))
    shutil.rmtree(folder)
    after.append(resident())
maps = Path("/proc/self/maps").read_text()
print(sum(str(file.parent) in line or "drape_contact" in line for line in maps.splitlines()))
print(max(after[-50:]) - max(after[50:100]))
"""


def test_200_rounds(pack, tmp_path):
    """Between rounds 100 and 200 the process grows by less than one library of 0.3 MB would in one round."""
    fmu = pack(sheet_over_ball(tmp_path))
    here = os.path.dirname(os.path.abspath(__file__))
    done = subprocess.run([sys.executable, "-c", MASTER, here, fmu.file, str(ROUNDS)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    mappings, growth = map(int, done.stdout.split())
    assert mappings == 0
    assert growth < 300_000  # bytes


def test_nothing_holds_a_library():
    """A unique symbol keeps it loaded for ever, a destructor of a thread's variable until the thread ends."""
    for name in ("drape_fmi2.so", "libdrape_contact.so"):
        symbols = subprocess.run(["readelf", "--wide", "--dyn-syms", ROOT / "build" / name], capture_output=True, text=True,
                                 check=True).stdout
        assert "fmi2DoStep" in symbols or "drape_contact_library" in symbols
        assert re.findall(r" UNIQUE |__cxa_thread_atexit\w*", symbols) == [], name
