"""Drafts a straight skirt with a waistband for a body, and the dress form to put it on.

The skirt block of W. Aldrich, Metric Pattern Cutting for Women's Wear, 5th ed., 2008 (tailored skirt): half the hips + 1.5 cm
wide, of which a quarter of the hips + 1.5 cm are the back. The waist is a quarter of the waist + 4.25 cm in the back, with two
darts of 2 cm (14 and 12.5 cm long), and + 2.25 cm in the front, with one of 2 cm (10 cm long); it rises by 1.25 cm to the side.
The waistband is as long as what it is sewn to.

    .venv/bin/python examples/skirt/draft.py [--waist M ...] [-o FOLDER]      writes skirt.toml and form.obj
"""
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "drafting"))
from measures import command_line, measures_of
from pattern import ROOT, Garment, Half, Piece, dart, write

RISE = 0.0125  # m, of the waist towards the side
BULGE = 0.005  # m, of the side seam between waist and hips
BAND = 0.03  # m
DART = 0.02  # m, width


def panel(waist, hip, darts, measures, length):
    """Half a panel: hem, side, and the waist from the side to the middle, with darts (share of the distance from the middle, length).
    And the lengths of the stretches of its waist, from the side."""
    half = Half((0, -length)).line("hem", (hip, -length)).line("side", (hip, -measures.waist_to_hip))
    x, y = (waist + hip) / 2, (RISE - measures.waist_to_hip) / 2
    dx, dy = hip - waist, RISE + measures.waist_to_hip
    out = 2 * BULGE / math.hypot(dx, dy)
    half.curve("hip", [(x + out * dy, y + out * dx)], (waist, RISE))
    size = math.hypot(waist, RISE)
    along, across = (-waist / size, -RISE / size), (RISE / size, -waist / size)
    for k, (share, depth) in enumerate(sorted(darts, reverse=True)):
        middle = (share * waist, share * RISE)
        half.line(f"waist_{k}", (middle[0] - DART / 2 * along[0], middle[1] - DART / 2 * along[1]))
        dart(half, f"dart_{k}", middle, along, across, DART, depth)
    half.line(f"waist_{len(darts)}", (0, 0))
    ends = [1.0, *(share for share, _ in sorted(darts, reverse=True)), 0.0]
    cut = [0, *([1] * len(darts)), 0]
    return half, [(a - b) * size - DART / 2 * (p + q) for a, b, p, q in zip(ends, ends[1:], cut, cut[1:])]


def band(stretches):
    """Half a waistband; its lower edge is divided as the waist is, from the side."""
    x, half = 0.0, Half((0, 0))
    for k, stretch in reversed(list(enumerate(stretches))):
        x += stretch
        half.line(f"waist_{k}", (x, 0))
    return half.line("end", (x, BAND)).line("top", (0, BAND))


def draft(measures, length):
    m = measures
    waist_height = m.waist_to_floor
    skirt = Garment("skirt")
    hip_back = m.hips / 4 + 0.015
    back_half, back_waist = panel(m.waist / 4 + 0.0425, hip_back, [(1 / 3, 0.14), (2 / 3, 0.125)], m, length)
    front_half, front_waist = panel(m.waist / 4 + 0.0225, m.hips / 2 + 0.015 - hip_back, [(2 / 3, 0.10)], m, length)
    front, back = skirt.add(Piece("front", front_half), waist_height), skirt.add(Piece("back", back_half, back=True), waist_height)
    level = waist_height + RISE + 0.005  # the band hangs just above
    band_front = skirt.add(Piece("band_front", band(front_waist)), level)
    band_back = skirt.add(Piece("band_back", band(back_waist), back=True), level)
    for name in ("side", "hip"):
        skirt.sew_both_sides(name, front, name, back, name)
    skirt.sew_both_sides("band_end", band_front, "end", band_back, "end")
    for panel_piece, its_band, stretches in ((front, band_front, front_waist), (back, band_back, back_waist)):
        for k in range(len(stretches)):
            skirt.sew_both_sides(f"waist_{panel_piece.name}_{k}", panel_piece, f"waist_{k}", its_band, f"waist_{k}")
        for k in range(len(stretches) - 1):
            skirt.sew_both_sides(f"dart_{panel_piece.name}_{k}", panel_piece, f"dart_{k}_in", panel_piece, f"dart_{k}_out")
    return skirt


def main():
    parser = command_line(__doc__, ROOT / "build" / "skirt")
    options = parser.parse_args()
    measures = measures_of(parser, options, longest=lambda m: m.waist_to_floor - 0.05)
    top = measures.waist_to_floor
    write(draft(measures, options.length), measures, options, low=top - options.length, high=top + 0.1)


if __name__ == "__main__":
    main()
