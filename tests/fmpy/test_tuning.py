"""Parameters tuned while the cloth moves, against exact answers."""
import numpy as np
import pytest
from master import Instance, same_bits
from scenes import HANGING, pin_edge, probe, sheet, swinging_sheet

G = 9.81


def falling_sheet(step, **keys):
    scene = sheet(0.05, 0.05, 0.01, HANGING, communication=0.001, step=step, **keys)
    probe(scene, "centre", (0.02, 0.03))
    return scene


def test_damping_in_free_fall(pack):
    """v_{n+1/2} = [v_{n-1/2} (1 - c h_o/2) - (h_o + h) g/2]/(1 + c h/2), h_o = 0 in the first step; c changes at 20 ms,
    where the velocity first comes to that time, v_n = (v_{n-1/2} - h g/2)/(1 + c h/2), from which h_o = 0 again.

    Every step rounds v by about 3 parts in 2^53, and 2,000 steps add up to less than 1e-12.
    """
    step = 0.001 / 50
    z, v, before = 0.0, 0.0, 0.0
    heights = []
    c = 3.0
    for n in range(2000):
        if n == 1000:
            v, before, c = (v - step * G / 2) / (1 + c * step / 2), 0.0, 40.0
        v = (v * (1 - c * before / 2) - (before + step) * G / 2) / (1 + c * step / 2)
        z, before = z + step * v, step
        heights.append(z)
    with Instance(pack(falling_sheet(step, damping=3.0))) as cloth:
        start = cloth.initialize().get("probe.centre.position[3]")[0]
        cloth.run(0.02, 0.001)
        assert cloth.get("probe.centre.position[3]")[0] - start == pytest.approx(heights[999], rel=1e-12)
        assert cloth.set("damping", 40.0) == 0
        cloth.run(0.04, 0.001)
        assert cloth.get("probe.centre.position[3]")[0] - start == pytest.approx(heights[1999], rel=1e-12)


def test_density_leaves_free_fall_unchanged(pack):
    fmu = pack(falling_sheet(0.001 / 100), nodes="all")
    ends = []
    for density in (None, 0.45):
        with Instance(fmu) as cloth:
            cloth.initialize().run(0.02, 0.001)
            if density:
                assert cloth.set("fabric.wool.areal_density", density) == 0
            ends.append(cloth.run(0.04, 0.001).nodes())
    # Only the rounding of the positions strains the links: 1e-16 m at every step, which the laws do not let grow.
    assert ends[0] == pytest.approx(ends[1], abs=1e-13)
    assert abs(ends[0][0, 2] - 1.0) > 0.007


def test_gravity_in_free_fall(pack):
    """Leapfrog lies on the parabola z = -g t^2/2; from 20 ms on, gravity is off and v = -g t stays."""
    step = 0.001 / 50
    with Instance(pack(falling_sheet(step))) as cloth:
        start = cloth.initialize().get("probe.centre.position[3]")[0]
        cloth.run(0.02, 0.001)
        assert cloth.set("gravity[3]", 0.0) == 0
        cloth.run(0.05, 0.001)
        fallen = cloth.get("probe.centre.position[3]")[0] - start
    assert fallen == pytest.approx(-G * (0.02**2 / 2 + 0.02 * 0.03), rel=1e-12)


def strip(points):
    """A strip that hangs from its upper edge; the warp's diagram is straight, the other laws are off."""
    scene = sheet(0.02, 0.1, 0.01, HANGING, damping=800.0)
    scene["fabric"] = {
        "soft": {
            "areal_density": 0.15,
            "thickness": 0.0005,
            "warp": {"elongation_percent": [0, *(100 * e for e, _ in points)], "force": [0, *(f for _, f in points)]},
        }
    }
    scene["piece"][0]["fabric"] = "soft"
    pin_edge(scene, "bar", 2)
    return scene


TUNED = {
    "areal density": {"fabric.soft.areal_density": 0.3},
    "diagram": {"fabric.soft.warp.force[1]": 1.0, "fabric.soft.warp.force[2]": 2.0},
    "gravity": {"gravity[3]": -1.62},
}


@pytest.mark.parametrize("tuned", TUNED.values(), ids=TUNED)
def test_hanging_strip_finds_its_new_length(pack, tuned):
    """At rest link i from the hem bears rho g w (L - (n - 1/2 - i) b) with n links of length b: the weight below its
    middle. Link by link T = k w e. Motion at c = 800/s and omega_1 = (pi/2L) sqrt(k/rho) = 287/s dies out within 0.4 s:
    exp(-0.4 (400 - sqrt(400^2 - 287^2))) = 7e-20."""
    rho, k, g = 0.15, 100.0, G
    fmu = pack(strip([(0.05, 0.25), (0.10, 0.5)]), nodes="all")  # 0.25 N on 50 mm at 5 %: 100 N/m

    def rest(rho, k, g):
        below = (np.arange(10) + 0.5) * 0.01  # m of cloth below the middle of each link
        lengths = 0.01 * (1 + rho * g * below / k)
        return 1.1 - np.concatenate([[lengths.sum()], lengths.sum() - np.cumsum(lengths)])

    with Instance(fmu) as cloth:
        cloth.initialize().run(0.4, 0.01)
        heights = cloth.nodes()[:, 2].reshape(11, 3)
        assert heights == pytest.approx(np.tile(rest(rho, k, g), (3, 1)).T, rel=1e-9)
        for name, value in tuned.items():
            assert cloth.set(name, value) == 0
        cloth.run(0.9, 0.01)
        rho = tuned.get("fabric.soft.areal_density", rho)
        k = 400.0 * tuned.get("fabric.soft.warp.force[1]", 0.25)
        g = -tuned.get("gravity[3]", -g)
        heights = cloth.nodes()[:, 2].reshape(11, 3)
        assert heights == pytest.approx(np.tile(rest(rho, k, g), (3, 1)).T, rel=1e-9)


def stiffer_and_heavier(cloth, factor):
    """The names and scaled values of everything that has the dimension of a mass."""
    for name in cloth.fmu.variables:
        if name.startswith("fabric.wool.") and name.split(".")[2].split("[")[0] in (
            "areal_density",
            "warp",
            "weft",
            "bias",
            "bending",
        ):
            yield name, factor * cloth.get(name)[0]


def test_mass_and_all_forces_doubled_while_it_moves(pack):
    """Multiplying the areal density, every diagram point and both rigidities by 2 multiplies m r'' = m g - m c r' + F
    by 2, and so does 4: the same motion to the last bit, with 2 and 4 times the force on the pins; without a change, but
    the braking of the two half steps at the change, which differs from that of a whole one by (c h/2)^2. Leaving any
    one of them out changes it."""
    fmu = pack(swinging_sheet(damping=1.0), nodes="all")

    def end(leave_out=None, factor=2.0):
        with Instance(fmu) as cloth:
            cloth.initialize().run(0.02, 0.001)
            for name, value in stiffer_and_heavier(cloth, factor):
                if leave_out is None or not name.startswith(leave_out):
                    assert cloth.set(name, value) == 0
            cloth.run(0.04, 0.001)
            return cloth.nodes(), cloth.get("pin.left.force[3]", "pin.right.force[3]")

    nodes, force = end(factor=1.0)
    doubled_nodes, doubled_force = end()
    nodes_of_four, force_of_four = end(factor=4.0)
    assert doubled_nodes == pytest.approx(nodes, abs=1e-10)
    assert doubled_force == pytest.approx(2 * force, rel=1e-6)
    assert same_bits(doubled_nodes, nodes_of_four)
    assert same_bits(2 * doubled_force, force_of_four)
    for left_out in ("areal_density", "warp.force", "weft.force", "bias.force", "bending.warp", "bending.weft"):
        assert end(f"fabric.wool.{left_out}")[0] != pytest.approx(nodes, abs=1e-10), left_out


def test_start_value_is_the_scene_with_that_value(pack):
    """A value set before the first step gives the motion of a scene that names it, to the last bit."""
    scene = swinging_sheet()
    with Instance(pack(scene, nodes="all", name="a")) as cloth:
        start = {"damping": 4.0, "gravity[1]": 1.0, "fabric.wool.compression": 0.25}
        tuned = cloth.initialize(**start).run(0.02, 0.001).nodes()
    scene["scene"] |= {"damping": 4.0, "gravity": [1.0, 0.0, -G]}
    scene["fabric"]["wool"]["compression"] = 0.25
    with Instance(pack(scene, nodes="all", name="b")) as cloth:
        assert same_bits(tuned, cloth.initialize().run(0.02, 0.001).nodes())
