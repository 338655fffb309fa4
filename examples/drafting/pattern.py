"""Pieces drawn edge by edge, seams between named edges, and the scene that they make round a dress form."""
import math
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WOOL = ROOT / "examples" / "fabrics" / "wool.toml"
CLEARANCE = 0.02  # m, from the form to cloth that is wrapped round it
DART_SPEED = 4  # m/s: the points next to the tip of a dart have to fold a cell, for which those of other seams are too weak


def metres(*values):
    """Rounded to 10 nm: edges that are equally long stay so."""
    return "[" + ", ".join(f"{round(value, 8) + 0.0:.8f}".rstrip("0").rstrip(".") for value in values) + "]"


class Half:
    """The half of a symmetric piece on the side of positive x, from the middle of its lower edge to that of its upper edge."""

    def __init__(self, start):
        self.points, self.edges = [start], []

    def line(self, name, to):
        return self.curve(name, [], to)

    def curve(self, name, controls, to):
        """One control point: a quadratic Bezier curve, two: a cubic one."""
        self.points.append(to)
        self.edges.append((name, controls))
        return self


class Piece:
    """Both halves of a piece. Seen from outside, x goes to the left of who wears a front, and to the right in a back."""

    def __init__(self, name, half, back=False):
        self.name, self.back = name, back
        near, far = ("right", "left") if back else ("left", "right")
        self.points = half.points[:-1]
        self.edges = [(f"{edge}_{near}", controls) for edge, controls in half.edges]
        self.points += [(-x, y) for x, y in half.points[:0:-1]]
        self.edges += [(f"{edge}_{far}", [(-x, y) for x, y in controls[::-1]]) for edge, controls in half.edges[::-1]]

    def number(self, edge):
        return [name for name, _ in self.edges].index(edge)

    def text(self, cell, place):
        rows = "".join(f"  {metres(*point)},  # {k}: {self.edges[k][0]}\n" for k, point in enumerate(self.points))
        curves = "".join(f"  {{ edge = {k}, bezier = [{', '.join(metres(*point) for point in controls)}] }},\n"
                         for k, (_, controls) in enumerate(self.edges) if controls)
        curves = f"curves = [\n{curves}]\n" if curves else ""
        return f'\n[[piece]]\nname = "{self.name}"\nfabric = "wool"\ncell = {cell:g}  # m\noutline = [\n{rows}]\n{curves}place = {place}\n'


class Garment:
    def __init__(self, name):
        self.name, self.pieces, self.seams = name, [], []

    def add(self, piece, low):
        """A piece whose y = 0 comes to the height `low`."""
        self.pieces.append((piece, low))
        return piece

    def sew(self, name, a, edges_a, b, edges_b):
        """Edges that run against each other, as those of two pieces side by side do."""
        self.seams.append((name, a, [a.number(e) for e in edges_a], b, [b.number(e) for e in edges_b]))

    def sew_both_sides(self, name, a, edge_a, b, edge_b):
        for side in ("left", "right"):
            self.sew(f"{name}_{side}", a, [f"{edge_a}_{side}"], b, [f"{edge_b}_{side}"])

    def scene(self, folder, cell, ellipse, weightless):
        middle, radius = ellipse
        fabric = Path(os.path.relpath(WOOL, folder.resolve())).as_posix()
        gravity = 0 if weightless else -9.81
        text = f'[scene]\nname = "{self.name}"\nduration = 10\ngravity = [0, {gravity}, 0]\nmode = "fit"\n\n[fabric.wool]\nfile = "{fabric}"\n'
        if not weightless:
            text += '\n[[body]]\nname = "form"\nmesh = "form.obj"\n'
        for piece, low in self.pieces:
            out = -1 if piece.back else 1
            text += piece.text(cell, f"{{ origin = {metres(0, low, middle + out * radius[1])}, axis_x = [{out}, 0, 0], axis_y = [0, 1, 0], "
                                     f"cylinder = {{ axis_point = {metres(0, 0, middle)}, axis = [0, 1, 0], radius = {metres(*radius)} }} }}")
        for name, a, edges_a, b, edges_b in self.seams:
            speed = f"speed = {DART_SPEED}  # m/s\n" if a is b else ""
            text += f'\n[[seam]]\nname = "{name}"\n{speed}a = {{ piece = "{a.name}", edges = {edges_a} }}\nb = {{ piece = "{b.name}", edges = {edges_b}, reverse = true }}\n'
        return text


def dart(half, name, middle, along, across, width, length):
    """A dart from the edge that runs in the direction `along`: both legs, with the tip `length` across it."""
    (x, y), (ax, ay), (cx, cy) = middle, along, across
    half.line(f"{name}_in", (x + length * cx, y + length * cy))
    return half.line(f"{name}_out", (x + width / 2 * ax, y + width / 2 * ay))


def form_make(measures, file):
    """The dress form of the measures, and its vertices."""
    drape = ROOT / "build" / "drape"
    if not drape.exists():
        sys.exit(f"{drape} is missing: run `bash examples/quickstart.sh`")
    options = [f"--{name}={getattr(measures, name)}" for name in ("bust", "waist", "hips", "height")]
    subprocess.run([drape, "form", "-o", file, *options], check=True, stdout=subprocess.DEVNULL)
    return [tuple(map(float, line.split()[1:])) for line in file.read_text().splitlines() if line.startswith("v ")]


def ellipse_round(vertices, low, high):
    """Where the ellipse that goes round all of a form between two heights has its middle, along z, and its radii: those of the
    box round it, grown alike until all points are within, and CLEARANCE more."""
    slab = [(x, z) for x, y, z in vertices if low <= y <= high]
    middle = (max(z for _, z in slab) + min(z for _, z in slab)) / 2
    wide, deep = max(abs(x) for x, _ in slab), max(abs(z - middle) for _, z in slab)
    grown = max(math.hypot(x / wide, (z - middle) / deep) for x, z in slab)
    return middle, (wide * grown + CLEARANCE, deep * grown + CLEARANCE)


def write(garment, measures, options, low, high):
    """Form and scene into the folder of the options; the ellipse goes round the form from the height `low` to `high`."""
    folder = options.output
    folder.mkdir(parents=True, exist_ok=True)
    ellipse = ellipse_round(form_make(measures, folder / "form.obj"), low, high)
    file = folder / f"{garment.name}.toml"
    file.write_text(garment.scene(folder, options.cell, ellipse, options.weightless))
    print(file)
