"""A piece sewn to itself: a bent rectangle becomes a round tube.

Packs scene.toml, simulates it with FMPy, prints gap and diameters, draws three moments, and checks the shape: a sheet of width w
that bends across its seam as it does elsewhere has its least energy, 2 pi^2 B/w per length, as a ring of the radius w/(2 pi).

    .venv/bin/python examples/tube/run.py [FOLDER]      results go to FOLDER, default build/tube
"""
import math
import os
import subprocess
import sys
from pathlib import Path

os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")  # draws without a screen

import fmpy
import pyvista

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
DRAWN = (0.0, 0.05, 1.5)  # s
EVERY = 0.05              # s
WIDTH, HEIGHT = 0.25, 0.1  # m


def command(*arguments):
    drape = ROOT / "build" / "drape"
    if not drape.exists():
        sys.exit(f"{drape} is missing: run `bash examples/quickstart.sh`")
    subprocess.run([drape, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def draw(frames, file):
    """The cloth at several times side by side."""
    plotter = pyvista.Plotter(off_screen=True, shape=(1, len(frames)), window_size=(300 * len(frames), 330), border=False)
    for k, (time, frame) in enumerate(frames):
        plotter.subplot(0, k)
        plotter.add_mesh(pyvista.read(frame), color="#d8b78a", show_edges=True, edge_color="#8a6a40", line_width=0.6)
        plotter.add_text(f"{time:.2f} s", position="lower_edge", font_size=9, color="black")
        plotter.camera_position = [(0.02, -0.28, 0.24), (0, 0, 0.05), (0, 0, 1)]
        plotter.set_background("white")
    plotter.screenshot(str(file))


def distance(row, one, other):
    return math.dist(*([row[f"probe.{probe}.position[{k}]"] for k in (1, 2, 3)] for probe in (one, other)))


def check(result):
    print("time, s   gap, mm   closed   diameters, mm")
    for row in result[::3]:
        diameters = [1e3 * distance(row, *ends) for ends in (("front", "back"), ("left", "right"))]
        print(f"{row['time']:7.2f} {1e3 * row['seam.side.gap.max']:9.4f} {row['seam.side.closed']:8.0f} "
              + " ".join(f"{d:8.2f}" for d in diameters))
    end = result[-1]
    assert end["seam.side.closed"] == 1 and end["seam.side.gap.max"] < 1e-12, "the seam is open"
    assert abs(end["seam.side.length"] / HEIGHT - 1) < 5e-3, "the seam has not kept its length"
    for ends in (("front", "back"), ("left", "right")):
        ratio = distance(end, *ends) / (WIDTH / math.pi)
        assert abs(ratio - 1) < 5e-3, f"the tube is not round: {'-'.join(ends)} is {ratio:.3f} of the diameter"
    print(f"closed and round: w/pi is {1e3 * WIDTH / math.pi:.2f} mm")



def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build" / "tube"
    folder.mkdir(parents=True, exist_ok=True)
    fmu = folder / "tube.fmu"
    command("pack", HERE / "scene.toml", "-o", fmu)
    result = fmpy.simulate_fmu(str(fmu), output_interval=0.05)
    command("run", HERE / "scene.toml", "-o", folder / "frames", "--until", DRAWN[-1], "--every", EVERY, "--frames")
    files = sorted((folder / "frames").glob("frames/*.vtp"))
    draw([(time, files[round(time / EVERY)]) for time in DRAWN], folder / "tube.png")
    check(result)


if __name__ == "__main__":
    main()
