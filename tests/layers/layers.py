"""Holds the rooms to their order: no include runs up, no type is defined twice, no file is too long. The order is data:
rooms.toml.

    python3 tests/layers/layers.py                what is wrong, a line each; exit code 1 if anything is
    python3 tests/layers/layers.py --self-test    plants faults in memory and checks that each is found
"""
import posixpath
import re
import sys
import tomllib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tracked import C_FILES, ROOT, tracked  # noqa: E402

HERE = Path(__file__).resolve().parent
HOUSE = ("core/", "fmu/", "modelDescription/", "tests/")
NAMESPACE = re.compile(r"^(?:inline )?namespace(?: ([\w:]+))? \{$|^\}  // namespace\b|^(?:struct|class|union|enum class|enum)"
                       r" (?:alignas\([^)]*\) )?(\w+)\b(?!<)[^;{]*\{", re.M)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"([^"\n]+)"|<([^>\n]+)>)', re.M)


def within(file, place):
    """Whether a file is this file or lies in this folder."""
    return file == place or file.startswith(place + "/")


def any_within(file, places):
    return any(within(file, place) for place in places)


def room_of(file, order):
    return max((room for room in order if within(file, room)), key=len, default=None)


def resolve(name, quoted, file, files, roots):
    """The project file that an include means, or None."""
    folders = ([str(Path(file).parent)] if quoted else []) + roots
    if file.startswith("tests/"):  # tests see their own rooms first
        folders = sorted(folders, key=lambda folder: folder in roots and not folder.startswith("tests"))
    for folder in folders:
        path = posixpath.normpath(f"{folder}/{name}")
        if path in files:
            return path
    return None


def order_fault(file, target, order):
    below, above = room_of(file, order), room_of(target, order)
    if above is None:
        return f"{Path(target).parent} is no room: add it to rooms.toml"
    if order.index(below) < order.index(above):
        return f"room {below} is below room {above}"
    return None


def rule_fault(file, target, rule):
    if "target" in rule:
        broken = within(target, rule["target"]) and not any_within(file, [rule["target"], *rule["from"]])
    elif not any_within(file, rule["of"]) or any_within(target, rule["of"]):
        broken = False
    elif "never" in rule:
        broken = any_within(target, rule["never"])
    else:
        broken = within(target, rule["within"]) and not any_within(target, rule["only"])
    return rule["reason"] if broken else None


def include_faults(texts, rooms):
    """texts: source text by file. One line for every include that is not allowed."""
    order, faults = rooms["order"], []
    for file in texts:
        if file in rooms["foreign"]:
            continue
        if room_of(file, order) is None:
            faults.append(f"{file}:1 {Path(file).parent} is no room: add it to rooms.toml")
            continue
        for match in INCLUDE.finditer(texts[file]):
            name, quoted = match[1] or match[2], match[1] is not None
            target = resolve(name, quoted, file, texts, rooms["roots"])
            if target is None:
                fault = "there is no such file" if quoted and name not in rooms["external"] else None
                reasons = [fault]
            else:
                reasons = [order_fault(file, target, order)] + [rule_fault(file, target, rule) for rule in rooms["rule"]]
            line = texts[file].count("\n", 0, match.start()) + 1
            faults += [f"{file}:{line} includes {target or name}: {reason}" for reason in reasons if reason]
    return faults


def types_of(text):
    """The types that a formatted source defines for all others to see: (name with its namespaces, line).

    A specialisation of a template, `struct Table<State>`, gives no name to a new type."""
    spaces = []
    for match in NAMESPACE.finditer(text):
        if match[0].startswith("}"):
            spaces.pop()
        elif match[2] is None:
            spaces.append(match[1])
        elif None not in spaces:  # within an unnamed namespace a type is its file's own
            yield "::".join([*spaces, match[2]]), text.count("\n", 0, match.start()) + 1


def twin_faults(texts):
    """One line for every type whose name another file has given to another type: linked together, one of the two is lost."""
    first, faults = {}, []
    for file in texts:
        for name, line in types_of(texts[file]):
            if first.setdefault(name, file) != file:
                faults.append(f"{file}:{line} defines {name}, as does {first[name]}")
    return faults


def length_faults(lines, most):
    """lines: their number by file."""
    return [f"{file}:{count} has {count} lines: {most} are allowed" for file, count in lines.items() if count > most]


def text_of(file):
    return (ROOT / file).read_text(encoding="utf-8")


def self_test(rooms):
    """Every kind of fault, planted in a project of a few files; and what is allowed, found without fault."""
    house = {
        "core/include/drape/drape.h": "", "core/math/vector3.h": "", "core/scene/scene.h": '#include "math/vector3.h"\n',
        "core/forces/air.h": '#include "scene/scene.h"\n', "core/dynamics/kernel/kernel.h": '#include "forces/air.h"\n',
        "core/dynamics/step.cpp": '#include "dynamics/kernel/kernel.h"\n#include <vector>\n', "core/piece/grid/grid.h": "",
        "fmu/instance/instance.h": '#include "drape/drape.h"\n#include "fmi2Functions.h"\n', "tests/core/fixture.h": "",
        "tests/core/step_test.cpp": '#include "fixture.h"\n#include "dynamics/kernel/kernel.h"\n',
    }
    planted = {  # file, include, expected report
        "up": ("core/math/vector3.h", '"scene/scene.h"', "room core/math is below room core/scene"),
        "up by a path": ("core/math/vector3.h", '"../scene/scene.h"', "room core/math is below room core/scene"),
        "up in angle brackets": ("core/math/vector3.h", "<scene/scene.h>", "room core/math is below room core/scene"),
        "up into tests": ("core/dynamics/step.cpp", '"fixture.h"', "room core/dynamics is below room tests"),
        "nowhere": ("core/scene/scene.h", '"scene/gone.h"', "there is no such file"),
        "forces in the reference": ("core/reference/law.h", '"forces/air.h"', "the reference solver is independent"),
        "the core's rooms in an FMU": ("fmu/instance/instance.h", '"piece/grid/grid.h"', "by its C interface"),
        "kernels from outside": ("core/outputs/fields.cpp", '"dynamics/kernel/kernel.h"', "through core/dynamics"),
        "no room": ("core/utils/text.h", '"math/vector3.h"', "core/utils is no room"),
    }
    failed = include_faults(house, rooms)
    for kind, (file, name, said) in planted.items():
        faults = include_faults(house | {file: house.get(file, "") + f"#include {name}\n"}, rooms)
        line = house.get(file, "").count("\n") + 1
        if len(faults) != 1 or not faults[0].startswith(f"{file}:{line} ") or said not in faults[0]:
            failed.append(f"not found as planted: {kind}: {faults}")
        else:
            print(f"planted, {kind}: {faults[0]}")
    range_of = "namespace drape%s {\n%sstruct Range {\n  int low;\n};\n%s}  // namespace drape\n"
    twin = {"core/scene/limits.h": range_of % ("", "", ""), "core/api/limits.cpp": "\n" + range_of % ("", "", "")}
    apart = {"core/scene/limits.h": range_of % ("", "", ""), "core/scene/units.h": range_of % ("::scene", "", ""),
             "core/api/limits.cpp": range_of % ("", "namespace {\n", "}  // namespace\n")}
    if twin_faults(twin) != ["core/api/limits.cpp:3 defines drape::Range, as does core/scene/limits.h"]:
        failed.append("not found as planted: two types of one name")
    failed += twin_faults(apart)
    table = "namespace drape {\ntemplate <>\nstruct Table<%s> {\n  int x;\n};\n}  // namespace drape\n"
    failed += twin_faults({"core/state/fields.h": table % "State", "core/api/snapshot.h": table % "Ramp"})
    if length_faults({"core/math/long.h": 401, "core/math/short.h": 400}, 400) != [
            "core/math/long.h:401 has 401 lines: 400 are allowed"]:
        failed.append("not found as planted: a long file")
    return failed


def main():
    rooms = tomllib.loads((HERE / "rooms.toml").read_text(encoding="utf-8"))
    if sys.argv[1:] == ["--self-test"]:
        faults = self_test(rooms)
    elif len(sys.argv) > 1:
        sys.exit(__doc__)
    else:
        texts = {file: text_of(file) for file in tracked(*C_FILES) if file.startswith(HOUSE)}
        lines = {file: text_of(file).count("\n") for file in tracked(*C_FILES, ".py", ".sh")}
        faults = include_faults(texts, rooms) + twin_faults(texts) + length_faults(lines, rooms["most_lines"])
        print(f"{len(texts)} files in {len(rooms['order'])} rooms: {len(faults) or 'no'} faults")
    print(*faults, sep="\n", end="\n" if faults else "")
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
