"""A frill is gathered to the hem of a tube: FMPy sews, and reads how far the seams are.

Packs scene.toml as an FMU, simulates it, prints gaps and lengths of the seams, draws the cloth, and checks that all seams are
closed and that the hem kept its length.

    .venv/bin/python examples/frill/run.py [FOLDER]      results go to FOLDER, default build/frill
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
SEAMS = ("tube_side", "frill_side", "gather")
HEM = 0.5  # m, the shorter side of the gathers
DRAWN = (0.0, 0.1, 0.5)  # s


def command(*arguments):
    drape = ROOT / "build" / "drape"
    if not drape.exists():
        sys.exit(f"{drape} is missing: run `bash examples/quickstart.sh`")
    subprocess.run([drape, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def report(result):
    print("time, s   " + "   ".join(f"{seam}: gap, mm; closed" for seam in SEAMS) + "   hem, m")
    for row in result[::5]:
        states = "   ".join(
            f"{1e3 * row[f'seam.{s}.gap.max']:{len(s) + 6}.3f} {row[f'seam.{s}.closed']:10.0f}" for s in SEAMS)
        print(f"{row['time']:7.2f}   {states}   {row['seam.gather.length']:.4f}")


def draw(frames, file):
    """The cloth at several times side by side."""
    plotter = pyvista.Plotter(off_screen=True, shape=(1, len(frames)), window_size=(420 * len(frames), 420), border=False)
    for k, (time, frame) in enumerate(frames):
        plotter.subplot(0, k)
        plotter.add_mesh(pyvista.read(frame), color="#d8b78a", show_edges=True, edge_color="#8a6a40", line_width=0.6)
        plotter.add_text(f"{time:.2f} s", position="lower_edge", font_size=10, color="black")
        plotter.camera_position = [(0.36, -0.45, 0.74), (0, 0, 0.51), (0, 0, 1)]
        plotter.set_background("white")
    plotter.screenshot(str(file))


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build" / "frill"
    folder.mkdir(parents=True, exist_ok=True)
    fmu = folder / "frill.fmu"
    command("pack", HERE / "scene.toml", "-o", fmu)
    result = fmpy.simulate_fmu(str(fmu), output_interval=0.05)
    report(result)
    command("run", HERE / "scene.toml", "-o", folder / "frames", "--until", DRAWN[-1], "--every", 0.1, "--frames")
    files = sorted((folder / "frames").glob("frames/*.vtp"))
    draw([(time, files[round(time / 0.1)]) for time in DRAWN], folder / "frill.png")
    end = result[-1]
    assert all(end[f"seam.{seam}.closed"] == 1 for seam in SEAMS), "a seam is open"
    assert abs(end["seam.gather.length"] / HEM - 1) < 5e-3, "the hem has not kept its length"
    print(f"all seams closed; the hem is {end['seam.gather.length']:.4f} m long, from sides of 0.5 m and 0.65 m")


if __name__ == "__main__":
    main()
