"""The work-precision diagram from a table of `drape bench precision`: error against seconds, one panel a scene.

    .venv/bin/python tests/bench/plot_precision.py precision.csv precision.svg
"""
import csv
import os
import sys

os.environ.setdefault("MPLBACKEND", "Agg")
from matplotlib import pyplot  # noqa: E402

# Colour by family; the darker, the higher the order. The forces of the reference are dotted.
FAMILIES = {
    "Drape": ("#c05a1c", "o"),
    "paper": ("#8a8a8a", "s"),
    "explicit Euler": ("#444444", "x"),
    "ERK": ("#2d5f8a", "^"),
    "DIRK": ("#4c7f3a", "v"),
    "IMEX": ("#7a4a9a", "D"),
    "Adams": ("#b09020", "<"),
    "Adams, Krylov": ("#d0b050", ">"),
    "BDF, Krylov": ("#a03050", "P"),
}
SHADE = {0: 1.0, 1: 1.0, 2: 0.4, 3: 0.5, 4: 0.7, 5: 0.8, 6: 1.0, 8: 1.0}


def sweeps(file):
    """{scene: {(method, forces, order): [(seconds, error)]}}"""
    found = {}
    with open(file, newline="") as table:
        for row in csv.DictReader(table):
            key = row["method"], row["forces"], int(row["order"])
            points = found.setdefault(row["scene"], {}).setdefault(key, [])
            points.append((float(row["seconds"]), float(row["error"])))
    return found


def panel(axes, scene, curves):
    for (method, forces, order), points in curves.items():
        colour, marker = FAMILIES[method]
        label = f"{method} {order}" if order and method not in ("paper", "explicit Euler") else method
        axes.plot(
            *zip(*points),
            ":" if forces == "judge" else "-",
            color=colour,
            alpha=SHADE[order],
            marker=marker,
            markersize=3.5,
            linewidth=2.2 if method == "Drape" else 0.9,
            label=label if forces == "kernel" else None,
        )
    axes.set(title=scene, xscale="log", yscale="log", ylim=(1e-11, 1), xlabel="seconds, one core")
    axes.grid(color="#dddddd", linewidth=0.5)


def main(file, picture):
    pyplot.rcParams["svg.hashsalt"] = "drape"  # the same file from the same table
    scenes = sweeps(file)
    figure, axes = pyplot.subplots(2, 2, figsize=(10, 9), constrained_layout=True)
    for where, (scene, curves) in zip(axes.flat, scenes.items()):
        panel(where, scene, curves)
    for row in axes:
        row[0].set_ylabel("relative error of position")
    labels = {}
    for where in axes.flat:
        for handle, label in zip(*where.get_legend_handles_labels()):
            labels.setdefault(label, handle)
    figure.legend(labels.values(), labels.keys(), ncols=6, fontsize=8, loc="outside lower center", frameon=False)
    figure.savefig(picture, metadata={"Date": None})


if __name__ == "__main__":
    main(*sys.argv[1:])
