"""A cap sleeve set into an armhole: a closed seam with ease, where three pieces meet in a point.

Packs scene.toml, simulates it with FMPy, prints how far its five seams are, draws three moments, and checks that all are closed
and that the ring of the armhole kept its length.

    .venv/bin/python examples/sleeve/run.py [FOLDER]      results go to FOLDER, default build/sleeve
"""
import os
import subprocess
import sys
from pathlib import Path

os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")  # draws without a screen

import fmpy
import pyvista

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SEAMS = ("shoulder", "side", "underarm", "armhole_front", "armhole_back")
ARMHOLE, EASE = 2 * 0.174175, 1.084  # m, both edges of the armhole (drape check); of the cap over them
DRAWN = (0.0, 0.1, 1.2)  # s
EVERY = 0.1              # s


def command(*arguments):
    drape = ROOT / "build" / "drape"
    if not drape.exists():
        sys.exit(f"{drape} is missing: run `bash examples/quickstart.sh`")
    subprocess.run([drape, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def draw(frames, file):
    """The cloth at several times side by side."""
    plotter = pyvista.Plotter(off_screen=True, shape=(1, len(frames)), window_size=(300 * len(frames), 440), border=False)
    for k, (time, frame) in enumerate(frames):
        plotter.subplot(0, k)
        plotter.add_mesh(pyvista.read(frame), color="#d8b78a", show_edges=True, edge_color="#8a6a40", line_width=0.6)
        plotter.add_text(f"{time:.2f} s", position="lower_edge", font_size=9, color="black")
        plotter.camera_position = [(0.72, -0.78, 0.52), (0.14, 0, 0.17), (0, 0, 1)]
        plotter.set_background("white")
    plotter.screenshot(str(file))


def armhole(row):
    return row["seam.armhole_front.length"] + row["seam.armhole_back.length"]


def check(result):
    print("time, s   largest gap of each seam, mm; * closed" + " " * 24 + "armhole, m")
    for row in result[::3]:
        gaps = "  ".join(f"{s} {1e3 * row[f'seam.{s}.gap.max']:.3f}{'*' if row[f'seam.{s}.closed'] else ''}" for s in SEAMS)
        print(f"{row['time']:7.2f}   {gaps}   {armhole(row):.4f}")
    end = result[-1]
    for s in SEAMS:
        assert end[f"seam.{s}.closed"] == 1, f"the seam {s} is open"
    assert abs(armhole(end) / ARMHOLE - 1) < 5e-3, "the armhole has not kept its length"
    print(f"all seams closed; the armhole is {armhole(end):.4f} m long, of edges of {ARMHOLE:.4f} m and a cap {EASE} times as long")



def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build" / "sleeve"
    folder.mkdir(parents=True, exist_ok=True)
    fmu = folder / "sleeve.fmu"
    command("pack", HERE / "scene.toml", "-o", fmu)
    result = fmpy.simulate_fmu(str(fmu), output_interval=0.05)
    command("run", HERE / "scene.toml", "-o", folder / "frames", "--until", DRAWN[-1], "--every", EVERY, "--frames")
    files = sorted((folder / "frames").glob("frames/*.vtp"))
    draw([(time, files[round(time / EVERY)]) for time in DRAWN], folder / "sleeve.png")
    check(result)


if __name__ == "__main__":
    main()
