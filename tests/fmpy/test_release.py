"""The release build: what it needs of a host, its size, and that it computes the bits of the development build.

Skipped where `fmu/release.sh` has not been run.
"""
import os
import re
import shutil
import subprocess
import zipfile
from pathlib import Path

import fmpy
import pytest
from bodies import sheet_over_ball
from golden import HASH, LENGTH, STEPS, golden_sheet, hash_of
from master import Fmu, Instance, same_bits
from scenes import ROOT, concave_sheet, swinging_sheet
from test_licences import components

RELEASE = ROOT / "build" / "release"
BINARIES = {"linux64": ["drape_fmi2.so", "libdrape_contact.so"], "win64": ["drape_fmi2.dll", "drape_contact.dll"]}
GLIBC = {"libc.so.6", "libm.so.6", "libpthread.so.0", "libdl.so.2", "ld-linux-x86-64.so.2"}
CHROOT = shutil.which("chroot", path="/usr/sbin:/sbin:/usr/bin")


def built(platform):
    made = [RELEASE / platform / name for name in BINARIES[platform]]
    missing = not all(file.exists() for file in made)
    own = [file for name in BINARIES["linux64"] if (file := ROOT / "build" / name).exists()]
    stale = not missing and own and min(f.stat().st_mtime for f in made) < max(f.stat().st_mtime for f in own)
    return pytest.mark.skipif(bool(missing or stale),
                              reason=f"the release build for {platform} is {'missing' if missing else 'older than this one'}: "
                                     "run `bash fmu/release.sh`")


linux64, win64 = built("linux64"), built("win64")
WINE = next((found for name in ("wine64", "wine", "/usr/lib/wine/wine64") if (found := shutil.which(name))), None)
wine = pytest.mark.skipif(not WINE, reason="wine is missing; Debian has it in the package wine64")


def objdump(option, file):
    return subprocess.run(["objdump", option, file], capture_output=True, text=True, check=True).stdout


@pytest.fixture
def packed(drape, write, tmp_path):
    """Packs a scene from a build; returns the FMU and what was printed."""

    def packed(scene, build, name="scene", **more):
        file = tmp_path / f"{name}_{build}.fmu"
        options = [word for key, value in more.items() for word in (f"--{key}", value)]
        done = drape("pack", write(scene, name), "-o", file, "--build", build, *options)
        return Fmu(file), done.stdout

    return packed


@linux64
@pytest.mark.parametrize("name", BINARIES["linux64"])
def test_needs_glibc_2_28_and_nothing_else(name):
    symbols = objdump("-T", RELEASE / "linux64" / name)
    versions = {tuple(map(int, found.split("."))) for found in re.findall(r"GLIBC_([0-9.]+)\)", symbols)}
    assert (2, 2, 5) <= max(versions) <= (2, 28)
    assert "GLIBCXX" not in symbols and "CXXABI" not in symbols
    assert set(re.findall(r"NEEDED +(\S+)", objdump("-p", RELEASE / "linux64" / name))) <= GLIBC


@linux64
def test_shows_the_functions_of_the_standard_and_no_more():
    for name, prefix in zip(BINARIES["linux64"], ("fmi2", "drape_contact_library_")):
        defined = [line.split() for line in objdump("-T", RELEASE / "linux64" / name).splitlines() if "*UND*" not in line]
        names = [words[-1] for words in defined if len(words) > 5]
        assert names and all(n.startswith(prefix) for n in names), names


@pytest.mark.parametrize("platform", [pytest.param("linux64", marks=linux64), pytest.param("win64", marks=win64)])
def test_sizes(packed, tmp_path, platform):
    """Of an FMU for one platform, in bytes."""
    without, _ = packed(swinging_sheet(), "release", name="without", platforms=platform)
    with_body, _ = packed(sheet_over_ball(tmp_path), "release", name="with", platforms=platform)
    assert without.file.stat().st_size <= 1.5e6
    assert with_body.file.stat().st_size <= 3e6


@linux64
def test_pack_prints_what_the_host_must_have(packed, tmp_path):
    scene = sheet_over_ball(tmp_path)
    fmu, printed = packed(scene, "release", platforms="linux64")
    size, glibc = re.fullmatch(r"linux64: ([0-9.]+) MB, needs glibc (2\.\d+)\n", printed).groups()
    assert float(size) == pytest.approx(sum((RELEASE / "linux64" / n).stat().st_size for n in BINARIES["linux64"]) / 1e6, abs=0.06)
    assert 14 <= int(glibc.split(".")[1]) <= 28
    names = {n for n in zipfile.ZipFile(fmu.file).namelist() if n.startswith("binaries/")}
    assert names == {"binaries/linux64/sheet.so", "binaries/linux64/libdrape_contact.so"}
    assert fmu.library.read_bytes() == (RELEASE / "linux64" / "drape_fmi2.so").read_bytes()
    archive = zipfile.ZipFile(fmu.file)
    rows = archive.read("documentation/licenses/components.csv").decode()
    assert "libc++" in rows and "libstdc++" not in rows
    assert b"LLVM Exceptions" in archive.read("documentation/licenses/llvm.txt")
    assert "libc_nonshared of glibc" in rows and "compiler-rt" not in rows
    assert b"unlimited" in archive.read("documentation/licenses/glibc.txt")


@win64
def test_the_notices_of_the_runtime_on_windows(packed, tmp_path):
    fmu, _ = packed(sheet_over_ball(tmp_path), "release", platforms="win64")
    archive, rows = components(fmu.file)
    texts = {row["component"]: row["text"].split() for row in rows}
    assert texts["compiler-rt of Zig with functions of musl"] == ["zig.txt", "musl.txt"]
    assert texts["runtime of mingw-w64 with gdtoa"] == ["mingw.txt", "gdtoa.txt"]
    for name, notice in {"musl.txt": b"Rich Felker", "gdtoa.txt": b"Lucent Technologies", "mingw.txt": b"mingw-w64 project"}.items():
        assert notice in archive.read(f"documentation/licenses/{name}")


def test_pack_names_what_is_not_built(drape, write, tmp_path):
    done = drape("pack", write(swinging_sheet()), "-o", tmp_path / "a.fmu", "--platforms", "linux64,mac", check=False)
    assert done.returncode == 1
    assert done.stderr == "error: --platforms names 'mac'; allowed: linux64, win64\n"
    assert not (tmp_path / "a.fmu").exists()


def nodes_of(fmu, steps=STEPS, length=LENGTH):
    with Instance(fmu) as cloth:
        cloth.initialize().run(steps * length, length)
        return cloth.nodes()


def has_fma():
    flags = Path("/proc/cpuinfo").read_text()
    return " avx2 " in flags and " fma " in flags


@pytest.mark.skipif(not has_fma(), reason="this processor has no AVX2 with FMA")
@pytest.mark.parametrize("build", ["development", pytest.param("release", marks=linux64)])
def test_golden_hash(packed, build):
    fmu, _ = packed(golden_sheet(), build, nodes="all")
    assert hash_of(nodes_of(fmu).ravel()) == HASH


@linux64
@pytest.mark.parametrize("name, functions", list(zip(BINARIES["linux64"], ({"sin", "cos", "tan", "exp", "memcpy"}, {"sqrt", "memcpy"}))))
def test_takes_mathematics_from_the_c_library(name, functions):
    """Not from Zig's compiler-rt, which has functions of these names too: core/math/zig_runtime.cpp."""
    lines = objdump("-T", RELEASE / "linux64" / name).splitlines()
    assert functions <= {line.split()[-1] for line in lines if "*UND*" in line}


@linux64
@pytest.mark.parametrize("name", ["swinging", "concave", "ball"])
def test_same_bits_as_the_development_build(packed, tmp_path, name):
    """Both builds call the mathematical functions of the machine."""
    scenes = {"swinging": swinging_sheet(energy=True, damping=2.0), "concave": concave_sheet(energy=True),
              "ball": sheet_over_ball(tmp_path, moves=True)}
    ends = []
    for build in ("development", "release"):
        fmu, _ = packed(scenes[name], build)
        with Instance(fmu) as cloth:
            ends.append(cloth.initialize().run(0.05, 0.005).get(*fmu.outputs()))
    assert same_bits(ends[0], ends[1])


@pytest.mark.parametrize("build", ["development", pytest.param("release", marks=linux64)])
def test_a_host_with_an_old_cxx_library(packed, tmp_path, build):
    """A host may have loaded an old libstdc++: it lacks what newer code asks for, and the FMU takes none of it."""
    (tmp_path / "old.map").write_text("GLIBCXX_3.4 { global: old; };\n")
    (tmp_path / "old.c").write_text("int old;\n")
    library, master = tmp_path / "libstdc++.so.6", tmp_path / "master"
    subprocess.run(["cc", "-shared", "-fPIC", "-nostdlib", "-Wl,-soname,libstdc++.so.6",
                    f"-Wl,--version-script={tmp_path / 'old.map'}", tmp_path / "old.c", "-o", library], check=True)
    master_build(["cc"], master, "-ldl")
    fmu, _ = packed(sheet_over_ball(tmp_path), build)
    words = [fmu.library, fmu.description.guid, (fmu.folder / "resources").as_uri()]
    words += [str(fmu.variables["step.count"].valueReference), "1", "5", "0.001"]
    for environment in ({}, {"LD_PRELOAD": str(library)}):
        done = subprocess.run([master, *words], capture_output=True, text=True, env=os.environ | environment)
        assert done.returncode == 0, done.stderr
        assert float.fromhex(done.stdout) > 0


def master_build(compiler, program, *libraries):
    """Builds bare_master.c."""
    headers = Path(fmpy.__file__).parent / "c-code"
    cache = os.environ.get("ZIG_GLOBAL_CACHE_DIR", str(RELEASE / "cache"))
    subprocess.run([*compiler, "-std=gnu11", f"-I{headers}", Path(__file__).with_name("bare_master.c"), "-o", program, *libraries],
                   check=True, env=os.environ | {"ZIG_GLOBAL_CACHE_DIR": cache})


def old_root(folder):
    """The C library of Debian 11 (glibc 2.31) in a folder of its own, from the mirror of this machine; None without one."""
    sources = Path("/etc/apt/sources.list.d/debian.sources")
    lines = sources.read_text() if sources.exists() else ""
    uri, key = (re.search(rf"^{word}: *(\S+)", lines, re.M) for word in ("URIs", "Signed-By"))
    if not uri or not key or not shutil.which("apt-get"):
        return None
    for part in ("lists/partial", "cache/archives/partial"):
        (folder / part).mkdir(parents=True)
    (folder / "sources.list").write_text(f"deb [signed-by={key[1]}] {uri[1]} bullseye main\n")
    places = {"Etc::sourcelist": folder / "sources.list", "Etc::sourceparts": "-", "State::lists": folder / "lists",
              "State::status": "/dev/null", "Cache": folder / "cache"}
    apt = ["apt-get", *(word for key, value in places.items() for word in ("-o", f"Dir::{key}={value}"))]
    for command in (["update"], ["download", "libc6"]):
        if subprocess.run([*apt, *command], capture_output=True, cwd=folder).returncode:
            return None
    root = folder / "root"
    subprocess.run(["dpkg-deb", "-x", next(folder.glob("libc6_*.deb")), root], check=True)
    return root


@linux64
def test_loads_where_glibc_is_2_31(packed, tmp_path):
    """In a root folder with the C library of Debian 11: a cloth on a body, by a master in C."""
    if os.geteuid() != 0 or not CHROOT:
        pytest.skip("only root may change the root folder")
    folder = tmp_path / "debian11"
    folder.mkdir()
    root = old_root(folder)
    if root is None:
        pytest.skip("apt has no Debian 11 for this machine")
    fmu, _ = packed(sheet_over_ball(tmp_path), "release", platforms="linux64")
    with Instance(fmu) as cloth:
        expected = cloth.initialize().run(0.05, 0.005).get("body.ball.force[3]")[0]
    shutil.copytree(fmu.folder, root / "fmu")
    master_build([RELEASE / "tools" / "cc", "-target", "x86_64-linux-gnu.2.28"], root / "master", "-ldl")
    (root / "tmp").mkdir(exist_ok=True)
    words = ["/fmu" / fmu.library.relative_to(fmu.folder), fmu.description.guid, "file:///fmu/resources"]
    words += [str(fmu.variables["body.ball.force[3]"].valueReference), "1", "10", "0.005"]
    done = subprocess.run([CHROOT, root, "/master", *words], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert float.fromhex(done.stdout) == pytest.approx(expected, rel=1e-9)
    new = [*words[:1], "wrong", *words[2:]]
    assert "the guid is wrong" in subprocess.run([CHROOT, root, "/master", *new], capture_output=True, text=True).stderr


def windows_run(fmu, tmp_path, first, count, steps, length):
    """What the FMU gives to a master under wine: `count` values from the reference `first` on."""
    master = tmp_path / "master.exe"
    master_build([RELEASE / "tools" / "cc", "-target", "x86_64-windows-gnu"], master, "-lshell32")
    folder = tmp_path / "Tücher und Stoffe"
    shutil.copytree(fmu.folder, folder)
    library = next((folder / "binaries" / "win64").glob("*sheet.dll"))
    words = [f"Z:{library}".replace("/", "\\"), fmu.description.guid, "file:///Z:" + (folder / "resources").as_uri()[7:]]
    environment = os.environ | {"WINEPREFIX": str(tmp_path / "wine"), "WINEDEBUG": "-all", "LC_ALL": "C.UTF-8"}
    done = subprocess.run([WINE, master, *words, str(first), str(count), str(steps), repr(length)], capture_output=True, text=True,
                          env=environment, timeout=600)
    assert done.returncode == 0, done.stderr
    return [float.fromhex(line) for line in done.stdout.split()]


@win64
@wine
def test_windows_gives_the_golden_hash(packed, tmp_path):
    """On Windows too, from a folder whose name is not in ASCII."""
    fmu, _ = packed(golden_sheet(), "release", nodes="all", platforms="win64")
    references = [v.valueReference for n, v in fmu.variables.items() if n.startswith("node.position[")]
    assert references == list(range(references[0], references[0] + len(references)))
    values = windows_run(fmu, tmp_path, references[0], len(references), STEPS, LENGTH)
    assert hash_of(values) == HASH


@win64
@wine
def test_windows_agrees_with_linux(packed, tmp_path):
    """Its mathematical library rounds differently: a swing of 0.1 s within 1e-10 of the size, 0.1 m."""
    fmu, _ = packed(swinging_sheet(damping=2.0), "release", nodes="all", platforms="linux64,win64")
    references = [v.valueReference for n, v in fmu.variables.items() if n.startswith("node.position[")]
    values = windows_run(fmu, tmp_path, references[0], len(references), 20, 0.005)
    assert abs(nodes_of(fmu, 20, 0.005).ravel() - values).max() <= 1e-11


@win64
@wine
def test_windows_carries_a_cloth_on_a_body(packed, tmp_path):
    """The contact library loads from beside the binary: the ball takes the weight of the cloth, which stays above it."""
    fmu, _ = packed(sheet_over_ball(tmp_path, damping=50.0), "release", platforms="linux64,win64")
    names = ["body.ball.force[3]", "contact.penetration.max"]
    with Instance(fmu) as cloth:
        expected = cloth.initialize().run(0.1, 0.01).get(*names)
    found = []
    for k, name in enumerate(names):
        (tmp_path / str(k)).mkdir()
        found += windows_run(fmu, tmp_path / str(k), fmu.variables[name].valueReference, 1, 10, 0.01)
    assert found[0] == pytest.approx(expected[0], rel=1e-3)
    assert abs(found[1] - expected[1]) < 1e-5
