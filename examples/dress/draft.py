"""Drafts a sleeveless sheath dress for a body, and the dress form to put it on.

Front and back in one from the shoulders to the hem, with a bust dart in the side seam. The bodice is the close fitting bodice
block of W. Aldrich, Metric Pattern Cutting for Women's Wear, 5th ed., 2008: half the bust + 5 cm wide; armscye depth + 0.5 cm
below the nape; neck widths of a fifth of the neck - 0.2 cm in the back and - 0.7 cm in the front, 1.5 cm above the nape;
shoulders that end a fifth of the armscye depth - 0.7 cm below it, in front 1.5 cm lower; half the back width + 0.5 cm; half the
chest and half the dart, of which the middle is the bust point, 2.5 cm below the armscye. The shoulder dart of its back is left
out, that of its front is closed and opened in the side seam. The skirt is half the hips + 2.5 cm wide and hangs straight; the
side seam is taken in by 2.5 cm at the waist.

    .venv/bin/python examples/dress/draft.py [--bust M ...] [-o FOLDER]      writes dress.toml and form.obj
"""
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "drafting"))
from measures import command_line, measures_of
from pattern import ROOT, Garment, Half, Piece, write

ABOVE_NAPE = 0.015  # m, of the points of the neck
DART_BELOW = 0.06  # m, of the side dart below the armscye, along the side seam
DART_SHORT = 0.025  # m, of its tip before the bust point
TAKEN_IN = 0.025  # m, at the waist


def toward(p, q, length):
    """From p, `length` towards q."""
    share = length / math.dist(p, q)
    return (p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1]))


def turned(p, centre, angle):
    c, s, x, y = math.cos(angle), math.sin(angle), p[0] - centre[0], p[1] - centre[1]
    return (centre[0] + c * x - s * y, centre[1] + s * x + c * y)


def shoulder_end(neck, level, length):
    """At the height `level`, as far from the neck as the shoulder is long."""
    return (neck[0] + math.sqrt(length**2 - (neck[1] - level) ** 2), level)


def armscye(start, end, width):
    """Control points of the cubic from underarm to shoulder that comes up along the width of the chest or the back."""
    x, y = width - 0.01, start[1] + 0.45 * (end[1] - start[1])
    return [(start[0] - 0.75 * (start[0] - width), start[1]), (x, y)]


def skirt_side(half, waist, hip, length):
    """Hem and side, up to the waist."""
    hem, hip_level, waist_level = -waist["level"] - length, -waist["level"] - hip["below"], -waist["level"]
    half.line("hem", (hip["wide"], hem)).line("side", (hip["wide"], hip_level))
    x, y = waist["wide"], (hip_level + waist_level) / 2
    return half.curve("hip", [(hip["wide"], y), (x, y)], (x, waist_level))


def draft(measures, length):
    m = measures
    depth = m.armscye_depth + 0.005 - ABOVE_NAPE  # below the nape
    block = m.bust / 2 + 0.05
    back_wide, chest_wide = m.back_width / 2 + 0.005, (m.chest + m.dart) / 2
    side = (back_wide + block - chest_wide) / 2  # from the middle of the back
    levels = {"level": m.nape_to_waist}
    hip = {"below": m.waist_to_hip}
    hips = m.hips / 2 + 0.025

    def half_of(under):
        """From hem to waist, for a side seam at x = under."""
        half = Half((0, -m.nape_to_waist - length))
        wide = hips * under / block
        return skirt_side(half, levels | {"wide": min(under, wide) - TAKEN_IN}, hip | {"wide": wide}, length)

    # back
    neck = (m.neck / 5 - 0.002, ABOVE_NAPE)
    shoulder = shoulder_end(neck, -(m.armscye_depth / 5 - 0.007), m.shoulder)
    under = (side, -depth)
    back = half_of(side)
    notch = toward(under, back.points[-1], DART_BELOW)  # where the front has its dart
    back.line("side_lower", notch).line("side_upper", under)
    back.curve("armscye", armscye(under, shoulder, back_wide), shoulder).line("shoulder", neck)
    back.curve("neck", [(neck[0] * 0.6, 0)], (0, 0))

    # front: what is to the side of the dart turns about the bust point until the dart in the shoulder is closed
    neck = (m.neck / 5 - 0.007, ABOVE_NAPE)
    bust = (chest_wide / 2, -depth - 0.025)
    level = -(m.armscye_depth / 5 - 0.007) - 0.015
    opened = shoulder_end(neck, level, m.shoulder + m.dart)  # with the dart open
    leg = toward(neck, opened, m.dart)
    angle = math.atan2(leg[1] - bust[1], leg[0] - bust[0])
    angle = math.atan2(neck[1] - bust[1], neck[0] - bust[0]) - angle
    stretch = math.dist(neck, bust) / math.dist(leg, bust)  # both legs as long as the one at the neck
    leg = (bust[0] + stretch * (leg[0] - bust[0]), bust[1] + stretch * (leg[1] - bust[1]))
    shoulder = shoulder_end(leg, level, m.shoulder)
    under = (block - side, -depth)
    front = half_of(block - side)
    notch = toward(under, front.points[-1], DART_BELOW)
    tip_at = toward(bust, notch, DART_SHORT)
    spin = lambda p: turned(p, bust, angle)
    tip = turned(tip_at, bust, angle / 2)
    front.line("side_lower", notch).line("dart_in", tip).line("dart_out", spin(notch)).line("side_upper", spin(under))
    front.curve("armscye", [spin(p) for p in armscye(under, shoulder, chest_wide)], spin(shoulder)).line("shoulder", neck)
    low = ABOVE_NAPE - (m.neck / 5 - 0.002)
    front.curve("neck", [(neck[0] * 0.95, low + 0.01), (neck[0] * 0.5, low)], (0, low))

    nape = m.waist_to_floor + m.nape_to_waist
    dress = Garment("dress")
    front, back = dress.add(Piece("front", front), nape), dress.add(Piece("back", back, back=True), nape)
    for name in ("side", "hip", "side_lower", "side_upper", "shoulder"):
        dress.sew_both_sides(name, front, name, back, name)
    dress.sew_both_sides("dart", front, "dart_in", front, "dart_out")
    return dress


def main():
    parser = command_line(__doc__, ROOT / "build" / "dress")
    options = parser.parse_args()
    measures = measures_of(parser, options, longest=lambda m: m.waist_to_floor - 0.05)
    waist = measures.waist_to_floor
    write(draft(measures, options.length), measures, options, low=waist - options.length, high=waist + measures.nape_to_waist)


if __name__ == "__main__":
    main()
