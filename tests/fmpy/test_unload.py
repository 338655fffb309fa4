"""An FMU whose last instance is freed leaves its process: no mapping, no file, no memory, no key of its threads."""
import re
import subprocess
from pathlib import Path

import fmpy
import pytest
from bodies import sheet_over_ball
from conftest import BINARIES


@pytest.mark.parametrize("rounds, threads, cell", [(200, 1, 0.01), (60, 2, 0.0015)], ids=["one thread", "two threads"])
def test_rounds(pack, tmp_path, rounds, threads, cell):
    """In the second half the heap grows by less than a reserve of libstdc++ for one exception, 72 kB.

    A process has 1024 keys of thread-specific data. Two threads share a cloth of 4000 particles or more.
    """
    fmu = pack(sheet_over_ball(tmp_path, cell=cell))
    master, copies = tmp_path / "rounds_master", tmp_path / "copies"
    copies.mkdir()
    headers = Path(fmpy.__file__).parent / "c-code"
    source = Path(__file__).with_name("rounds_master.c")
    subprocess.run(["cc", "-std=gnu11", f"-I{headers}", source, "-o", master, "-ldl", "-pthread"], check=True)
    words = [fmu.folder, fmu.library.relative_to(fmu.folder), fmu.description.guid, copies, str(rounds)]
    words += [str(fmu.variables["threads"].valueReference), str(threads)]
    done = subprocess.run([master, *words], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr  # also that nothing of the FMU is called at the end of the process
    (left_half, heap_half, key_half), (left, heap, key) = (map(int, line.split()) for line in done.stdout.splitlines())
    assert left_half == left == 0
    assert heap - heap_half < 50_000
    assert key == key_half
    assert list(copies.iterdir()) == []


def test_nothing_holds_a_library():
    """A unique symbol keeps it loaded for ever, a destructor of a thread's variable until the thread ends."""
    for name in ("drape_fmi2.so", "libdrape_contact.so"):
        symbols = subprocess.run(["readelf", "--wide", "--dyn-syms", BINARIES / name], capture_output=True, text=True,
                                 check=True).stdout
        assert "fmi2DoStep" in symbols or "drape_contact_library" in symbols
        assert re.findall(r" UNIQUE |__cxa_thread_atexit\w*", symbols) == [], name
