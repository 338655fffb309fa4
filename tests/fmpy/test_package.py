"""What is inside a packed FMU, and what it needs from the machine: nothing but glibc."""
import os
import re
import shutil
import subprocess
import zipfile
from pathlib import Path

import fmpy
import pytest
from fmpy.validation import validate_fmu
from master import Fmu, Instance, same_bits
from scenes import swinging_sheet

SYSTEM = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin"}
INTO_ROOT_FOLDER = (["chroot"], ["unshare", "--map-root-user", "chroot"])  # for root, for other users
GLIBC = {"libc.so.6", "libm.so.6", "libdl.so.2", "libpthread.so.0", "ld-linux-x86-64.so.2"}


@pytest.mark.parametrize("nodes", ["none", "outline", "all"])
def test_fmpy_finds_no_problem(pack, nodes):
    assert validate_fmu(str(pack(swinging_sheet(energy=True), nodes=nodes).file)) == []


def test_contents(pack):
    fmu = pack(swinging_sheet())
    identifier = fmu.description.coSimulation.modelIdentifier
    names = {name for name in zipfile.ZipFile(fmu.file).namelist() if not name.endswith("/")}
    assert {"modelDescription.xml", f"binaries/linux64/{identifier}.so", "documentation/index.html"} <= names
    assert any(name.startswith("resources/") and name.endswith(".toml") for name in names)
    assert [name for name in names if name.startswith("binaries/")] == [f"binaries/linux64/{identifier}.so"]


def test_needs_only_glibc(pack):
    dynamic = subprocess.run(["readelf", "-d", pack(swinging_sheet()).library], capture_output=True, text=True)
    needed = set(re.findall(r"\(NEEDED\).*\[(.*)\]", dynamic.stdout))
    assert "libc.so.6" in needed
    assert needed <= GLIBC


def test_exports_only_fmi2(pack):
    symbols = subprocess.run(
        ["nm", "-D", "--defined-only", pack(swinging_sheet()).library], capture_output=True, text=True
    )
    exported = {line.split()[-1].split("@")[0] for line in symbols.stdout.splitlines()}
    assert "fmi2DoStep" in exported
    assert {name for name in exported if not name.startswith("fmi2")} == set()


def test_packs_without_a_compiler(drape, write, tmp_path):
    drape("pack", write(swinging_sheet()), "-o", tmp_path / "a.fmu", env={"PATH": str(tmp_path)})
    assert validate_fmu(str(tmp_path / "a.fmu")) == []


def test_carries_all_that_the_scene_names(drape, write, tmp_path):
    """The FMU gives the same motion after the scene and its fabric file are gone."""
    folder = tmp_path / "gone"
    folder.mkdir()
    scene = swinging_sheet()
    shutil.copy(scene["fabric"]["wool"]["file"], folder / "cloth.toml")
    scene["fabric"]["wool"]["file"] = "gone/cloth.toml"
    file = write(scene)
    drape("pack", file, "-o", tmp_path / "a.fmu")
    fmu = Fmu(tmp_path / "a.fmu")

    def end():
        with Instance(fmu) as cloth:
            return cloth.initialize().run(0.01, 0.001).get(*fmu.outputs())

    before = end()
    shutil.rmtree(folder)
    file.unlink()
    assert same_bits(before, end())
    assert str(tmp_path) not in "".join(p.read_text() for p in (fmu.folder / "resources").iterdir())


def test_runs_where_there_is_only_glibc(pack, tmp_path):
    """In a root folder that holds glibc, the FMU and a master written in C, the result is that of FMPy."""

    def allowed(into):
        return subprocess.run([*into, "/", "true"], capture_output=True, env=SYSTEM).returncode == 0

    into = next(filter(allowed, INTO_ROOT_FOLDER), None)
    if not into:
        pytest.skip("this user may not change the root folder")
    fmu = pack(swinging_sheet())
    with Instance(fmu) as cloth:
        expected = cloth.initialize().run(0.01, 0.001).get("probe.hem.position[3]")[0]

    bare = tmp_path / "bare"
    for library in ["/lib64/ld-linux-x86-64.so.2", *(f"/lib/x86_64-linux-gnu/{name}" for name in GLIBC)]:
        if os.path.exists(library):
            target = bare / library[1:]
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(library, target)
    shutil.copytree(fmu.folder, bare / "fmu")
    headers = Path(fmpy.__file__).parent / "c-code"
    source = Path(__file__).with_name("bare_master.c")
    subprocess.run(["cc", "-std=gnu11", f"-I{headers}", source, "-o", bare / "master", "-ldl"], check=True)
    done = subprocess.run(
        [*into, bare, "/master"]
        + ["/fmu" / fmu.library.relative_to(fmu.folder), fmu.description.guid, "file:///fmu/resources"]
        + [str(fmu.variables["probe.hem.position[3]"].valueReference), "1", "10", "0.001"],
        capture_output=True,
        text=True,
        env=SYSTEM,
    )
    assert done.returncode == 0, done.stderr
    assert same_bits(float.fromhex(done.stdout), expected)
    assert sorted(p.name for p in bare.iterdir()) == ["fmu", "lib", "lib64", "master"]  # nothing was written
