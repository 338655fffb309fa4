"""The cloth as a picture: its shape at several times side by side, coloured by the tension of its warp."""
import os

os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")  # draws without a screen
os.environ.setdefault("MPLBACKEND", "Agg")

import numpy as np
import pyvista
from matplotlib import cm, colors, pyplot

WIDTH, HEIGHT, SCALE = 760, 740, 1040  # pixels of one panel, pixels per metre
AIM = (0.18, -0.18, 0.73)  # m, in the middle of a panel
PIXELS = 16  # per cell, of the woven picture


def warp_tension(position, piece, fabric):
    """[rows x columns] N/m: mean over the one or two links along the warp at each particle, from the measured diagram
    with its points joined by straight lines; 0 where the thread is slack."""
    strain = np.linalg.norm(np.diff(position, axis=0), axis=2) / piece["cell"] - 1
    diagram = fabric["warp"]
    tension = np.interp(100 * strain, diagram["elongation_percent"], diagram["force"]) / fabric["strip"]["width"]
    padded = np.concatenate([tension[:1], tension, tension[-1:]])
    return (padded[:-1] + padded[1:]) / 2


def weave(tension, norm, colours):
    """[pixels x pixels x 3] The flat cloth: the tension's colours, and a darker thread every 5 cells along warp and
    weft."""
    rows, columns = (np.linspace(0, n - 1, PIXELS * (n - 1)) for n in tension.shape)
    smooth = np.array([np.interp(columns, np.arange(tension.shape[1]), line) for line in tension])
    smooth = np.array([np.interp(rows, np.arange(tension.shape[0]), line) for line in smooth.T]).T
    dark_row, dark_column = (abs((place + 2.5) % 5 - 2.5) < 0.09 for place in (rows, columns))  # in cells
    shade = np.where(dark_row[:, None] | dark_column, 0.72, 1.0)
    return np.uint8(255 * colours(norm(smooth))[..., :3] * shade[..., None])


def photograph(position, picture, peg):
    """[height x width x 3] One state of the cloth, in parallel projection, so that all panels share one scale."""
    plotter = pyvista.Plotter(off_screen=True, window_size=(WIDTH, HEIGHT), lighting="none")
    for place, intensity in (((-1, -2, 1.5), 0.5), ((2, -1, 1), 0.35), ((1, -1, -1), 0.4), ((0, 0, 1), 0.25)):
        plotter.add_light(pyvista.Light(position=place, focal_point=(0, 0, 0), intensity=intensity))
    cloth = pyvista.StructuredGrid(*np.moveaxis(position, 2, 0))
    along_y, along_x = np.meshgrid(*(np.linspace(0, 1, n) for n in position.shape[:2]), indexing="ij")
    cloth.active_texture_coordinates = np.array([along_x.ravel(order="F"), along_y.ravel(order="F")]).T
    texture = pyvista.Texture(np.ascontiguousarray(picture[::-1]))  # its first line of pixels is drawn at the top
    plotter.add_mesh(cloth, texture=texture, smooth_shading=True, ambient=0.35, diffuse=0.8, specular=0)
    plotter.add_mesh(pyvista.Cylinder(center=peg, direction=(1, 1, 0), radius=0.006, height=0.12), color="#404040")
    plotter.camera_position = [np.add(AIM, (2, -2, 0.9)), AIM, (0, 0, 1)]
    plotter.camera.parallel_projection = True
    plotter.camera.parallel_scale = HEIGHT / SCALE / 2
    plotter.set_background("white")
    plotter.enable_anti_aliasing("ssaa")
    return plotter.screenshot(return_img=True)


def draw(times, positions, tensions, peg, file):
    """The cloth at several times side by side, coloured by the tension of its warp."""
    largest = max(tension.max() for tension in tensions)
    norm = colors.PowerNorm(0.5, 0, largest)  # a square root: small tensions stay visible next to those at the peg
    colours = colors.LinearSegmentedColormap.from_list("wool", ["#f4ead2", "#ecc07c", "#d8622f", "#961522", "#3c0512"])

    pyplot.rcParams.update({"font.size": 16})
    figure, panels = pyplot.subplots(1, len(times), figsize=(13, 3.5), layout="constrained")
    for panel, moment, position, tension in zip(panels, times, positions, tensions):
        panel.imshow(photograph(position, weave(tension, norm, colours), peg))
        panel.set_title(f"{moment:.2f} s", y=0, pad=-14)
        panel.axis("off")
    panels[0].plot([40, 40 + 0.1 * SCALE], [60, 60], color="black", linewidth=3, solid_capstyle="butt")
    panels[0].text(40 + 0.05 * SCALE, 80, "10 cm", ha="center", va="top")
    legend = figure.colorbar(cm.ScalarMappable(norm, colours), ax=panels, pad=0.01, aspect=18, shrink=0.9)
    legend.set_ticks([t for t in (0, 2, 10, 20, 40, 60, 80) if t < 0.93 * largest] + [largest], minor=False)
    legend.ax.yaxis.set_major_formatter("{x:.0f}")
    legend.ax.minorticks_off()
    legend.set_label("warp tension, N/m")
    figure.savefig(file, dpi=100)
