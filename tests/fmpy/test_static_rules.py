"""Static rules of FMI 2.0.4 that FMPy's validation does not look at, in every kind of scene. Sections are of the standard."""
import re
from xml.etree import ElementTree

import zipfile
import pytest
from test_description import SCENES

FIELDS = {"Real": float, "Integer": int, "Enumeration": int, "Boolean": str}


@pytest.fixture(params=SCENES)
def xml(request, pack, tmp_path):
    fmu = pack(SCENES[request.param](tmp_path), name=request.param)
    return ElementTree.fromstring(zipfile.ZipFile(fmu.file).read("modelDescription.xml"))


def test_values_lie_in_their_ranges(xml):
    """2.2.7: min <= start <= max, nominal > 0; 2.2.3: the same of types."""
    for typed in [v[0] for v in xml.find("ModelVariables")] + [t[0] for t in xml.iter("SimpleType")]:
        if typed.tag == "Boolean":
            assert typed.get("start") in (None, "true", "false")
            continue
        low, start, high = (typed.get(name) for name in ("min", "start", "max"))
        values = [FIELDS[typed.tag](value) for value in (low, start, high) if value is not None]
        assert values == sorted(values), ElementTree.tostring(typed)
        assert float(typed.get("nominal", 1)) > 0


def test_references_and_types(xml):
    """2.2.7: variables of one type share no reference, unless they are aliases with one start value; every type is declared."""
    seen, declared = set(), {t.get("name"): t[0].tag for t in xml.iter("SimpleType")}
    for variable in xml.find("ModelVariables"):
        key = (variable[0].tag, variable.get("valueReference"))
        assert key not in seen, variable.get("name")
        seen.add(key)
        if (name := variable[0].get("declaredType")) is not None:
            assert declared[name] == variable[0].tag
    for enumeration in xml.iter("Enumeration"):
        items = [(item.get("name"), item.get("value")) for item in enumeration.findall("Item")]
        assert len({name for name, _ in items}) == len({value for _, value in items}) == len(items)


def test_structure(xml):
    """2.2.8: indices in ascending order, within the variables, dependencies too; InitialUnknowns are what is calculated at the start."""
    variables = list(xml.find("ModelVariables"))
    structure = xml.find("ModelStructure")
    for part in structure:
        indices = [int(unknown.get("index")) for unknown in part]
        assert indices == sorted(set(indices))
        for unknown in part:
            on = [int(word) for word in unknown.get("dependencies", "").split()]
            assert on == sorted(set(on)) and all(1 <= k <= len(variables) for k in on)
            kinds = unknown.get("dependenciesKind")
            assert kinds is None or len(kinds.split()) == len(on)
    calculated = [k for k, v in enumerate(variables, 1) if v.get("causality") == "output" and v.get("initial", "calculated") != "exact"]
    assert [int(u.get("index")) for u in structure.find("InitialUnknowns")] == calculated


def test_names_and_units(xml):
    """2.2.1: the identifier is one of C; 2.2.2: display units scale; 2.2.4, 2.2.5: categories and the experiment."""
    assert re.fullmatch(r"[A-Za-z_]\w*", xml.find("CoSimulation").get("modelIdentifier"))
    assert xml.get("variableNamingConvention") == "structured" and xml.get("guid")
    for unit in xml.iter("Unit"):
        shown = [d.get("name") for d in unit.iter("DisplayUnit")]
        assert len(set(shown)) == len(shown) and all(float(d.get("factor", 1)) != 0 for d in unit.iter("DisplayUnit"))
    units = [u.get("name") for u in xml.iter("Unit")]
    categories = [c.get("name") for c in xml.iter("Category")]
    assert len(set(units)) == len(units) and len(set(categories)) == len(categories)
    experiment = xml.find("DefaultExperiment")
    assert 0 <= float(experiment.get("startTime", 0)) < float(experiment.get("stopTime")) and float(experiment.get("stepSize")) > 0
