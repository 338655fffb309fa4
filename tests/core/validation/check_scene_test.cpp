// Faults that involve several keys: outlines, cells, pins, probes; and the fabric file with its diagrams.
#include "fault_case.h"

namespace drape::validation {

using namespace tests;
namespace {

// ---- Geometry

const std::string kOutline = "[[0, 0], [0.4, 0], [0.4, 0.6], [0, 0.6]]";

class GeometryFault : public testing::TestWithParam<Case> {};

TEST_P(GeometryFault, GivesItsMessages) { EXPECT_EQ(scene_fault(GetParam()), GetParam().messages); }

const Case kGeometry[] = {
    {"crossed",
     kOutline,
     "[[0, 0], [0.4, 0.6], [0.4, 0], [0, 0.6]]",
     {"scene.toml:22: piece.sheet.outline is no simple outline: edge 0 crosses edge 2 at [0.2, 0.3] m"}},
    {"corner_twice",
     kOutline,
     "[[0, 0], [0.4, 0], [0.4, 0.6], [0.2, 0.3], [0.2, 0], [0, 0.6]]",
     {"scene.toml:22: piece.sheet.outline is no simple outline: edge 0 touches edge 3 at [0.2, 0] m",
      "scene.toml:22: piece.sheet.outline is no simple outline: edge 0 touches edge 4 at [0.2, 0] m"}},
    {"closed_by_hand",
     kOutline,
     "[[0, 0], [0.4, 0], [0.4, 0.6], [0, 0.6], [0, 0]]",
     {"scene.toml:22: piece.sheet.outline repeats its first point at the end; an outline closes by itself"}},
    {"no_area",
     kOutline,
     "[[0, 0], [0.4, 0], [0.2, 0]]",
     {"scene.toml:22: piece.sheet.outline encloses no area"}},
    {"cell_too_large",
     "cell = 0.01",
     "cell = 0.41",
     {"scene.toml:21: piece.sheet.cell = 0.41 m; allowed: at most the piece's shorter side, 0.4 m"}},
    {"too_many_nodes",
     "cell = 0.01",
     "cell = 1e-4",
     {"scene.toml:21: piece.sheet.cell = 0.0001 m makes about 2.401e+07 nodes; allowed: at most 4e+06 a "
      "piece"}},
    {"edge_out_of_range",
     "edges = [2]",
     "edges = [2, 4]",
     {"scene.toml:28: pin.bar.edges[1] = 4; allowed: 0 to 3 (edge i runs from point i of the outline to the "
      "next)"}},
    {"edge_before_the_first",
     "edges = [2]",
     "edges = [-1]",
     {"scene.toml:28: pin.bar.edges[0] = -1; allowed: 0 to 3 (edge i runs from point i of the outline to the "
      "next)"}},
    {"pin_off_the_piece",
     "at = [[0.1, 0.1], [0.2, 0.1]]",
     "at = [[0.1, 0.1], [0.43, -0.04]]",
     {"scene.toml:33: pin.tip.at[1] = [0.43, -0.04] m lies 0.05 m off the piece \"sheet\""}},
    {"probe_off_the_piece",
     "at = [0.2, 0]",
     "at = [0.2, -1e-8]",
     {"scene.toml:37: probe.hem.at = [0.2, -1e-08] m lies 1e-08 m off the piece \"sheet\""}},
    {"pin_of_nothing",
     "edges = [2]\n",
     "",
     {"scene.toml:25: pin.bar holds nothing; wanted: at, edges or region"}},
    {"pin_of_both",
     "edges = [2]",
     "edges = [2]\nat = [[0, 0]]",
     {"scene.toml:25: pin.bar has more than one of at, edges and region; wanted: one of them"}},
    {"pins_clash_on_an_edge",
     "at = [[0.1, 0.1], [0.2, 0.1]]",
     "at = [[0.1, 0.1], [0.123, 0.6]]",
     {"scene.toml:30: pin.tip and pin.bar both hold the point [0.123, 0.6] m of the piece \"sheet\"; a point "
      "belongs to one "
      "pin"}},
    {"pins_clash_in_a_corner",
     "at = [[0.1, 0.1], [0.2, 0.1]]",
     "edges = [3]",
     {"scene.toml:30: pin.tip and pin.bar both hold the point [0, 0.6] m of the piece \"sheet\"; a point "
      "belongs to one pin"}},
};

INSTANTIATE_TEST_SUITE_P(Geometry, GeometryFault, testing::ValuesIn(kGeometry), name_of);

// ---- The fabric file: diagrams and the keys that they need

class FabricFault : public testing::TestWithParam<Case> {};

TEST_P(FabricFault, GivesItsMessages) {
  const SceneFolder folder;
  folder.write("wool.toml", edited(kFabric, GetParam()));
  std::string scene = kScene;
  const std::string overrides = "areal_density = 0.2\nwarp.force = [0, 3, 9]\n",
                    loose = "clamp_correction = false";
  scene.erase(scene.find(overrides), overrides.size());
  scene.replace(scene.find(loose), loose.size(), "bias_model = \"odd\"");
  scene.erase(scene.find("bias_model = \"tension\"\n"), 23);
  EXPECT_EQ(messages_of(folder, folder.write("scene.toml", scene)), GetParam().messages);
}

const Case kFabrics[] = {
    {"unknown_key",
     "thickness",
     "thikness",
     {"scene.toml:13: fabric.wool.thickness is missing; wanted: a number in m",
      "wool.toml:4: fabric.wool.thikness is no known key; the nearest is \"thickness\""}},
    {"key_with_a_dot",
     "[warp]",
     "\"warp.force\" = 1\n[warp]",
     {"wool.toml:9: fabric.wool.\"warp.force\" is no known key; known: file, description, source, "
      "areal_density, thickness, strip, bending, compression, compression_blend, friction, damping, warp, "
      "weft, bias, calibration, kes, fast"}},
    {"negative_density",
     "areal_density = 0.15",
     "areal_density = -0.15",
     {"wool.toml:3: fabric.wool.areal_density = -0.15 kg/m^2; allowed: from 0.0001 to 100 kg/m^2"}},
    {"names_another_file",
     "source = \"nowhere\"",
     "file = \"more.toml\"",
     {"wool.toml:2: fabric.wool.file stands in a fabric file; a fabric file cannot name another one"}},
    {"empty", "", "", {"scene.toml:14: fabric.wool.file = \"wool.toml\": is empty (looked for wool.toml)"}},
    {"rigidity_of_one",
     "[1370, 900]",
     "[1370]",
     {"wool.toml:8: fabric.wool.bending.rigidity_uN_cm2 has 1 entry; wanted: a list of two numbers in uN "
      "cm^2"}},
    {"poisson_of_one",
     "poisson = 0.3",
     "poisson = 1.0",
     {"wool.toml:8: fabric.wool.bending.poisson = 1; allowed: from 0 to 0.999"}},
    {"force_falls",
     "[0, 2, 7]",
     "[0, 7, 2]",
     {"wool.toml:11: fabric.wool.warp.force[2] = 2 N after 7 N; the force of a diagram does not fall: `drape "
      "fabric smooth` makes a diagram of a tester's samples"}},
    {"force_starts_high",
     "[0, 2, 7]",
     "[1, 2, 7]",
     {"wool.toml:11: fabric.wool.warp.force[0] = 1 N; a diagram starts at 0 N: subtract a pretension from "
      "all its forces, or let `drape fabric smooth` do so"}},
    {"force_is_noisy",
     "[0, 2, 7]",
     "[0, 5, 4, 3, 2, 1]",
     {"wool.toml:11: fabric.wool.warp.force has 6 entries, elongation_percent has 3; wanted: as many",
      "wool.toml:11: fabric.wool.warp.force[2] = 4 N after 5 N, and so at 3 more points; the force of a "
      "diagram does not fall: `drape fabric smooth` makes a diagram of a tester's samples"}},
    {"force_is_negative_noise",
     "[0, 2, 7]",
     "[0, -1, -2, -3, -4]",
     {"wool.toml:11: fabric.wool.warp.force[1] = -1 N; allowed: from 0 to 1e+06 N; 3 more entries are not "
      "allowed either"}},
    {"samples_too_few",
     "force = [0, 2, 7]",
     "force = [0, 2, 7]\nraw = { elongation_percent = [0, 1], force = [0, -0.1] }",
     {"wool.toml:12: fabric.wool.warp.raw.elongation_percent has 2 entries; allowed: 3 to 100000"}},
    {"samples_of_two_lengths",
     "force = [0, 2, 7]",
     "force = [0, 2, 7]\nraw = { elongation_percent = [0, 1, 2], force = [0, -0.1, 3, 4] }",
     {"wool.toml:12: fabric.wool.warp.raw.force has 4 entries, elongation_percent has 3; wanted: as many"}},
    {"samples_without_a_force",
     "force = [0, 2, 7]",
     "force = [0, 2, 7]\nraw = { elongation_percent = [0, 1, 2] }",
     {"wool.toml:12: fabric.wool.warp.raw.force is missing; wanted: a list of numbers in N"}},
    {"samples_are_no_table",
     "force = [0, 2, 7]",
     "force = [0, 2, 7]\nraw = [0, 1]",
     {"wool.toml:12: fabric.wool.warp.raw is a list; wanted: a table"}},
    {"samples_are_kept",
     "force = [0, 2, 7]",
     "force = [0, 2, 7]\nraw = { extension_mm = [0, 2, 1], force_cN = [5, -10, 700] }",
     {}},
    {"elongation_starts_high",
     "[0, 1, 2.5]",
     "[0.5, 1, 2.5]",
     {"wool.toml:10: fabric.wool.warp.elongation_percent[0] = 0.5 percent; a diagram starts at 0 percent"}},
    {"elongation_rests",
     "[0, 1, 2.5]",
     "[0, 1, 1]",
     {"wool.toml:10: fabric.wool.warp.elongation_percent[2] = 1 percent after 1 percent; wanted: a rise of "
      "at least "
      "1e-06 percent"}},
    {"force_too_short",
     "[0, 2, 7]",
     "[0, 2]",
     {"wool.toml:11: fabric.wool.warp.force has 2 entries, elongation_percent has 3; wanted: as many"}},
    {"correction_too_long",
     "[1, 0.9, 0.95]",
     "[1, 0.9, 0.95, 1]",
     {"wool.toml:12: fabric.wool.warp.correction has 4 entries, elongation_percent has 3; wanted: as many"}},
    {"correction_lets_the_law_fall",
     "[1, 0.9, 0.95]",
     "[1, 0.9, 0.25]",
     {"wool.toml:12: fabric.wool.warp.correction[2] = 0.25 gives 1.75 N after 1.8 N; force x correction does "
      "not fall"}},
    {"correction_of_elongations_alone",
     "correction = [1, 0.9, 0.95]",
     "correction_elongation = [1, 1.1, 1.1]",
     {"wool.toml:12: fabric.wool.warp.correction_elongation stands without correction; wanted: both or "
      "neither"}},
    {"correction_lets_the_elongations_fall",
     "[1, 0.9, 0.95]",
     "[1, 0.9, 0.95]\ncorrection_elongation = [1, 4, 1]",
     {"wool.toml:13: fabric.wool.warp.correction_elongation[2] = 1 gives 2.5 percent after 4 percent; "
      "wanted: "
      "elongation x correction_elongation rises"}},
    {"jaws_is_no_flag",
     "[bias]",
     "[bias]\njaws = 0",
     {"wool.toml:17: fabric.wool.bias.jaws is a whole number; wanted: true or false"}},
    {"calibration_without_a_date",
     "[bias]",
     "[calibration]\ncell = 0.01\nresidual = 0\n[bias]",
     {"wool.toml:16: fabric.wool.calibration.date is missing; wanted: a text"}},
    {"correction_zero",
     "[1, 0.9, 0.95]",
     "[1, 0, 0.95]",
     {"wool.toml:12: fabric.wool.warp.correction[1] = 0; allowed: from 0.001 to 1000"}},
    {"one_point",
     "elongation_percent = [0, 4]\nforce = [0, 5]",
     "elongation_percent = [0]\nforce = [0]",
     {"wool.toml:14: fabric.wool.weft.elongation_percent has 1 entry; allowed: 2 to 64"}},
    {"strip_too_wide",
     "gauge = 0.1 ",
     "gauge = 0.0625 ",
     {"wool.toml:7: fabric.wool.strip has gauge/width = 1.25; the clamp correction of a bias diagram takes "
      "values above 1.25 "
      "(or say bias.jaws = false of a diagram without jaws)"}},
    {"bias_beyond_locking",
     "[0, 3, 6]",
     "[0, 41.5, 50]",
     {"wool.toml:17: fabric.wool.bias.elongation_percent[1] = 41.5 percent; bias_model \"odd\" takes at "
      "least one "
      "point above 0 and below 41.42 percent, where the threads of a strip lie along the pull"}},
};

INSTANTIATE_TEST_SUITE_P(Fabric, FabricFault, testing::ValuesIn(kFabrics), name_of);

}  // namespace
}  // namespace drape::validation
