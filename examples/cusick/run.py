"""The drape coefficient of a fabric, as Cusick's drape meter measures it: the shadow of a disc of 30 cm over a plate of 18 cm.

    DC = (S - 254.5 cm2)/(706.9 cm2 - 254.5 cm2),      S the area of the shadow

A perfectly flat disc would never fold, so each run starts from a cloth with small random imperfections; the result is the mean over
them.

    .venv/bin/python examples/cusick/run.py [FOLDER] [--quick]      results go to FOLDER, default build/cusick
"""
import argparse
import math
import sys
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from look import moment, picture
from stage import ROOT, drape, last_row, scene_put

HERE = Path(__file__).resolve().parent
DISC, PLATE = 0.15, 0.09  # m, radii
PIXEL = 1e-4  # m, of the shadow
RESIDUAL, AGREE = 1e-5, 0.03  # of a fit at rest; of the means of two meshes


def shadow(cloth):
    """m2 of the plane z = 0 under the cloth's polygons, counted in pixels of 0.1 mm."""
    size = round(2.2 * DISC / PIXEL)
    image = Image.new("1", (size, size))
    draw = ImageDraw.Draw(image)
    points = cloth.points[:, :2] / PIXEL + size / 2
    for face in cloth.irregular_faces:
        draw.polygon([tuple(points[k]) for k in face], fill=1)
    return np.count_nonzero(np.asarray(image)) * PIXEL**2


def coefficient(cloth):
    return (shadow(cloth) - math.pi * PLATE**2) / (math.pi * (DISC**2 - PLATE**2))


def fold_count(cloth):
    """Bulges of the rim, seen from above."""
    rim = cloth.points[np.linalg.norm(cloth.points, axis=1) > 0]
    angle, radius = np.arctan2(rim[:, 1], rim[:, 0]), np.hypot(rim[:, 0], rim[:, 1])
    bins = np.linspace(-math.pi, math.pi, 121)
    farthest = np.array([radius[(angle >= a) & (angle < b)].max(initial=PLATE) for a, b in zip(bins, bins[1:])])
    smooth = np.real(np.fft.ifft(np.where(abs(np.fft.fftfreq(120, 1 / 120)) < 20, np.fft.fft(farthest), 0)))
    return int(np.sum((smooth > np.roll(smooth, 1)) & (smooth >= np.roll(smooth, -1))))


def rings(cell):
    """Points that hold the cloth between the plates: circles a cell apart from the plates' rim inwards, their points likewise. So
    the rim is round, whatever the grid; all nodes within it would be a staircase, and the overhang wrong by up to a cell."""
    points = []
    for k in range(int(PLATE / cell)):
        radius = PLATE - k * cell
        count = max(round(2 * math.pi * radius / cell), 1)
        points += [[radius * math.cos(2 * math.pi * j / count), radius * math.sin(2 * math.pi * j / count)] for j in range(count)]
    return points


def run(folder, cell, seed):
    scene = scene_put(folder, HERE / "scene.toml", cell=cell, at=rings(cell), imperfection=f"{{ amplitude = 0.0002, seed = {seed} }}")
    drape("run", scene, "-o", folder / "run", "--every", 0.5, "--frames", allowed=(0, 2))
    return moment(folder / "run"), last_row(folder / "run")["fit.residual"] <= RESIDUAL


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, nargs="?", default=ROOT / "build" / "cusick")
    parser.add_argument("--quick", action="store_true", help="coarse cells, two seeds")
    options = parser.parse_args()
    cells, seeds = ((0.015,), (1, 2)) if options.quick else ((0.0075, 0.005), (1, 2, 3, 4, 5))
    means = []
    for cell in cells:
        found = []
        for seed in seeds:
            now, at_rest = run(options.folder / f"{1e3 * cell:g}mm_{seed}", cell, seed)
            found.append(coefficient(now.cloth))
            print(f"cell {1e3 * cell:4.1f} mm, seed {seed}: drape coefficient {100 * found[-1]:.1f} %, {fold_count(now.cloth)} folds, "
                  f"{'at rest' if at_rest else 'NOT at rest'} after {now.time:g} s", flush=True)
            assert at_rest
        means.append(np.mean(found))
        print(f"cell {1e3 * cell:4.1f} mm: mean {100 * means[-1]:.2f} %, standard deviation {100 * np.std(found, ddof=1):.2f} %")
    picture(options.folder / f"{1e3 * cells[-1]:g}mm_1" / "run", options.folder / "cusick.png", field="tension_warp", views=["front", "top"], up="z")
    assert all(0 < mean < 1 for mean in means), "a shadow smaller than the plate or larger than the disc"
    if len(means) > 1:
        print(f"the means differ by {100 * abs(means[1] - means[0]):.2f} points, {100 * abs(means[1] / means[0] - 1):.1f} % of the coarser one's")
        assert abs(means[1] - means[0]) < AGREE, "the meshes do not agree"


if __name__ == "__main__":
    main()
