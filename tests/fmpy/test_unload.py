"""An FMU whose last instance is freed leaves its process: no mapping, no file, no memory."""
import re
import subprocess
from pathlib import Path

import fmpy
from bodies import sheet_over_ball
from conftest import BINARIES

ROUNDS = 200


def test_200_rounds(pack, tmp_path):
    """In the last 100 rounds the heap grows by less than a reserve of libstdc++ for one exception, 72 kB."""
    fmu = pack(sheet_over_ball(tmp_path))
    master, copies = tmp_path / "rounds_master", tmp_path / "copies"
    copies.mkdir()
    headers = Path(fmpy.__file__).parent / "c-code"
    source = Path(__file__).with_name("rounds_master.c")
    subprocess.run(["cc", "-std=gnu11", f"-I{headers}", source, "-o", master, "-ldl"], check=True)
    done = subprocess.run([master, fmu.folder, fmu.library.relative_to(fmu.folder), fmu.description.guid, copies, str(ROUNDS)],
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr  # also that nothing of the FMU is called at the end of the process
    (left_half, heap_half), (left, heap) = (map(int, line.split()) for line in done.stdout.splitlines())
    assert left_half == left == 0
    assert heap - heap_half < 50_000
    assert list(copies.iterdir()) == []


def test_nothing_holds_a_library():
    """A unique symbol keeps it loaded for ever, a destructor of a thread's variable until the thread ends."""
    for name in ("drape_fmi2.so", "libdrape_contact.so"):
        symbols = subprocess.run(["readelf", "--wide", "--dyn-syms", BINARIES / name], capture_output=True, text=True,
                                 check=True).stdout
        assert "fmi2DoStep" in symbols or "drape_contact_library" in symbols
        assert re.findall(r" UNIQUE |__cxa_thread_atexit\w*", symbols) == [], name
