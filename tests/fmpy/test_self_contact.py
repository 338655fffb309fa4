"""Cloth against cloth through FMI: a sheet falls onto a held one and stays there; the same bits; scenes that are refused."""
import subprocess

import pytest
from master import Instance, same_bits
from scenes import HORIZONTAL, ROOT, WOOL, sheet, toml

DRAPE = ROOT / "build" / "drape"


def stack(height=1e-3, **scene_keys):
    """A held square of wool, and a smaller one above it, off the threads of the first."""
    scene = sheet(0.08, 0.08, 0.01, HORIZONTAL, self_contact=True, damping=10.0, **scene_keys)
    scene["pin"].append(
        {"name": "hold", "piece": "sheet", "region": [[-0.01, -0.01], [0.09, -0.01], [0.09, 0.09], [-0.01, 0.09]]}
    )
    scene["piece"].append(
        {
            "name": "upper",
            "fabric": "wool",
            "cell": 0.01,
            "outline": [[0, 0], [0.04, 0], [0.04, 0.04], [0, 0.04]],
            "place": HORIZONTAL | {"origin": [0.0213, 0.0177, 1.0 + height]},
        }
    )
    scene["probe"].append({"name": "middle", "piece": "upper", "at": [0.02, 0.02]})
    return scene


def thickness():
    line = next(row for row in WOOL.read_text().splitlines() if row.startswith("thickness"))
    return float(line.split("=")[1].split("#")[0])


def test_rests_on_the_sheet_below(pack):
    """It does not fall through: its middle stays the thickness above the sheet's, less the depth that its weight causes."""
    with Instance(pack(stack())) as cloth:
        cloth.initialize().run(0.3, 0.001)
        height = cloth.get("probe.middle.position[3]")[0] - 1
        count, deepest, pressure = cloth.get("contact.count", "contact.penetration.max", "contact.pressure.max")
    assert 0.8 * thickness() < height < thickness()
    assert count >= 25
    assert 0 < deepest < 0.2 * thickness()
    assert pressure > 0


def test_grouping_of_steps_and_states(pack):
    """60 intervals in 1 or 60 calls; and a state restored while the sheets touch."""
    fmu = pack(stack(), nodes="all")
    ends = []
    for calls in (1, 60):
        with Instance(fmu) as cloth:
            cloth.initialize().run(0.06, 0.06 / calls)
            ends.append(cloth.nodes())
            assert cloth.get("contact.count")[0] > 0
            kept = cloth.slave.getFMUState()
            later = cloth.run(0.1, 0.001).nodes()
            cloth.slave.setFMUState(kept)
            cloth.time = 0.06
            assert same_bits(cloth.run(0.1, 0.001).nodes(), later)
    assert same_bits(*ends)


def test_no_such_outputs_without_it(pack):
    scene = stack()
    scene["scene"]["self_contact"] = False
    assert not any(name.startswith("contact.") for name in pack(scene).outputs())


@pytest.mark.parametrize(
    "change, command, code, says",
    [
        ({"order": 4}, ["check"], 1, "scene.order = 4 does not go with self_contact"),
        ({}, ["reference", "-o", "out"], 2, "scene.self_contact = true; the reference takes"),
    ],
)
def test_what_refuses_it(tmp_path, change, command, code, says):
    scene = stack()
    scene["scene"] |= change
    (tmp_path / "scene.toml").write_text(toml(scene))
    run = subprocess.run(
        [DRAPE, command[0], "scene.toml", *command[1:]], cwd=tmp_path, capture_output=True, text=True
    )
    assert run.returncode == code, run.stderr
    assert says in run.stderr
