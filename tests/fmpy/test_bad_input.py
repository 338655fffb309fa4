"""Values and calls that a cloth must refuse: the status, one sentence with the reason, and nothing else changed."""
import math

import pytest
from master import DISCARD, ERROR, OK, Instance, same_bits
from scenes import swinging_sheet

NAN, INF = math.nan, math.inf


@pytest.fixture
def fmu(pack):
    return pack(swinging_sheet(), nodes="all")


@pytest.fixture
def cloth(fmu):
    with Instance(fmu) as cloth:
        yield cloth


def refused(cloth, *words):
    """The only sentence in the log since the last call; it contains all `words`."""
    sentences = [message for status, _, message in cloth.log if status >= DISCARD]
    cloth.log.clear()
    assert len(sentences) == 1, sentences
    for word in words:
        assert word in sentences[0], (word, sentences[0])
    return sentences[0]


BAD_VALUES = [
    ("fabric.wool.areal_density", -0.15, ["fabric.wool.areal_density", "-0.15", "allowed", "kg/m2"]),
    ("fabric.wool.areal_density", 0.0, ["fabric.wool.areal_density", "allowed", "100 kg/m2"]),
    ("fabric.wool.areal_density", NAN, ["fabric.wool.areal_density", "nan"]),
    ("fabric.wool.bending.warp", -1e-6, ["fabric.wool.bending.warp", "-1e-06"]),
    ("fabric.wool.warp.force[3]", -1.0, ["fabric.wool.warp.force[3]", "-1", "N"]),
    ("fabric.wool.compression", 1.5, ["fabric.wool.compression", "1.5", "0 to 1"]),
    ("damping", -1.0, ["damping", "-1", "1/s"]),
    ("damping", INF, ["damping", "inf"]),
    ("gravity[3]", NAN, ["gravity[3]", "nan"]),
    ("gravity[3]", -1e308, ["gravity[3]", "-1e+308", "m/s2"]),
]


@pytest.mark.parametrize("moment", ["before the start", "while it moves"])
@pytest.mark.parametrize("name, value, words", BAD_VALUES, ids=[f"{n}={v}" for n, v, _ in BAD_VALUES])
def test_bad_value(cloth, name, value, words, moment):
    if moment == "while it moves":
        cloth.initialize().run(0.002, 0.001)
    else:
        cloth.slave.setupExperiment(startTime=0.0)
        cloth.slave.enterInitializationMode()
    before = cloth.get(name)
    assert cloth.set(name, value) == DISCARD
    refused(cloth, *words)
    assert same_bits(before, cloth.get(name))
    if moment == "while it moves":
        assert cloth.step(0.001) == OK


def test_falling_diagram_while_it_moves(cloth, fmu):
    """Each value alone is allowed; together the forces fall. The step is refused and the diagram in force comes back, but
    the damping and the point of another diagram that were set with it stay: the motion is that of a cloth in which only
    these two were set."""
    good = {"damping": 7.0, "fabric.wool.weft.force[13]": 60.0}
    falling = {"fabric.wool.warp.force[5]": 0.0, "fabric.wool.warp.force[12]": 200.0}
    cloth.initialize().run(0.002, 0.001)
    before, nodes = cloth.get(*falling), cloth.nodes()
    for name, value in (good | falling).items():
        assert cloth.set(name, value) == OK
    assert cloth.step(0.001) == DISCARD
    refused(cloth, "fabric.wool.warp.force[5]", "N")
    assert same_bits(before, cloth.get(*falling))
    assert same_bits(list(good.values()), cloth.get(*good))
    assert same_bits(nodes, cloth.nodes())
    cloth.run(0.01, 0.001)

    with Instance(fmu) as never_refused:
        never_refused.initialize().run(0.002, 0.001)
        for name, value in good.items():
            assert never_refused.set(name, value) == OK
        assert same_bits(never_refused.run(0.01, 0.001).nodes(), cloth.nodes())
    with Instance(fmu) as untouched:
        assert not same_bits(untouched.initialize().run(0.01, 0.001).nodes(), cloth.nodes())


def test_falling_diagram_before_the_start(cloth, fmu):
    cloth.slave.setupExperiment(startTime=0.0)
    cloth.slave.enterInitializationMode()
    name = "fabric.wool.weft.force[4]"
    before = cloth.get(name)
    assert cloth.set("damping", 7.0) == OK
    assert cloth.set(name, 0.0) == OK
    assert cloth.status(cloth.slave.exitInitializationMode) == DISCARD
    refused(cloth, name, "N")
    assert same_bits(before, cloth.get(name))
    assert cloth.get("damping")[0] == 7.0
    assert cloth.status(cloth.slave.exitInitializationMode) == OK
    cloth.run(0.01, 0.001)

    with Instance(fmu) as never_refused:
        assert same_bits(never_refused.initialize(damping=7.0).run(0.01, 0.001).nodes(), cloth.nodes())


BAD_LENGTHS = [(0.0, "0"), (-0.001, "-0.001"), (NAN, "nan"), (INF, "inf")]


@pytest.mark.parametrize("length, word", BAD_LENGTHS, ids=[w for _, w in BAD_LENGTHS])
def test_bad_communication_step(cloth, length, word):
    cloth.initialize().run(0.002, 0.001)
    nodes = cloth.nodes()
    assert cloth.step(length) == DISCARD
    refused(cloth, word, "s")
    assert same_bits(nodes, cloth.nodes())
    assert cloth.step(0.001) == OK


def test_step_past_the_stop_time(cloth):
    cloth.initialize(stop_time=0.003).run(0.002, 0.001)
    nodes = cloth.nodes()
    assert cloth.step(0.002) == DISCARD
    refused(cloth, "0.004", "0.003", "stop time")
    assert same_bits(nodes, cloth.nodes())
    assert cloth.step(0.001) == OK


def test_wrong_communication_point(cloth):
    cloth.initialize().run(0.002, 0.001)
    nodes = cloth.nodes()
    assert cloth.step(0.001, at=0.005) == DISCARD
    refused(cloth, "0.005", "0.002", "s")
    assert same_bits(nodes, cloth.nodes())


def test_stiffer_than_the_fixed_step_allows(pack):
    """A scene with a fixed step: a density that needs a shorter one is refused with the reason, and the density in force
    and the damping set earlier go on acting."""
    fmu = pack(swinging_sheet(step=2e-5), nodes="all")

    def end(refuse):
        with Instance(fmu) as cloth:
            cloth.initialize().run(0.002, 0.001)
            assert cloth.set("damping", 7.0) == OK
            cloth.run(0.004, 0.001)
            if refuse:
                before = cloth.get("fabric.wool.areal_density", "damping")
                assert cloth.set("fabric.wool.areal_density", before[0] / 100) == OK
                assert cloth.step(0.001) == DISCARD
                refused(cloth, "step", "2e-05")
                assert same_bits(before, cloth.get("fabric.wool.areal_density", "damping"))
            return cloth.run(0.01, 0.001).nodes()

    assert same_bits(end(refuse=False), end(refuse=True))


def test_wrong_guid(pack):
    fmu, log = pack(swinging_sheet()), []
    with pytest.raises(Exception, match="instantiate"):
        Instance(fmu, guid="{00000000-0000-0000-0000-000000000000}", log=log)
    assert len(log) == 1
    assert "00000000-0000" in log[0][2] and fmu.description.guid in log[0][2]


def test_calls_out_of_order(cloth):
    assert cloth.step(0.001) == ERROR
    refused(cloth, "fmi2DoStep")
    assert cloth.status(cloth.slave.exitInitializationMode) == ERROR
    refused(cloth, "fmi2ExitInitializationMode")


def test_fixed_parameter_and_output_are_not_to_be_set(cloth):
    cloth.initialize()
    for name, value in (("step.max", 1e-6), ("probe.hem.position[1]", 0.0)):
        before = cloth.get(name)
        assert cloth.set(name, value) == DISCARD
        refused(cloth, name)
        assert same_bits(before, cloth.get(name))


def test_unknown_value_reference(cloth):
    cloth.initialize()
    assert cloth.status(cloth.slave.getReal, [999999]) == DISCARD
    refused(cloth, "999999")


def test_load_that_the_fixed_step_cannot_carry(pack):
    """A gravity of 1e4 m/s2 stretches the warp to where it is so stiff that the step limit falls below the given step: the
    step is refused at the last good state, with the place. Gravity set back, the cloth moves as if nothing had been, but
    for the rounding of the two half steps at a change."""
    fmu = pack(swinging_sheet(step=2e-5), nodes="all")
    with Instance(fmu) as untouched:
        expected = untouched.initialize().run(0.01, 0.001).nodes()
    with Instance(fmu) as cloth:
        cloth.initialize().run(0.002, 0.001)
        nodes = cloth.nodes()
        assert cloth.set("gravity[3]", -1e4) == OK
        assert cloth.step(0.001) == DISCARD
        refused(cloth, "step", "2e-05", "sheet", "warp")
        assert same_bits(nodes, cloth.nodes())
        assert cloth.set("gravity[3]", -9.81) == OK
        assert cloth.run(0.01, 0.001).nodes() == pytest.approx(expected, abs=1e-13)
