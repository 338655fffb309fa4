"""A woollen square, held level, is let go and swings down from a peg at one corner.

Packs scene.toml as an FMU, simulates it with FMPy, prints figures, draws the cloth, and checks the momentum and the
energy of the whole run.

    .venv/bin/python examples/hanging_wool/run.py [FOLDER]      results go to FOLDER, default build/hanging_wool
"""
import subprocess
import sys
import time
import tomllib
from pathlib import Path

import fmpy
import numpy as np
from picture import draw, warp_tension

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
INTERVAL = 0.01  # s between rows of the result
DRAWN = (0.20, 0.30, 0.40, 0.50)  # s
GRAVITY = np.array([0.0, 0.0, -9.81])  # m/s^2


def read_toml(file):
    with open(file, "rb") as text:
        return tomllib.load(text)


def pack(fmu):
    """One self-contained FMU, with the position and velocity of every particle among its outputs."""
    drape = ROOT / "build" / "drape"
    if not drape.exists():
        sys.exit(f"{drape} is missing: run `bash examples/quickstart.sh`")
    subprocess.run([drape, "pack", HERE / "scene.toml", "-o", fmu, "--nodes", "all"], check=True)


def simulate(fmu):
    """All outputs every INTERVAL; of the particles also arrays [rows of the result x particles x 3]."""
    result = fmpy.simulate_fmu(str(fmu), output_interval=INTERVAL)

    def particles(name):
        columns = [result[c] for c in result.dtype.names if c.startswith(f"{name}[")]
        return np.array(columns).T.reshape(len(result), -1, 3)

    return result, particles("node.position"), particles("node.velocity")


def particle_masses(piece, fabric):
    """[rows x columns] kg: an inner particle has the mass of a whole cell, one at an edge of half, at a corner of a
    quarter."""
    (width, height), cell = piece["outline"][2], piece["cell"]
    share = np.ones((round(height / cell) + 1, round(width / cell) + 1))
    share[[0, -1], :] /= 2
    share[:, [0, -1]] /= 2
    return fabric["areal_density"] * cell**2 * share


def force_on_peg(result):
    """[rows x 3] N: pull of the cloth on the peg, mean over the interval before the row."""
    return np.array([result[f"pin.peg.force[{k}]"] for k in (1, 2, 3)]).T


def print_figures(result):
    print("\n  time   tip height   tip speed    on peg   tension    warp    weft    bias")
    print("     s            m         m/s         N       N/m       %       %       %   (largest in the cloth)")
    every = max(1, len(result) // 10)
    for row, force in zip(result[::every], force_on_peg(result)[::every]):
        speed = np.linalg.norm([row[f"probe.tip.velocity[{k}]"] for k in (1, 2, 3)])
        warp, weft, bias = (100 * row[f"strain.{thread}.max"] for thread in ("warp", "weft", "bias"))
        print(
            f"{row['time']:6.2f} {row['probe.tip.position[3]']:12.3f} {speed:11.3f} {np.linalg.norm(force):9.3f}"
            f" {row['tension.max']:9.2f} {warp:7.3f} {weft:7.2f} {bias:7.2f}"
        )


def check(result, position, velocity, mass, damping):
    """Newton's second law and the energy of the whole cloth over the whole run. M is the mass, x and v the place and
    velocity of its centre, c the damping, F the pull on the peg, a mean over each interval H:

        M v(T) = M g T - c M [x(T) - x(0)] - sum F H             E(0) - E(T) = integral of 2 c E_kinetic dt

    Leapfrog with centred damping keeps the first balance up to M c h^2 a/4 of the last step: 1e-9 of M g T. The
    integral is a sum over the rows by the trapezium rule, good to H^2 E_kinetic''/12: 1e-3 of it for a swing of 5 Hz.
    """
    duration, total = result["time"][-1], mass.sum()
    weight = -total * GRAVITY[2]
    gained = np.tensordot(mass, velocity[-1], axes=2) + damping * np.tensordot(mass, position[-1] - position[0], axes=2)
    pulled = (np.diff(result["time"])[:, None] * force_on_peg(result)[1:]).sum(axis=0)
    momentum_error = np.linalg.norm(total * GRAVITY * duration - pulled - gained) / (weight * duration)

    energy = sum(result[f"energy.{kind}"] for kind in ("kinetic", "stretch", "shear", "bending", "gravity"))
    kinetic = result["energy.kinetic"]
    braked = damping * (np.diff(result["time"]) * (kinetic[1:] + kinetic[:-1])).sum()
    energy_error = abs(energy[0] - energy[-1] - braked) / braked

    largest = np.linalg.norm(force_on_peg(result), axis=1).max() / weight
    print(f"\nlargest pull on the peg: {largest:.1f} times the weight of the cloth")
    print(f"weight {weight:.4f} N; balance of momentum within {momentum_error:.1e} of weight x time")
    print(f"energy lost {energy[0] - energy[-1]:.5f} J; the damping took {braked:.5f} J")
    assert momentum_error < 1e-6, "the forces on the cloth do not add up to its momentum"
    assert energy_error < 0.01, "energy was lost or won elsewhere than in the damping"
    assert np.all(np.diff(energy) < 0), "energy grew"
    assert result["strain.beyond_test.count"].max() == 0, "a thread left the measured part of its diagram"


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build" / "hanging_wool"
    folder.mkdir(parents=True, exist_ok=True)
    fmu, table, picture = (folder / f"hanging_wool.{ending}" for ending in ("fmu", "csv", "png"))
    scene = read_toml(HERE / "scene.toml")
    piece = scene["piece"][0]
    fabric = read_toml(HERE / scene["fabric"]["wool"]["file"])
    mass = particle_masses(piece, fabric)

    pack(fmu)
    begin = time.perf_counter()
    result, position, velocity = simulate(fmu)
    print(
        f"{scene['scene']['name']}: {mass.size} particles, {result['step.count'][-1]:.0f} steps for"
        f" {result['time'][-1]:g} s of cloth in {time.perf_counter() - begin:.1f} s"
    )
    position, velocity = (a.reshape(len(result), *mass.shape, 3) for a in (position, velocity))
    print_figures(result)

    summary = [name for name in result.dtype.names if not name.startswith("node.")]
    np.savetxt(table, result[summary].tolist(), delimiter=",", header=",".join(summary), comments="")
    drawn = [np.argmin(abs(result["time"] - t)) for t in DRAWN]
    tensions = [warp_tension(position[k], piece, fabric) for k in drawn]
    draw(result["time"][drawn], position[drawn], tensions, position[0, -1, 0], picture)  # the peg: last row, column 1
    check(result, position, velocity, mass, scene["scene"]["damping"])
    print(f"\nFMU      {fmu}\noutputs  {table}\npicture  {picture}")


if __name__ == "__main__":
    main()
