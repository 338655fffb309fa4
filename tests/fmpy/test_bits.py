"""Same inputs, same bits: however the run is cut, repeated, interleaved, or driven."""
import numpy as np
import pytest
from master import Instance, same_bits
from scenes import HORIZONTAL, pin_points, read_csv, sheet, swinging_sheet

Q = {"binary": 2.0**-10, "decimal": 0.001}  # s; the decimal one is rounded in every product k q


@pytest.mark.parametrize("step", ["auto", "fixed"])
@pytest.mark.parametrize("q", Q.values(), ids=Q)
def test_grouping_of_steps(pack, q, step):
    """100 intervals q in 1, 10 or 100 calls."""
    keys = {} if step == "auto" else {"step": q / 50}
    fmu = pack(swinging_sheet(communication=q, **keys), nodes="all")
    ends = []
    for calls in (1, 10, 100):
        with Instance(fmu) as cloth:
            cloth.initialize().run(100 * q, 100 * q / calls)
            names = [n for n in fmu.outputs() if not n.startswith("pin.")]  # a pin force is a mean over the last call
            ends.append(cloth.get(*names))
    assert ends[0].size > 700
    assert same_bits(ends[0], ends[1])
    assert same_bits(ends[0], ends[2])


@pytest.mark.parametrize("order", [4, 6])
def test_grouping_and_reset_above_order_2(pack, order):
    q = 0.001
    fmu = pack(swinging_sheet(communication=q, order=order, damping=3.0), nodes="all")
    names = [n for n in fmu.outputs() if not n.startswith("pin.")]
    ends = []
    for calls in (1, 50):
        with Instance(fmu) as cloth:
            cloth.initialize().run(50 * q, 50 * q / calls)
            ends.append(cloth.get(*names))
            cloth.slave.reset()
            cloth.time = 0.0
            cloth.initialize().run(50 * q, 25 * q)
            ends.append(cloth.get(*names))
    assert all(same_bits(ends[0], end) for end in ends)


def test_impulse_on_a_pin_does_not_depend_on_grouping(pack):
    """Mean force times length, summed over the calls, to the rounding of a sum of 100 terms."""
    fmu = pack(swinging_sheet())
    impulse = []
    for calls in (1, 100):
        with Instance(fmu) as cloth:
            cloth.initialize()
            total = 0.0
            for k in range(calls):
                cloth.run(0.1 * (k + 1) / calls, 0.1 / calls)
                total += cloth.get("pin.left.force[3]")[0] * 0.1 / calls
            impulse.append(total)
    assert impulse[0] == pytest.approx(impulse[1], rel=1e-12)


@pytest.mark.parametrize("q", Q.values(), ids=Q)
def test_run_and_fmu(drape, write, pack, tmp_path, q):
    """`drape run` writes what FMPy reads, row for row."""
    scene = swinging_sheet(energy=True, damping=2.0, communication=q)
    drape("run", write(scene), "-o", tmp_path / "run", "--until", 30 * q, "--every", 2 * q, "--nodes", "all")
    names, rows = read_csv(tmp_path / "run" / "outputs.csv")
    fmu = pack(scene, nodes="all")
    assert names == ["time", *fmu.outputs()]
    assert rows.shape[0] == 16
    # A pin force is divided by the length of the call, which two masters round differently if 2 q is no binary number.
    exact = [name for name in names if q == Q["binary"] or not name.startswith("pin.")][1:]
    with Instance(fmu) as cloth:
        cloth.initialize()
        for k, row in enumerate(rows):
            if k:
                cloth.run(2 * q * k, 2 * q)
            assert row[0] == pytest.approx(2 * q * k, rel=1e-14)
            values = cloth.get(*exact)
            written = row[[names.index(name) for name in exact]]
            assert [n for n, a, b in zip(exact, written, values) if not same_bits(a, b)] == [], k


def test_outputs_alone(pack):
    """An output read alone equals the same output read with all others: what it needs is computed."""
    fmu = pack(swinging_sheet(energy=True), nodes="outline")
    names = [n for n in fmu.outputs() if not n.startswith("node")]
    names += ["node.position[1,3]", "node.velocity[1,3]", *names]  # again, after the others
    with Instance(fmu) as alone, Instance(fmu) as all_at_once:
        alone.initialize()
        all_at_once.initialize()
        for k, name in enumerate(names, 1):
            for cloth in (alone, all_at_once):
                cloth.run(k * 1e-3, 1e-3)
            assert alone.get(name)[0] == all_at_once.get(*names)[names.index(name)], name
            alone.get(names[k // 2])  # something else, too


def test_threads(pack):
    """One, two and three threads on a sheet that is large enough for three."""
    scene = sheet(0.4, 0.4, 0.005, HORIZONTAL)
    pin_points(scene, "peg", (0, 0.4))
    fmu = pack(scene, nodes="all")
    ends = []
    for threads in (1, 2, 3):
        with Instance(fmu) as cloth:
            ends.append(cloth.initialize(threads=threads).run(0.005, 0.001).nodes())
    assert ends[0].size > 3 * 6000
    assert same_bits(ends[0], ends[1])
    assert same_bits(ends[0], ends[2])


def test_two_runs(drape, write, tmp_path):
    scene = write(swinging_sheet())
    for name in ("a", "b"):
        drape("run", scene, "-o", tmp_path / name, "--until", 0.03, "--nodes", "all")
    assert (tmp_path / "a" / "outputs.csv").read_bytes() == (tmp_path / "b" / "outputs.csv").read_bytes()


def test_instances_in_one_process(pack):
    """Three cloths with different damping, stepped in turns, move as each does by itself."""
    fmu = pack(swinging_sheet(), nodes="all")
    dampings = (0.0, 5.0, 50.0)
    alone = []
    for damping in dampings:
        with Instance(fmu) as cloth:
            alone.append(cloth.initialize(damping=damping).run(0.03, 0.001).nodes())
    with Instance(fmu) as a, Instance(fmu) as b, Instance(fmu) as c:
        cloths = (a, b, c)
        for cloth, damping in zip(cloths, dampings):
            cloth.initialize(damping=damping)
        for k in range(30):
            for cloth in cloths:
                cloth.run(0.001 * (k + 1), 0.001)
        together = [cloth.nodes() for cloth in cloths]
    assert not same_bits(alone[0], alone[1])
    assert all(same_bits(x, y) for x, y in zip(alone, together))


def test_reset_starts_anew(pack):
    fmu = pack(swinging_sheet(), nodes="all")
    with Instance(fmu) as cloth:
        first = cloth.initialize(damping=5.0).run(0.01, 0.001).nodes()
        assert cloth.status(cloth.slave.terminate) == 0
        cloth.slave.reset()
        cloth.time = 0.0
        assert same_bits(first, cloth.initialize(damping=5.0).run(0.01, 0.001).nodes())
        cloth.slave.reset()
        cloth.time = 0.0
        assert cloth.initialize().get("damping")[0] == 0.0
