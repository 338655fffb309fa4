"""The README's plot from a table of `drape bench kernel`: particle-steps per second against particles.

    .venv/bin/python tests/bench/plot.py tests/bench/results/epyc_zen5.csv tests/bench/results/epyc_zen5.svg
"""
import csv
import os
import sys

os.environ.setdefault("MPLBACKEND", "Agg")
from matplotlib import pyplot, ticker  # noqa: E402

COLOURS = {"stretch and shear": "#2d5f8a", "with hinges": "#c05a1c", "full model": "#4c7f3a"}
STYLES = {"avx512": "-", "avx2": "--", "portable": ":"}


def curves(file):
    """{(laws, kernel): ([particles], [million particle-steps per second])}"""
    found = {}
    with open(file, newline="") as table:
        for row in csv.DictReader(table):
            laws = row["name"].split(",")[0]
            if row["group"] == "kernel" and row["kernel"] in STYLES:
                x, y = found.setdefault((laws, row["kernel"]), ([], []))
                x.append(int(row["particles"]))
                y.append(float(row["million_particle_steps_per_s"]))
    return found


def main(file, picture):
    pyplot.rcParams["svg.hashsalt"] = "drape"  # the same file from the same table
    figure, axes = pyplot.subplots(figsize=(7, 4), constrained_layout=True)
    for (laws, kernel), (x, y) in curves(file).items():
        axes.plot(x, y, STYLES[kernel], color=COLOURS[laws], marker="o", markersize=4, label=f"{laws}, {kernel}")
    axes.set(xscale="log", yscale="log", xlabel="particles", ylabel="million particle-steps per second, one core")
    axes.set_yticks([20, 50, 100, 200, 500], labels=["20", "50", "100", "200", "500"])
    axes.yaxis.set_minor_formatter(ticker.NullFormatter())
    axes.grid(which="both", color="#dddddd", linewidth=0.5)
    axes.legend(fontsize=8, ncols=3, loc="upper center", bbox_to_anchor=(0.5, 1.22), frameon=False)
    figure.savefig(picture, metadata={"Date": None})


if __name__ == "__main__":
    main(*sys.argv[1:])
