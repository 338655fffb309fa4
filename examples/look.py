"""Pictures of a run: the cloth coloured by a field, with its seams and bodies.

    .venv/bin/python examples/look.py OUTDIR --field tension_warp -o picture.png

OUTDIR is the folder of `drape run SCENE -o OUTDIR --frames`. The last frame is drawn unless --time says otherwise; each --view
(front, back, left, right, oblique, top, or a direction X,Y,Z to look from) is a panel.
"""
import argparse
import io
import math
import os
import sys
from dataclasses import dataclass
from pathlib import Path

os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")  # draws without a screen
os.environ.setdefault("MPLBACKEND", "Agg")

import numpy as np
import pyvista
from matplotlib import cm, colors, pyplot
from PIL import Image

FIELDS = {  # of the frames: what it is called, unit, factor to this unit
    "tension_warp": ("warp tension", "N/m", 1),
    "tension_weft": ("weft tension", "N/m", 1),
    "strain_warp": ("warp elongation", "%", 100),
    "strain_weft": ("weft elongation", "%", 100),
    "strain_bias": ("bias elongation", "%", 100),
    "pressure": ("contact pressure", "Pa", 1),
    "speed": ("speed", "m/s", 1),
}
VIEWS = {  # directions of view, with y up
    "front": (0, 0, 1), "back": (0, 0, -1), "left": (1, 0, 0), "right": (-1, 0, 0), "top": (0, 1, 1e-3),
    "oblique": (0.6, 0.25, 1),
}
RISING = colors.LinearSegmentedColormap.from_list("zones", ["#f3ead6", "#f2c879", "#e2703a", "#a41d2c", "#43071a"])
SIGNED = colors.LinearSegmentedColormap.from_list("signed", ["#123f78", "#6aa5d8", "#f3ead6", "#e2703a", "#7d0f22"])
PIXELS, WIDEST = 600, 800  # of a panel, high and wide at most
BEHIND = 0.01  # of the height of a picture
GAP_SHOWN = 1e-3  # m: seams that are farther open are drawn in red


@dataclass
class Moment:
    time: float
    cloth: pyvista.PolyData
    seams: pyvista.PolyData | None
    bodies: pyvista.PolyData | None


def frame_times(folder):
    return np.array(pyvista.get_reader(str(Path(folder) / "frames.pvd")).time_values)


def moment(folder, time=None):
    """What was where at the frame that is nearest to a time (default: the last)."""
    times = frame_times(folder)
    number = len(times) - 1 if time is None else int(np.argmin(abs(times - time)))

    def part(name):
        file = Path(folder) / f"{name}.pvd"
        if not file.exists():
            return None
        reader = pyvista.get_reader(str(file))
        reader.set_active_time_value(reader.time_values[number])
        return reader.read()[0]

    return Moment(times[number], part("frames"), part("seams"), part("bodies"))


def values_of(cloth, field):
    if field == "speed":
        return np.linalg.norm(cloth["velocity"], axis=1)
    return FIELDS[field][2] * np.asarray(cloth[field], float)


def scale_of(field, values, limits):
    """Colours. Tension and pressure by their square root, so that small values stay visible next to the peaks; slack and pushed
    threads have the colour of 0. Elongation either way where there is both. The largest half of a percent share one colour."""
    low, high = limits or np.quantile(values, [0.005, 0.995])
    if field.startswith("strain") and low < -0.05 * high:
        low, high = (low, high) if limits else (-max(-low, high), max(-low, high))
        return colors.Normalize(low, high), SIGNED
    low = low if limits else 0.0
    high = high if high > low else low + 1
    return (colors.Normalize if field.startswith("strain") or field == "speed" else root_norm)(low, high), RISING


def root_norm(low, high):
    return colors.PowerNorm(0.5, low, high)


@dataclass
class Camera:
    """Parallel projection along `towards` (from what is shown to the eye), `size` in pixels, what is shown in metres."""
    towards: np.ndarray
    across: np.ndarray
    upward: np.ndarray
    centre: np.ndarray
    size: tuple
    high: float


def camera_of(box, view, up):
    """Shows a box of space [3 x 2]."""
    vertical = np.array({"y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}.get(up, up) if isinstance(up, str) else up, float)
    towards = np.array(VIEWS[view] if isinstance(view, str) else view, float)
    if up == "z" and isinstance(view, str):
        towards = np.array([towards[0], -towards[2], towards[1]])
    towards /= np.linalg.norm(towards)
    across = np.cross(vertical, towards)
    if np.linalg.norm(across) < 1e-6:
        across = np.array([1.0, 0.0, 0.0])
    across /= np.linalg.norm(across)
    upward = np.cross(towards, across)
    corners = np.array([[box[0, i], box[1, j], box[2, k]] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
    wide, high = (np.ptp(corners @ axis) for axis in (across, upward))
    scale = min(PIXELS / high, WIDEST / wide)
    return Camera(towards, across, upward, box.mean(axis=1), (round(scale * wide), round(scale * high)), high)


def photograph(now, field, norm, colours, camera):
    """[height x width x 3]"""
    plotter = pyvista.Plotter(off_screen=True, window_size=camera.size, lighting="none")
    for across, upward, towards, intensity in ((-0.9, 0.8, 1.0, 0.62), (1.2, 0.0, 1.0, 0.3), (0.0, 1.0, 0.0, 0.2)):
        place = across * camera.across + upward * camera.upward + towards * camera.towards
        plotter.add_light(pyvista.Light(position=tuple(place), focal_point=(0, 0, 0), intensity=intensity))
    shading = {"ambient": 0.28, "diffuse": 0.85, "specular": 0.0}
    if now.bodies is not None:  # a little farther from the eye, where threads lie on it between their particles
        bodies = now.bodies.copy()
        bodies.points = bodies.points - BEHIND * camera.high * camera.towards
        plotter.add_mesh(bodies, color="#b9bcc2", smooth_shading=True, split_sharp_edges=True, **shading)
    cloth = now.cloth.triangulate()
    cloth["shown"] = np.asarray(norm(values_of(now.cloth, field)), float)
    plotter.add_mesh(cloth, scalars="shown", cmap=colours, clim=(0, 1), show_scalar_bar=False, smooth_shading=True,
                     interpolate_before_map=True, **shading)
    if now.seams is not None:
        seams = now.seams.copy()
        seams.points = seams.points + BEHIND / 2 * camera.high * camera.towards
        gaps = np.array([seams["gap"][seams.get_cell(k).point_ids].max() for k in range(seams.n_cells)])
        for lines, colour in ((gaps <= GAP_SHOWN, "#26282c"), (gaps > GAP_SHOWN, "#e00000")):
            if lines.any():
                plotter.add_mesh(seams.extract_cells(np.nonzero(lines)[0]), color=colour, line_width=2.5, lighting=False)
    plotter.camera_position = [camera.centre + 20 * camera.towards, camera.centre, camera.upward]
    plotter.camera.parallel_projection = True
    plotter.camera.parallel_scale = camera.high / 2
    plotter.camera.clipping_range = (1, 40)
    plotter.set_background("white")
    plotter.enable_anti_aliasing("ssaa")
    image = plotter.screenshot(return_img=True)
    plotter.close()
    return image


def box_of(now, margin):
    """[3 x 2] m round the cloth, and round bodies that are not much larger than it."""
    box = np.array(now.cloth.bounds).reshape(3, 2)
    size = np.linalg.norm(box[:, 1] - box[:, 0])
    grow = margin * size * np.array([-1, 1])
    if now.bodies is not None and now.bodies.length < 1.2 * size:
        body = np.array(now.bodies.bounds).reshape(3, 2)
        box = np.stack([np.minimum(box[:, 0], body[:, 0]), np.maximum(box[:, 1], body[:, 1])], axis=1)
    return box + grow


def picture(folder, file, field="tension_warp", time=None, views=("front", "back"), up="y", limits=None, title=None, margin=0.04,
            times=None):
    """Draws one panel a view, or with `times` one panel a moment of the first view."""
    moments = [moment(folder, t) for t in times] if times is not None else [moment(folder, time)] * len(views)
    views = [views[0]] * len(moments) if times is not None else list(views)
    everything = np.concatenate([values_of(m.cloth, field) for m in moments])
    norm, colours = scale_of(field, everything, limits)
    boxes = [box_of(m, margin) for m in moments]
    box = np.stack([np.min([b[:, 0] for b in boxes], axis=0), np.max([b[:, 1] for b in boxes], axis=0)], axis=1)
    images = [photograph(m, field, norm, colours, camera_of(box, v, up)) for m, v in zip(moments, views)]
    images = trimmed(images) if times is not None else [trimmed([image])[0] for image in images]
    high = max(image.shape[0] for image in images)
    wide = sum(image.shape[1] for image in images)
    pyplot.rcParams.update({"font.size": 13})
    figure, panels = pyplot.subplots(1, len(images), figsize=((wide + 150) / 100, (high + 50) / 100), layout="constrained", squeeze=False,
                                     width_ratios=[image.shape[1] for image in images])
    for panel, image, view, m in zip(panels[0], images, views, moments):
        panel.imshow(image)
        panel.set_title(f"{m.time:.2f} s" if times is not None else view if isinstance(view, str) else "", fontsize=13)
        panel.axis("off")
    name, unit, _ = FIELDS[field]
    extend = {(False, False): "neither", (False, True): "max", (True, False): "min", (True, True): "both"}[
        bool(everything.min() < norm.vmin - 1e-9), bool(everything.max() > norm.vmax + 1e-9)]
    bar = figure.colorbar(cm.ScalarMappable(norm, colours), ax=panels[0], pad=0.02, aspect=22, shrink=0.85, extend=extend)
    bar.set_label(f"{name}, {unit}")
    bar.ax.minorticks_off()
    if isinstance(norm, colors.PowerNorm):
        ticks = [t for t in pyplot.MaxNLocator(6).tick_values(norm.vmin, norm.vmax) if norm.vmin <= t <= norm.vmax]
        bar.set_ticks([0, ticks[1] / 5, *ticks[1:]] if len(ticks) > 1 and norm.vmin == 0 else ticks)
        bar.ax.yaxis.set_major_formatter("{x:g}")
    if title:
        figure.suptitle(title, fontsize=13)
    drawn = io.BytesIO()
    figure.savefig(drawn, dpi=100)
    pyplot.close(figure)
    Image.open(drawn).convert("RGB").quantize(256, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE).save(file, optimize=True)


def trimmed(images):
    """Images of one size without the rows and columns at their sides that are white in all of them."""
    dark = np.any([(image < 250).any(axis=2) for image in images], axis=0)
    rows, columns = np.nonzero(dark.any(axis=1))[0], np.nonzero(dark.any(axis=0))[0]
    if len(rows) == 0:
        return images
    return [image[max(rows[0] - 6, 0):rows[-1] + 7, max(columns[0] - 6, 0):columns[-1] + 7] for image in images]


def view_of(text):
    if text in VIEWS:
        return text
    try:
        direction = tuple(float(part) for part in text.split(","))
    except ValueError:
        direction = ()
    if len(direction) != 3 or not all(map(math.isfinite, direction)) or not any(direction):
        raise argparse.ArgumentTypeError(f"'{text}'; allowed: {', '.join(VIEWS)}, or a direction X,Y,Z")
    return direction


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, metavar="OUTDIR", help="of `drape run --frames`")
    parser.add_argument("--field", choices=FIELDS, default="tension_warp")
    parser.add_argument("--time", type=float, metavar="S", help="default: the last frame")
    parser.add_argument("--view", type=view_of, action="append", metavar="VIEW", help=f"{', '.join(VIEWS)}, or X,Y,Z; default: front and back")
    parser.add_argument("--up", choices=["y", "z"], default="z", help="the axis that points up (default: %(default)s; of imported patterns: y)")
    parser.add_argument("--range", type=float, nargs=2, metavar=("LOW", "HIGH"), help="of the colours")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="PICTURE.png")
    options = parser.parse_args()
    if not (options.folder / "frames.pvd").exists():
        sys.exit(f"error: {options.folder} has no frames.pvd; wanted: the folder of `drape run SCENE -o FOLDER --frames`")
    picture(options.folder, options.output, options.field, options.time, options.view or ["front", "back"], options.up, options.range)


if __name__ == "__main__":
    main()
