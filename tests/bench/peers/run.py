"""Drape's laws in Numba and Taichi, and Newton's springs, against `drape bench peers`: side by side, in turn, medians.

    python3 tests/bench/peers/run.py [--quick] [--csv FILE]

Square cloth of N x N particles in cells b: weft, warp and diagonal links of width w pull with w k (l/b - 1); hinges along
both threads with kappa theta^2/2; leapfrog with gravity. Before it is measured, each peer swings a small cloth down from an
edge, and must end where `drape run` ends, to 1e-10 m. Numba comes twice: in plain loops over the links, as one writes them
first, and in rows, with Drape's own order of work, so that its compiler makes vectors of every loop. Newton has single
precision and its own springs (no hinges: it bends by springs over two cells), and no such check: its spring and integration
kernels are called alone. One core for all.
"""
import argparse
import csv
import os
import pathlib
import statistics
import sys
import time

from environment import run_in

SIDE = 129

if __name__ == "__main__":
    run_in("peers", "requirements.txt")

import numpy as np  # noqa: E402
from cloth import Cloth  # noqa: E402
from drape_side import drape_places, drape_rates  # noqa: E402
from newton_peer import NewtonPeer  # noqa: E402
from plain import PlainPeer  # noqa: E402
from rows import RowsPeer  # noqa: E402
from taichi_peer import taichi_peer  # noqa: E402


def check(peer_type, hinges, tolerance):
    n, steps = 17, 4000
    peer = peer_type(Cloth(n, held_edge=True), hinges)
    peer.steps(1, first=True)
    peer.steps(steps - 1)
    off = np.abs(peer.places() - drape_places(n, hinges, steps)).max()
    if not off <= tolerance:
        sys.exit(f"{peer.name} ends {off:.1e} m from drape run; allowed: {tolerance:g} m")
    return off


def rate_of(peer, seconds):
    count = 1
    while True:
        start = time.perf_counter()
        peer.steps(count)
        spent = time.perf_counter() - start
        if spent >= seconds / 4:
            return SIDE**2 * count / spent / 1e6
        count *= 2


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--quick", action="store_true", help="seconds in all, no figures to rely on")
    arguments.add_argument("--csv", type=pathlib.Path, help="also writes the rows to a file")
    options = arguments.parse_args()
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    turns, seconds = (1, 0.02) if options.quick else (7, 1.0)

    taichi_double = taichi_peer("double")
    checks = [(PlainPeer, False), (PlainPeer, True), (RowsPeer, False), (RowsPeer, True), (taichi_double, False)]
    for peer_type, hinges in checks:
        off = check(peer_type, hinges, 1e-10)
        print(f"{peer_type.name}{' with hinges' if hinges else ''}: within {off:.1e} m of drape run")

    groups = {
        "stretch and shear": [PlainPeer, RowsPeer, taichi_double, NewtonPeer],
        "with hinges": [PlainPeer, RowsPeer, NewtonPeer],
    }
    rows = []
    for law, types in groups.items():
        peers = [t(Cloth(SIDE, crumple=0.003), law == "with hinges") for t in types]
        for peer in peers:
            peer.steps(2)
        times = {law: [], **{p.name: [] for p in peers}}
        for _ in range(turns):
            times[law].append(drape_rates(options.quick)[law])
            for peer in peers:
                times[peer.name].append(rate_of(peer, seconds))
        medians = {name: statistics.median(values) for name, values in times.items()}
        for peer in peers:
            rows.append({"laws": law, "peer": peer.name, "drape": medians[law], "peer_rate": medians[peer.name],
                         "ratio": medians[law] / medians[peer.name]})
            print("{laws:20} drape {drape:7.1f}   {peer:26} {peer_rate:7.2f} million/s   {ratio:6.1f} x".format(**rows[-1]))
    if options.csv:
        with open(options.csv, "w", newline="") as file:
            table = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
            table.writeheader()
            table.writerows([{k: f"{v:.6g}" if isinstance(v, float) else v for k, v in row.items()} for row in rows])


if __name__ == "__main__":
    main()
