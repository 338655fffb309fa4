// Signed distance of a link or a cell of the cloth from a sharp edge or a tip of a body.
//
//   D = sum W_k r_k - c is normal to both,  n = +-D/|D| with -n.f > 0 for all directions f in which the body
//   falls away,  d = D.n. Below 0 the cloth has sunk past the feature, and n still points out of the body.
//
//          n
//      --__|__--   link        The link is over the edge where -n.f >= sine for both faces. Elsewhere the
//        / o \     edge        particles at its ends are as near: they bear it, and a pair only stops it.
//
// So it is with a face that goes on to the end of the link. A narrow face ends before: no particle is over
// it,
//
//      --.__n__.--             and a link that lies on it rests on both of its edges. It is over each of them
//        |     |               until it is steep there: -n.f >= -0.5. The farther edge bears what its own
//        |_____|               depth gives.
#pragma once
#include "body/sharp_edges.h"

namespace drape::contact {

struct EdgeGap {
  double clearance = 0;  // m, distance without a sign
  bool over = false;     // a local minimum of the distance; the rest is set only then
  double distance = 0;   // d, m
  double inside = 0;     // m, how deep the body is below the feature: deeper, the cloth is beyond the body
  double share = 0;      // of the penalty, 0 to 1; over (sum |W_k|)^2
  Vec3 n{0, 0, 0};
  double weight[4]{};  // W
};

// `sine`: the smallest that counts. `end` [2], in the frame of the body.
EdgeGap gap_link_edge(const body::SharpFeature& edge, const Vec3* end, double sine);

// `beyond` [cells]: the nodes across the one or two cells of the link, opposite to its ends.
EdgeGap gap_link_tip(const body::SharpFeature& tip, const Vec3* end, const Vec3 (*beyond)[2], int cells,
                     double sine);

// The cell is the bilinear surface of its corners a, b, c, d [4].
EdgeGap gap_cell_tip(const body::SharpFeature& tip, const Vec3* corner, double sine);

// A twisted cell may dip below an edge that both of its links pass over: the lowest place in its interior. No
// penalty acts there, only the stop.
EdgeGap gap_cell_edge(const body::SharpFeature& edge, const Vec3* corner, double sine);

}  // namespace drape::contact
