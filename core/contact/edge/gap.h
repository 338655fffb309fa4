// How far a link or a cell of the cloth is from a ridge or a tip, signed by the body's outward side.
//
//   D = sum W_k r_k - c,  D across both,  n = +-D/|D| with -n.f > 0 for all f along which the body falls
//   away, d = D.n: below 0 the cloth has sunk past the ridge, and n still leads out.
//
//          n
//      --__|__--   link        over the ridge where -n.f >= sine for both faces: elsewhere particles at the
//        / o \     ridge       link's ends are as near
#pragma once
#include "body/sharp_edges.h"

namespace drape::contact {

struct EdgeGap {
  double clearance = 0;  // m, of the two from each other, without a sign
  bool over = false;     // a local minimum of the distance; what follows is only then set
  double distance = 0;   // d, m
  double inside = 0;     // m, by which the body falls away below it: deeper, the cloth is beyond the body
  double share = 0;      // of the penalty: from 0 where it begins to be one to 1 at twice the sine, over
                         // (sum |W_k|)^2
  Vec3 n{0, 0, 0};
  double weight[4]{};  // W
};

// `sine`: from which on it counts.
EdgeGap gap_link_edge(const body::SharpFeature& edge, const Vec3* end, double sine);

// The cells on either side of the link continue to the points `beyond`, across from its ends; `cells` of
// them.
EdgeGap gap_link_tip(const body::SharpFeature& tip, const Vec3* end, const Vec3 (*beyond)[2], int cells,
                     double sine);

// The cell is the bilinear surface of its corners a, b, c, d.
EdgeGap gap_cell_tip(const body::SharpFeature& tip, const Vec3* corner, double sine);

}  // namespace drape::contact
