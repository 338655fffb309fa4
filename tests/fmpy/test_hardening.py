"""The headers of what is built: a program whose memory is overwritten is stopped, and cannot run its data."""
import json
import re
import shlex
import subprocess

import pytest
from conftest import BINARIES
from scenes import ROOT, swinging_sheet

BUILD = ROOT / "build"
PROGRAMS = ["drape", "drape_bench"]
LIBRARIES = ["drape_fmi2.so", "libdrape_contact.so"]
COMPILED = ["-fstack-protector-strong", "-fstack-clash-protection", "-D_FORTIFY_SOURCE=2", "-fPI"]
UNGUARDED = "core/dynamics/kernel/kernel_"  # lanes alone; core/CMakeLists.txt says why


def readelf(file, *options):
    return subprocess.run(["readelf", "--wide", *options, file], capture_output=True, text=True, check=True).stdout


def reads_canary(file):
    """Whether functions compare the word that guards the stack: the release build brings the handler of __stack_chk_fail."""
    return "%fs:0x28" in subprocess.run(["objdump", "-d", file], capture_output=True, text=True, check=True).stdout


def missing(file, program=False):
    """What the headers of an ELF file should say and do not."""
    head, segments, dynamic, symbols = (readelf(file, option) for option in ("-h", "-l", "-d", "--dyn-syms"))
    stack = re.search(r"GNU_STACK.* ([RWE ]{3}) 0x", segments)
    found = {
        "position independent": re.search(r"Type:\s+DYN", head),
        "relro": "GNU_RELRO" in segments,
        "now": re.search(r"FLAGS.*(BIND_NOW|NOW)", dynamic),
        "data that is not run": stack and "E" not in stack[1],
        "stack protector": re.search(r"__stack_chk_fail\b", symbols) or (BINARIES != BUILD and reads_canary(file)),
        "checked copies": re.search(r"UND __\w+_chk\b", re.sub("__stack_chk_fail", "", symbols)),
    }
    if program:
        found["program to load anywhere"] = re.search(r"FLAGS_1.*PIE", dynamic)
    return [name for name, there in found.items() if not there]


@pytest.mark.parametrize("name", PROGRAMS + LIBRARIES)
def test_headers(name):
    """The contact library may copy nothing whose size the compiler knows; its flags are checked below."""
    spared = ["checked copies"] if name == "libdrape_contact.so" else []
    folder = BUILD if name in PROGRAMS else BINARIES
    assert [what for what in missing(folder / name, program=name in PROGRAMS) if what not in spared] == []


def test_packed_binary_is_the_one_that_is_checked(pack):
    assert pack(swinging_sheet()).library.read_bytes() == (BINARIES / "drape_fmi2.so").read_bytes()


def test_every_source_is_compiled_so():
    """No header tells of a stack that grows past its guard page, nor of a single source without its flags."""
    commands = json.loads((BUILD / "compile_commands.json").read_text())
    own = [c for c in commands if re.match(r"(core|fmu|modelDescription)/", str(c["file"]).removeprefix(f"{ROOT}/"))]
    own = [c for c in own if " -o tests/" not in c["command"]]  # a test compiles a source of the command once more
    assert len(own) > 100
    for command in own:
        words = shlex.split(command["command"])
        assert [flag for flag in COMPILED if not any(word.startswith(flag) for word in words)] == [], command["file"]
        assert ("-fno-stack-protector" in words) == (UNGUARDED in command["file"]), command["file"]


def test_a_plain_program_lacks_all(tmp_path):
    """That the check can fail."""
    source = tmp_path / "plain.c"
    source.write_text("int main(void) { return 0; }\n")
    program = tmp_path / "plain"
    plain = ["-fno-pie", "-no-pie", "-fno-stack-protector", "-Wl,-z,norelro", "-Wl,-z,lazy", "-Wl,-z,execstack"]
    subprocess.run(["cc", "-O1", *plain, source, "-o", program], check=True)
    assert len(missing(program, program=True)) == 7
