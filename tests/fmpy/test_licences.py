"""documentation/licenses/components.csv lists all that an FMU packs: every library, and every header that its code comes from."""
import csv
import io
import re
import shutil
import subprocess
import zipfile
from pathlib import Path

import conftest
import pytest
from bodies import sheet_over_ball
from scenes import ROOT, swinging_sheet

BUILD = ROOT / "build"
C_LIBRARY = {"libc6-dev", "linux-libc-dev"}  # declares; what it runs is the machine's own
debian = pytest.mark.skipif(not shutil.which("dpkg-query") or conftest.BUILD == "release",
                            reason="the packages of Debian tell which file is whose, of the development build alone")


def components(file):
    archive = zipfile.ZipFile(file)
    text = archive.read("documentation/licenses/components.csv").decode()
    rows = list(csv.DictReader(io.StringIO(text)))
    for row in rows:
        assert row["version"] and row["licence"], row
        for text in row["text"].split():
            assert f"documentation/licenses/{text}" in archive.namelist(), row
    return archive, rows


def packages_of(files):
    """Package -> version, of all files that belong to one."""
    names = set()
    for file in files:
        names |= {str(file), str(file).removeprefix("/usr")}  # /lib is a link to /usr/lib
    found = subprocess.run(["dpkg-query", "-S", *sorted(names)], capture_output=True, text=True).stdout
    packages = {line.split(":")[0] for line in found.splitlines()} - C_LIBRARY
    packages = {re.sub(r"^libgcc-(\d+)-dev$", r"libstdc++-\1-dev", p) for p in packages}
    return {package: version(package) for package in packages}


def version(package):
    return subprocess.run(["dpkg-query", "-W", "-f=${Version}", package], capture_output=True, text=True, check=True).stdout


def headers_of(target):
    """Everything outside the repository that the objects of a target were compiled from."""
    commands = subprocess.run(["ninja", "-C", BUILD, "-t", "commands", target], capture_output=True, text=True, check=True).stdout
    outputs = set(re.findall(r" -o (\S+\.(?:o|gch)) -c ", commands))
    assert outputs
    deps = subprocess.run(["ninja", "-C", BUILD, "-t", "deps", *outputs], capture_output=True, text=True, check=True).stdout
    return {Path(line.strip()).resolve() for line in deps.splitlines() if line.startswith("    /usr/")}


def listed(rows, where):
    return {row["package of Debian"]: row["version"] for row in rows if where(row["in"]) and row["package of Debian"]}


@debian
def test_the_binary(pack):
    archive, rows = components(pack(swinging_sheet()).file)
    assert [row["component"] for row in rows if not row["package of Debian"]] == ["Drape", "headers of FMI"]
    assert packages_of(headers_of("drape_fmi2.so")) == listed(rows, lambda place: place == "the binary")
    assert not any("contact" in name or "eigen" in name for name in archive.namelist())


@debian
def test_what_lies_beside_it(drape, write, tmp_path):
    drape("pack", write(sheet_over_ball(tmp_path)), "-o", tmp_path / "a.fmu")
    archive, rows = components(tmp_path / "a.fmu")
    packed = [Path(name).name for name in archive.namelist() if name.startswith("binaries/")]
    assert set(packed) == {"sheet.so", "libdrape_contact.so"}
    listing = subprocess.run(["ldd", BUILD / "libdrape_contact.so"], capture_output=True, text=True, check=True).stdout
    assert set(re.findall(r"(\S+) => \S+ \(", listing)) == {"libc.so.6", "libm.so.6"}
    assert packages_of(headers_of("libdrape_contact.so")) == listed(rows, lambda place: place == "libdrape_contact.so")
