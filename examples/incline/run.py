"""A square of cloth on an inclined table: it sticks as long as tan a <= mu, and slides with g (sin a - mu cos a).

    .venv/bin/python examples/incline/run.py [FOLDER]      results go to FOLDER, default build/incline
"""
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from look import picture
from stage import ROOT, box, drape, mesh_write, opened, scene_put

HERE = Path(__file__).resolve().parent
MU, G = 0.4, 9.81
SETTLE = 0.1  # s, level, until the cloth lies still
TILT = 0.1  # s, within which the table is tilted
STEEP = 0.6  # rad


def tilted(angle):
    return {"gravity": [G * math.sin(angle), 0.0, -G * math.cos(angle)]}


def way(fmu, angle, times):
    """m: how far down the table the cloth has come at these times after the tilt began."""
    with opened(fmu, start=tilted(0) | {"parameter_ramp": TILT}) as unit:
        unit.step(SETTLE)
        unit.set(tilted(angle))
        start, ways = unit.get("probe.middle.position[1]")[0], []
        for length in [b - a for a, b in zip([0.0, *times], times)]:
            unit.step(length)
            ways.append(unit.get("probe.middle.position[1]")[0] - start)
        return ways


def draw(scene, folder):
    """The slide, seen from the side; up is against gravity."""
    g = tilted(STEEP)["gravity"]
    settings = [f"--set=gravity[{k + 1}]={value}" for k, value in enumerate(g)]
    drape("run", scene, "-o", folder / "run", "--until", 0.4, "--every", 0.2, "--frames", *settings)
    picture(folder / "run", folder / "incline.png", field="speed", times=[0.0, 0.2, 0.4], views=[(-0.1, -1.0, 0.35)],
            up=[-value for value in g])


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build" / "incline"
    scene, fmu = scene_put(folder, HERE / "scene.toml"), folder / "incline.fmu"
    mesh_write(folder / "table.obj", *box(2, 0.4, 0.1))

    drape("pack", scene, "-o", fmu)
    print("tan a / mu    way in 1 s, m")
    ways = {}
    for share in (0.9, 0.999, 1.001, 1.1):
        (ways[share],) = way(fmu, math.atan(share * MU), [1.0])
        print(f"{share:10.3f} {ways[share]:16.3e}")

    # Once the table is tilted, x = x_0 + v_0 t + a t^2/2, of which the second difference is a.
    x = way(fmu, STEEP, [0.2, 0.35, 0.5])
    measured, exact = (x[2] - 2 * x[1] + x[0]) / 0.15**2, G * (math.sin(STEEP) - MU * math.cos(STEEP))
    print(f"\nat {math.degrees(STEEP):.1f} degrees it slides with {measured:.6f} m/s2; g (sin a - mu cos a) = {exact:.6f} m/s2")
    draw(scene, folder)

    assert abs(ways[0.9]) < 1e-6 and abs(ways[0.999]) < 1e-6, "it creeps below the angle of friction"
    for share in (1.001, 1.1):
        angle = math.atan(share * MU)
        assert ways[share] > 0.8 * G * (math.sin(angle) - MU * math.cos(angle)) / 2, "it sticks above the angle of friction"
    assert abs(measured / exact - 1) < 1e-3, "it slides with another acceleration"


if __name__ == "__main__":
    main()
