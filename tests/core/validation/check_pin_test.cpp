// Faults of pins and probes on a cloth of any outline: modes, regions, points held twice, points off the
// cloth.
#include "fault_case.h"

namespace drape::validation {

using namespace tests;
namespace {

class PinFault : public testing::TestWithParam<Case> {};

TEST_P(PinFault, GivesItsMessages) { EXPECT_EQ(scene_fault(GetParam(), kCloth), GetParam().messages); }

const Case kPins[] = {
    {"hold",
     "\"clamp\"",
     "\"glue\"",
     {"scene.toml:36: pin.waist.hold = \"glue\"; allowed: \"point\", \"clamp\""}},
    {"drive",
     "\"velocity\"",
     "\"fast\"",
     {"scene.toml:37: pin.waist.drive = \"fast\"; allowed: \"position\", \"velocity\", \"both\""}},
    {"drive_as_flag",
     "\"velocity\"",
     "true",
     {"scene.toml:37: pin.waist.drive is true or false; wanted: \"position\", \"velocity\", \"both\""}},
    {"region_empty",
     "[[0.25, 0.05], [0.35, 0.05], [0.35, 0.15], [0.25, 0.15]]",
     "[]",
     {"scene.toml:41: pin.patch.region is an empty list; wanted: a list of points [[x, y], ...] in m"}},
    {"region_flat",
     "[[0.25, 0.05], [0.35, 0.05], [0.35, 0.15], [0.25, 0.15]]",
     "[0.25, 0.05]",
     {"scene.toml:41: pin.patch.region is a flat list; wanted: a list of points [[x, y], ...] in m"}},
    {"region_of_two",
     ", [0.35, 0.15], [0.25, 0.15]]",
     "]",
     {"scene.toml:41: pin.patch.region has 2 points; allowed: at least 3"}},
    {"region_crossed",
     "[0.35, 0.15], [0.25, 0.15]",
     "[0.25, 0.15], [0.35, 0.15]",
     {"scene.toml:41: pin.patch.region is no simple outline: edge 1 crosses edge 3 at [0.3, 0.1] m"}},
    {"region_without_end",
     "[0.25, 0.15]]",
     "[0.25, inf]]",
     {"scene.toml:41: pin.patch.region[3][1] = inf m; allowed: from -10000 to 10000 m"}},
    {"region_off_the_piece",
     "[[0.25, 0.05], [0.35, 0.05], [0.35, 0.15], [0.25, 0.15]]",
     "[[1, 1], [2, 1], [2, 2]]",
     {"scene.toml:41: pin.patch.region holds nothing: no particle of the piece \"skirt\" lies in it; its "
      "cells "
      "are 0.02 m"}},
    {"region_between_the_nodes",
     "[[0.25, 0.05], [0.35, 0.05], [0.35, 0.15], [0.25, 0.15]]",
     "[[0.25, 0.05], [0.251, 0.05], [0.251, 0.051]]",
     {"scene.toml:41: pin.patch.region holds nothing: no particle of the piece \"skirt\" lies in it; its "
      "cells "
      "are 0.02 m"}},
    {"region_and_edges",
     "edges = [2]",
     "edges = [2]\nregion = [[0, 0], [0.1, 0], [0, 0.1]]",
     {"scene.toml:32: pin.waist has more than one of at, edges and region; wanted: one of them",
      "scene.toml:44: pin.tip and pin.waist both hold the point [0.05, 0.05] m of the piece \"skirt\"; a "
      "point belongs to one pin"}},
    {"point_in_region",
     "[[0.05, 0.05]]",
     "[[0.3, 0.1]]",
     {"scene.toml:43: pin.tip and pin.patch both hold the point [0.3, 0.1] m of the piece \"skirt\"; a point "
      "belongs to one pin"}},
    {"region_over_edge",
     "[0.35, 0.15], [0.25, 0.15]]",
     "[0.35, 0.65], [0.25, 0.65]]",
     {"scene.toml:38: pin.patch and pin.waist both hold the point [0.35, 0.575] m of the piece \"skirt\"; a "
      "point belongs to one pin"}},
    {"regions_overlap",
     "at = [[0.05, 0.05]]",
     "region = [[0.22, 0.04], [0.3, 0.04], [0.3, 0.2]]",
     {"scene.toml:43: pin.tip and pin.patch both hold the point [0.25, 0.05] m of the piece \"skirt\"; a "
      "point belongs to one pin"}},
    {"regions_overlap_beyond_the_piece_only",
     "[0.35, 0.05], [0.35, 0.15], [0.25, 0.15]]\ndrive = \"both\"\n[[pin]]\nname = \"tip\"\npiece = "
     "\"skirt\"\nat = [[0.05, 0.05]]",
     "[2, 0.05], [2, 0.15], [0.25, 0.15]]\n[[pin]]\nname = \"tip\"\npiece = \"skirt\"\nregion = [[0.25, "
     "0.16], [2, 0.16], [2, 0.05], [3, 0.05], [3, 0.2], [0.25, 0.2]]",
     {}},
    {"edges_next_to_each_other",
     "at = [[0.05, 0.05]]",
     "edges = [3]",
     {"scene.toml:43: pin.tip and pin.waist both hold the point [0.2, 0.5] m of the piece \"skirt\"; a point "
      "belongs to one pin"}},
    {"point_on_a_curve",
     "[[0.05, 0.05]]",
     "[[0.01, 0.5]]",
     {"scene.toml:46: pin.tip.at[0] = [0.01, 0.5] m lies 0.0038631 m off the piece \"skirt\""}},
    {"point_off_a_curve",
     "[[0.05, 0.05]]",
     "[[0.01, 0.3]]",
     {"scene.toml:46: pin.tip.at[0] = [0.01, 0.3] m lies 0.0149998 m off the piece \"skirt\""}},
    {"point_in_a_hole",
     "[[0.05, 0.05]]",
     "[[0.26, 0.27]]",
     {"scene.toml:46: pin.tip.at[0] = [0.26, 0.27] m lies 0.01 m inside holes[1] of the piece \"skirt\""}},
    {"probe_in_a_hole",
     "at = [0.1, 0.3]",
     "at = [0.12, 0.12]",
     {"scene.toml:51: probe.hem.at = [0.12, 0.12] m lies 0.02 m inside holes[0] of the piece \"skirt\""}},
    {"probe_in_a_notch",
     "at = [0.1, 0.3]",
     "at = [0.2, 0.55]",
     {"scene.toml:51: probe.hem.at = [0.2, 0.55] m lies 0.0447214 m off the piece \"skirt\""}},
};

INSTANTIATE_TEST_SUITE_P(Pins, PinFault, testing::ValuesIn(kPins), name_of);

}  // namespace
}  // namespace drape::validation
