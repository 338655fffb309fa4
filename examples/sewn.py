"""A scene with seams as an example: sewn under FMPy, drawn at several moments, checked."""
import os
import sys
from pathlib import Path

os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")  # draws without a screen

import fmpy
import pyvista
from stage import ROOT, drape

ROWS = 0.05  # s between rows of the result


def draw(frames, file, camera, panel, edges, font_size):
    """The cloth at several times side by side; `panel`: its size in pixels."""
    wide, high = panel
    plotter = pyvista.Plotter(off_screen=True, shape=(1, len(frames)), window_size=(wide * len(frames), high), border=False)
    for k, (time, frame) in enumerate(frames):
        plotter.subplot(0, k)
        plotter.add_mesh(pyvista.read(frame), color="#d8b78a", show_edges=True, **edges)
        plotter.add_text(f"{time:.2f} s", position="lower_edge", font_size=font_size, color="black")
        plotter.camera_position = camera
        plotter.set_background("white")
    plotter.screenshot(str(file))


def sewn(example, check, drawn, every, camera, panel=(300, 440), edge_color="#8a6a40", line_width=0.6, font_size=9):
    """Sews the scene in the folder `example` and checks the rows of the result. `drawn`: s, multiples of `every`."""
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build" / example.name
    folder.mkdir(parents=True, exist_ok=True)
    fmu, scene = folder / f"{example.name}.fmu", example / "scene.toml"
    drape("pack", scene, "-o", fmu)
    result = fmpy.simulate_fmu(str(fmu), output_interval=ROWS)
    drape("run", scene, "-o", folder / "frames", "--until", drawn[-1], "--every", every, "--frames")
    files = sorted((folder / "frames").glob("frames/*.vtp"))
    draw([(time, files[round(time / every)]) for time in drawn], folder / f"{example.name}.png", camera, panel,
         {"edge_color": edge_color, "line_width": line_width}, font_size)
    check(result)
