"""modelDescription.xml says what is: on what outputs depend, of what type variables are, who made the model and when."""
import struct
import xml.etree.ElementTree as ElementTree
import zipfile
import zlib

import numpy as np
import pytest
from bodies import sheet_over_ball
from fmpy.validation import validate_fmu
from master import Instance, same_bits
from scenes import driven_sheet, flag, swinging_sheet, two_strips

SCENES = {
    "wind": lambda folder: flag(energy=True),
    "driven": lambda folder: driven_sheet(),
    "sewn": lambda folder: two_strips(energy=True),
    "fit": lambda folder: two_strips(mode="fit"),
    "body": lambda folder: sheet_over_ball(folder, moves=True, energy=True),
}


def xml_of(fmu):
    return ElementTree.fromstring(zipfile.ZipFile(fmu.file).read("modelDescription.xml"))


def unknowns(xml, kind):
    """Index of each unknown, with the indices it depends on; None: the attribute is missing."""
    return {int(u.get("index")): None if (d := u.get("dependencies")) is None else [int(k) for k in d.split()]
            for u in xml.find(f"ModelStructure/{kind}")}


def another(variable, value):
    """A legal value that differs."""
    if variable.name.startswith("fabric") and value:
        return value * 0.99 if variable.name.endswith(".compression") else value * 1.01
    return value + (1e-7 if variable.name.endswith(".damping") else 0.01)


@pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES)
def test_dependencies_at_the_start(pack, tmp_path, scene):
    """Each parameter and input is changed in initialization mode: only those outputs change that are said to depend on it."""
    fmu = pack(scene(tmp_path))
    xml = xml_of(fmu)
    variables = fmu.description.modelVariables
    said = unknowns(xml, "InitialUnknowns")
    outputs = [k for k, v in enumerate(variables, 1) if v.causality == "output"]
    assert sorted(said) == outputs
    names = [variables[k - 1].name for k in outputs]
    with Instance(fmu) as cloth:
        cloth.slave.setupExperiment(startTime=0.0)
        cloth.slave.enterInitializationMode()
        start = cloth.slave.getFMUstate()
        before = cloth.get(*names)
        seen = set()
        for known, v in enumerate(variables, 1):
            if v.causality == "output" or v.type != "Real":
                continue
            cloth.slave.setFMUstate(start)
            assert cloth.set(v.name, another(v, cloth.get(v.name)[0])) == 0, cloth.log
            cloth.status(cloth.slave.exitInitializationMode)
            after = cloth.get(*names)
            for k, name, a, b in zip(outputs, names, before, after):
                if abs(a - b) > 1e-12 * max(abs(a), abs(b), 1e-3):
                    seen.add((name, v.name))
                    assert known in said[k], f"{name} depends on {v.name}"
    assert seen, "the test sees dependencies"


@pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES)
def test_no_output_is_fed_through(pack, tmp_path, scene):
    """Between two steps no output changes whatever input is set."""
    fmu = pack(scene(tmp_path))
    said = unknowns(xml_of(fmu), "Outputs")
    assert said and all(depends == [] for depends in said.values())
    with Instance(fmu) as cloth:
        cloth.initialize().run(0.002, 0.001)
        before = cloth.get(*fmu.outputs())
        for v in fmu.description.modelVariables:
            if v.causality == "input":
                assert cloth.set(v.name, cloth.get(v.name)[0] + 0.01) == 0
        assert same_bits(before, cloth.get(*fmu.outputs()))


def test_types(pack, tmp_path):
    fmu = pack(two_strips(), name="sewn")
    types = {name: v.type for name, v in fmu.variables.items()}
    assert types["threads"] == "Integer" and types["mode"] == "Enumeration" and types["strain.beyond_test.count"] == "Integer"
    assert types["seam.join.close"] == types["seam.join.closed"] == "Boolean" and types["step.count"] == "Real"
    closed, close = (fmu.variables[f"seam.join.{name}"].valueReference for name in ("closed", "close"))
    with Instance(fmu) as cloth:
        cloth.initialize()
        assert cloth.slave.getBoolean([close, closed]) == [False, False]
        cloth.slave.setBoolean([close], [True])
        cloth.run(0.2, 0.001)
        assert cloth.slave.getBoolean([close, closed]) == [True, True]
        assert list(cloth.get("seam.join.closed")) == [1.0]
    ball = pack(sheet_over_ball(tmp_path), name="ball")
    with Instance(ball) as cloth:
        cloth.initialize().run(0.03, 0.001)
        (count,) = cloth.slave.getInteger([ball.variables["contact.count"].valueReference])
        assert count == cloth.get("contact.count")[0] > 0


def test_units_and_interval(pack):
    xml = xml_of(pack(two_strips(communication=0.002)))
    shown = {v.get("name"): v[0].get("displayUnit") for v in xml.find("ModelVariables")}
    assert shown["strain.warp.max"] == "%" and shown["seam.join.gap.max"] == "mm"
    factors = {d.get("name"): float(d.get("factor")) for d in xml.iter("DisplayUnit")}
    assert factors["%"] == 100 and factors["mm"] == 1000
    assert float(xml.find("DefaultExperiment").get("stepSize")) == 0.002
    assert all(float(v[0].get("nominal", 1)) > 0 for v in xml.find("ModelVariables"))


def test_what_the_scene_says_of_itself(pack):
    said = {"description": "A curtain & its <rod>", "author": "Ada", "version": "3", "copyright": "(c) Ada", "license": "CC0"}
    fmu = pack(swinging_sheet(**said))
    xml = xml_of(fmu)
    assert {key: xml.get(key) for key in said} == said
    plain = xml_of(pack(swinging_sheet(), name="plain"))
    for word in ("particles", "piece sheet", "fabric wool", "pins left, right", "probe hem"):
        assert word in plain.get("description")
    assert all(plain.get(key) for key in said)


def test_dates(drape, write, tmp_path):
    """Of SOURCE_DATE_EPOCH or of now; the guid is the same, and with the same date so are all bytes."""
    scene = write(swinging_sheet())

    def packed(name, epoch):
        drape("pack", scene, "-o", tmp_path / name, env={"SOURCE_DATE_EPOCH": epoch} if epoch else {})
        return (tmp_path / name).read_bytes(), ElementTree.fromstring(zipfile.ZipFile(tmp_path / name).read("modelDescription.xml"))

    (a, first), (b, second), (c, third) = packed("a.fmu", "86400"), packed("b.fmu", "86401"), packed("c.fmu", "86400")
    assert first.get("generationDateAndTime") == "1970-01-02T00:00:00Z"
    assert first.get("guid") == second.get("guid") and a != b and a == c
    assert packed("d.fmu", None)[1].get("generationDateAndTime") > "2026"
    for epoch in ("", "soon", "-1", "1.5", "99999999999999"):
        refused = drape("pack", scene, "-o", tmp_path / "e.fmu", env={"SOURCE_DATE_EPOCH": epoch}, check=False)
        assert refused.returncode == 1 and f"SOURCE_DATE_EPOCH is '{epoch}'; allowed: " in refused.stderr
    assert not (tmp_path / "e.fmu").exists()


def image_of(fmu):
    """[height x width x 4] of model.png."""
    data = zipfile.ZipFile(fmu.file).read("model.png")
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed = 8, b""
    while at < len(data):
        (size,) = struct.unpack(">I", data[at : at + 4])
        kind, body = data[at + 4 : at + 8], data[at + 8 : at + 8 + size]
        assert struct.unpack(">I", data[at + 8 + size : at + 12 + size])[0] == zlib.crc32(kind + body)
        if kind == b"IHDR":
            width, height = struct.unpack(">II", body[:8])
        packed += body if kind == b"IDAT" else b""
        at += 12 + size
    rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, 1 + 4 * width)
    assert not rows[:, 0].any()
    return rows[:, 1:].reshape(height, width, 4)


def test_the_picture_shows_cloth_and_body(pack, tmp_path):
    sheet = image_of(pack(swinging_sheet(), name="sheet"))
    assert 0.2 < (sheet[..., 3] == 255).mean() < 0.9
    seen = sheet[sheet[..., 3] == 255].astype(int)
    assert (seen[:, 2] > seen[:, 0]).all(), "the first piece is blue"
    ball = image_of(pack(sheet_over_ball(tmp_path), name="ball"))
    grey = np.ptp(ball[ball[..., 3] == 255][:, :3].astype(int), axis=1) < 8
    assert 0.05 < grey.mean() < 0.95


def test_fmpy_finds_no_problem(pack, tmp_path):
    for name, scene in SCENES.items():
        assert validate_fmu(str(pack(scene(tmp_path), name=name).file)) == []
