"""Measures of a body: four that are taken, the others from a size table.

The table is that of W. Aldrich, Metric Pattern Cutting for Women's Wear, 5th ed., 2008 (standard body measurements, high
street fashion), size 12, in cm; girths and widths grow with the bust as they do from size to size there (4 cm of bust), lengths
with the height, of which size 12 has 166 cm.
"""
import argparse
from dataclasses import dataclass
from pathlib import Path

SIZE_BUST, SIZE_HEIGHT = 0.88, 1.66  # m, size 12
PER_BUST = {  # m at size 12, and per metre of bust
    "back_width": (0.344, 0.25),
    "chest": (0.324, 0.3),
    "shoulder": (0.1225, 0.0625),
    "neck": (0.37, 0.25),
    "dart": (0.07, 0.15),
    "armscye_depth": (0.21, 0.1),
}
PER_HEIGHT = {"nape_to_waist": 0.41, "waist_to_hip": 0.206, "waist_to_knee": 0.585, "waist_to_floor": 1.04}  # m at size 12
RANGES = {"bust": (0.7, 1.5), "waist": (0.5, 1.4), "hips": (0.7, 1.6), "height": (1.4, 2.0)}  # m, those of `drape form`


@dataclass
class Measures:
    bust: float = 0.88
    waist: float = 0.68
    hips: float = 0.94
    height: float = 1.66

    def __getattr__(self, name):
        if name in PER_BUST:
            size, growth = PER_BUST[name]
            return size + growth * (self.bust - SIZE_BUST)
        if name in PER_HEIGHT:
            return PER_HEIGHT[name] * self.height / SIZE_HEIGHT
        raise AttributeError(name)


def command_line(text, folder):
    """The options that all drafts share."""
    parser = argparse.ArgumentParser(description=text.splitlines()[0])
    for name in RANGES:
        parser.add_argument(f"--{name}", type=float, default=getattr(Measures, name), metavar="M", help="m (default: %(default)s)")
    parser.add_argument("--length", type=float, default=None, metavar="M", help="from waist to hem, m (default: to the knee)")
    parser.add_argument("--cell", type=float, default=0.01, metavar="M", help="cells of the cloth, m (default: %(default)s)")
    parser.add_argument("--weightless", action="store_true", help="sew it in the air, without a body")
    parser.add_argument("-o", "--output", type=Path, default=folder, help="folder for the scene and the form (default: %(default)s)")
    return parser


def measures_of(parser, options, longest):
    """The measures, or all that is wrong with them and exit code 1."""
    problems = []
    for name, (low, high) in (RANGES | {"cell": (0.002, 0.05)}).items():
        value = getattr(options, name)
        if not low <= value <= high:
            problems.append(f"--{name} = {value:g} m; allowed: {low:g} to {high:g} m")
    measures = Measures(options.bust, options.waist, options.hips, options.height)
    if options.length is None:
        options.length = measures.waist_to_knee
    if not problems:
        shortest, most = measures.waist_to_hip + 0.05, longest(measures)
        if not shortest <= options.length <= most:
            problems.append(f"--length = {options.length:g} m; allowed: {shortest:.3f} m, below the hips, to {most:.3f} m")
        if not measures.waist < measures.hips:
            problems.append(f"--waist = {measures.waist:g} m; allowed: less than --hips, {measures.hips:g} m: it hangs from there")
    if problems:
        parser.exit(1, "".join(f"error: {problem}\n" for problem in problems))
    return measures
