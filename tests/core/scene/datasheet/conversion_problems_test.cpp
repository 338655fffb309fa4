// Faults of data sheets: one edit of a correct sheet, and the messages that it gives in the keys and units
// of the sheet.
#include <gtest/gtest.h>

#include "fault_case.h"

namespace drape::scene {

using namespace tests;
namespace {

const std::string kSceneText =
    "[scene]\nname = \"a\"\n[fabric.wool]\nfile = \"wool.toml\"\n"
    "[[piece]]\nname = \"p\"\nfabric = \"wool\"\ncell = 0.1\noutline = [[0, 0], [1, 0], [1, 1], [0, 1]]\n";

class DatasheetFault : public testing::TestWithParam<Case> {};

// The first letter of the name selects the sheet.
TEST_P(DatasheetFault, GivesItsMessages) {
  const SceneFolder folder;
  const char first = GetParam().name[0];
  const std::string& text = first == 'k' ? kKes : first == 'f' ? kFast : first == 's' ? kStrips : kPt2;
  folder.write("wool.toml", edited(text, GetParam()));
  EXPECT_EQ(messages_of(folder, folder.write("scene.toml", kSceneText)), GetParam().messages);
}

const Case kSheets[] = {
    {"kes_good", "W", "W", {}},
    {"kes_unknown",
     "EMT",
     "ENT",
     {"wool.toml:1: fabric.wool.kes.EMT is missing; wanted: a number in percent or a list of two, [warp, "
      "weft]",
      "wool.toml:5: fabric.wool.kes.ENT is no known key; the nearest is \"EMT\""}},
    {"kes_stray_keys_of_a_diagram",
     "[kes]",
     "bias.jaws = false\nwarp.correction = [1, 1]\n[kes]",
     {"wool.toml:1: fabric.wool.bias.jaws belongs to a diagram, but the bias comes from kes.G; wanted: "
      "bias.elongation_percent and bias.force beside it, or neither",
      "wool.toml:2: fabric.wool.warp.correction belongs to a diagram, but the warp comes from kes.EMT; "
      "wanted: "
      "warp.elongation_percent and warp.force beside it, or neither"}},
    {"kes_no_table",
     "",
     "kes = 5\n",
     {"scene.toml:3: fabric.wool.areal_density is missing; wanted: a number in kg/m^2",
      "scene.toml:3: fabric.wool.thickness is missing; wanted: a number in m",
      "wool.toml:1: fabric.wool.kes is a whole number; wanted: a table"}},
    {"kes_negative",
     "W = 24.5",
     "W = -24.5",
     {"wool.toml:2: fabric.wool.kes.W = -24.5 mg/cm^2; allowed: from 0.01 to 10000 mg/cm^2"}},
    {"kes_text",
     "G = [0.5, 0.6]",
     "G = \"0.5\"",
     {"wool.toml:8: fabric.wool.kes.G is a text; wanted: a number in gf/(cm deg) or a list of two, [warp, "
      "weft]"}},
    {"kes_of_three",
     "B = [0.09, 0.07]",
     "B = [0.09, 0.07, 0.08]",
     {"wool.toml:9: fabric.wool.kes.B has 3 entries; wanted: a number in gf cm^2/cm or a list of two, [warp, "
      "weft]"}},
    {"kes_nan",
     "B = [0.09, 0.07]",
     "B = [0.09, nan]",
     {"wool.toml:9: fabric.wool.kes.B[1] = nan gf cm^2/cm; allowed: from 0 to 1000 gf cm^2/cm"}},
    {"kes_work_too_large",
     "WT = [9.400, 8.675]\nLT = [0.655, 0.676]",
     "WT = [9.4, 86.75]",
     {"wool.toml:6: fabric.wool.kes.WT[1] = 86.75 gf cm/cm^2 does not go with EMT = 5.135 percent at 500 "
      "gf/cm; allowed: from 2.5675 to 23.1075 gf cm/cm^2, for LT = 2 WT/(Fm EMT) from 0.2 to 1.8"}},
    {"kes_linearity_off",
     "LT = [0.655, 0.676]",
     "LT = [0.5, 0.676]",
     {"wool.toml:7: fabric.wool.kes.LT[0] = 0.5 does not go with WT and EMT, which give LT = 2 WT/(Fm EMT) = "
      "0.655623; allowed: within 5 percent of it"}},
    {"kes_linearity_out_of_range",
     "LT = [0.655, 0.676]",
     "LT = 2",
     {"wool.toml:7: fabric.wool.kes.LT = 2; allowed: from 0.2 to 1.8"}},
    {"kes_no_extension",
     "EMT = [5.735, 5.135]\n",
     "",
     {"wool.toml:1: fabric.wool.kes.EMT is missing; wanted: a number in percent or a list of two, [warp, "
      "weft]"}},
    {"kes_no_work",
     "WT = [9.400, 8.675]\nLT = [0.655, 0.676]\n",
     "",
     {"wool.toml:1: fabric.wool.kes.WT is missing; wanted: a number in gf cm/cm^2 or a list of two, [warp, "
      "weft]"}},
    {"kes_no_thickness",
     "T0 = 0.62\n",
     "",
     {"scene.toml:3: fabric.wool.thickness is missing; wanted: a number in m"}},
    {"kes_all_twice",
     "[kes]",
     "areal_density = 0.245\nthickness = 0.00062\nbending = { rigidity_uN_cm2 = [1, 1] }\nwarp = { "
     "elongation_percent = [0, 1], force = [0, 1] }\nbias = { elongation_percent = [0, 1], force = [0, 1] "
     "}\n[kes]",
     {"wool.toml:7: fabric.wool.kes.W states the areal density, as areal_density does; wanted: one of them",
      "wool.toml:8: fabric.wool.kes.T0 states the thickness, as thickness does; wanted: one of them",
      "wool.toml:10: fabric.wool.kes.EMT states the warp tension, as warp does; wanted: one of them",
      "wool.toml:13: fabric.wool.kes.G states the shear, as bias does; wanted: one of them",
      ("wool.toml:14: fabric.wool.kes.B states the bending rigidity, as bending.rigidity_uN_cm2 does; "
       "wanted: "
       "one of them")}},
    {"kes_and_fast",
     "[kes]",
     "[fast]\nW = 245\nEB5 = 5\nC = 15\n[kes]",
     {"wool.toml:2: fabric.wool.fast.W states the areal density, as kes.W does; wanted: one of them",
      "wool.toml:3: fabric.wool.fast.EB5 states the shear, as kes.G does; wanted: one of them",
      "wool.toml:4: fabric.wool.fast.C states the bending rigidity, as kes.B does; wanted: one of them"}},
    {"kes_and_width",
     "[kes]",
     "bending = { width = 0.02 }\n[kes]",
     {"wool.toml:1: fabric.wool.bending.width belongs to bending.rigidity_uN_cm2, not to kes.B"}},
    {"kes_one_number_for_both",
     "EMT = [5.735, 5.135]\nWT = [9.400, 8.675]\nLT = [0.655, 0.676]",
     "EMT = 5\nWT = 25",
     {"wool.toml:6: fabric.wool.kes.WT = 25 gf cm/cm^2 does not go with EMT = 5 percent at 500 gf/cm; "
      "allowed: from 2.5 to 22.5 gf cm/cm^2, for LT = 2 WT/(Fm EMT) from 0.2 to 1.8"}},
    {"fast_good", "W", "W", {}},
    {"fast_unknown",
     "EB5",
     "EB",
     {"wool.toml:9: fabric.wool.fast.EB is no known key; the nearest is \"EB5\""}},
    {"fast_extension_rests",
     "E20 = [1.87, 1.87]",
     "E20 = [0.67, 1.87]",
     {"wool.toml:7: fabric.wool.fast.E20[0] = 0.67 percent after E5 = 0.67 percent; wanted: a rise of at "
      "least 1e-06 percent"}},
    {"fast_extension_falls",
     "E100 = [4.60, 5.87]",
     "E100 = 1",
     {"wool.toml:8: fabric.wool.fast.E100 = 1 percent after E20 = 1.87 percent; wanted: a rise of at least "
      "1e-06 percent"}},
    {"fast_extension_missing",
     "E20 = [1.87, 1.87]\n",
     "",
     {"wool.toml:1: fabric.wool.fast.E20 is missing; wanted: a number in percent or a list of two, [warp, "
      "weft]"}},
    {"fast_extension_alone",
     "E5 = [0.67, 0.40]\nE20 = [1.87, 1.87]\nE100 = [4.60, 5.87]",
     "E5 = 0.5",
     {"wool.toml:1: fabric.wool.fast.E20 is missing; wanted: a number in percent or a list of two, [warp, "
      "weft]",
      "wool.toml:1: fabric.wool.fast.E100 is missing; wanted: a number in percent or a list of two, [warp, "
      "weft]"}},
    {"fast_thickness_grows",
     "T100 = 0.42",
     "T100 = 0.62",
     {"wool.toml:4: fabric.wool.fast.T100 = 0.62 mm is more than T2, 0.52 mm; allowed: at most as much, "
      "since the pressure is higher"}},
    {"fast_thickness_missing",
     "T2 = 0.52\n",
     "",
     {"wool.toml:1: fabric.wool.fast.T2 is missing; wanted: a number in mm"}},
    {"fast_bias_of_nothing",
     "EB5 = 4.7",
     "EB5 = 0",
     {"wool.toml:9: fabric.wool.fast.EB5 = 0 percent; allowed: from 0.1 to 41 percent"}},
    {"fast_length_in_metres",
     "C = [15.0, 14.5]",
     "C = [0.015, 0.0145]",
     {"wool.toml:5: fabric.wool.fast.C[0] = 0.015 mm; allowed: from 0.1 to 100 mm",
      "wool.toml:5: fabric.wool.fast.C[1] = 0.0145 mm; allowed: from 0.1 to 100 mm"}},
    {"strips_good", "warp", "warp", {}},
    {"strips_unknown",
     "\"ASTM D5035 1R\"",
     "\"ASTM D5035\"",
     {"wool.toml:3: fabric.wool.strip = \"ASTM D5035\"; allowed: \"GOST 3813\", \"GOST 3813 wool\", \"GOST "
      "3813 small\", \"ISO 13934-1\", \"ISO 13934-1 100 mm\", \"ASTM D5035 1R\", \"ASTM D5035 2R\", \"ASTM "
      "D5035 1C\", \"ASTM D5035 2C\""}},
    {"strips_number",
     "\"ASTM D5035 1R\"",
     "50",
     {"wool.toml:3: fabric.wool.strip is a whole number; wanted: a table or \"GOST 3813\", \"GOST 3813 "
      "wool\", \"GOST "
      "3813 small\", \"ISO 13934-1\", \"ISO 13934-1 100 mm\", \"ASTM D5035 1R\", \"ASTM D5035 2R\", \"ASTM "
      "D5035 1C\", \"ASTM D5035 2C\""}},
    {"strips_unit",
     "force_lbf",
     "force_lb",
     {"wool.toml:5: fabric.wool.warp.force is missing; wanted: a list of numbers in N",
      "wool.toml:7: fabric.wool.warp.force_lb is no known key; the nearest is \"force_lbf\""}},
    {"strips_extension_falls",
     "[0, 1.5, 3]",
     "[0, 3, 1.5]",
     {"wool.toml:6: fabric.wool.warp.extension_mm[2] = 1.5 mm after 3 mm; wanted: a rise of at least 7.5e-07 "
      "mm"}},
    {"strips_extension_starts_high",
     "[0, 1.5, 3]",
     "[1, 1.5, 3]",
     {"wool.toml:6: fabric.wool.warp.extension_mm[0] = 1 mm; a diagram starts at 0 mm"}},
    {"strips_force_falls",
     "[0, 2, 5]",
     "[0, 5, 2]",
     {"wool.toml:7: fabric.wool.warp.force_lbf[2] = 2 lbf after 5 lbf; the force of a diagram does not "
      "fall: `drape fabric smooth` makes a diagram of a tester's samples"}},
    {"strips_force_starts_high",
     "force_kgf = [0, 1]",
     "force_kgf = [0.5, 1]",
     {"wool.toml:11: fabric.wool.weft.force_kgf[0] = 0.5 kgf; a diagram starts at 0 kgf: subtract a "
      "pretension from all its forces, or let `drape fabric smooth` do so"}},
    {"strips_force_negative",
     "force_kgf = [0, 1]",
     "force_kgf = [0, -1]",
     {"wool.toml:11: fabric.wool.weft.force_kgf[1] = -1 kgf; allowed: from 0 to 100000 kgf"}},
    {"strips_force_too_short",
     "[0, 2, 5]",
     "[0, 2]",
     {"wool.toml:7: fabric.wool.warp.force_lbf has 2 entries, extension_mm has 3; wanted: as many"}},
    {"strips_force_twice",
     "force_lbf = [0, 2, 5]",
     "force_lbf = [0, 2, 5]\nforce = [0, 9, 22]",
     {"wool.toml:7: fabric.wool.warp.force_lbf states the force, as warp.force does; wanted: one of them"}},
    {"strips_force_missing",
     "force_kgf = [0, 1]\n",
     "",
     {"wool.toml:9: fabric.wool.weft.force is missing; wanted: a list of numbers in N"}},
    {"strips_extension_twice",
     "extension_in = [0, 0.1]",
     "extension_in = [0, 0.1]\nextension_mm = [0, 2.54]",
     {"wool.toml:10: fabric.wool.weft.extension_in states the elongation, as weft.extension_mm does; wanted: "
      "one of them"}},
    {"strips_jaws",
     "jaws = false",
     "jaws = 0",
     {"wool.toml:15: fabric.wool.bias.jaws is a whole number; wanted: true or false"}},
    {"strips_bias_beyond_locking",
     "elongation_percent = [0, 4]",
     "extension_mm = [0, 32]",
     {"wool.toml:13: fabric.wool.bias.extension_mm[1] = 32 mm, 42.6667 percent; bias_model \"odd\" takes at "
      "least one point above 0 and below 41.42 percent, where the threads of a strip lie along the pull"}},
    {"strips_overhang",
     "overhang_mm = [38, 30]",
     "overhang_mm = 300",
     {"wool.toml:4: fabric.wool.bending.overhang_mm = 300 mm; allowed: from 0.2 to 200 mm"}},
    {"strips_length_and_overhang",
     "overhang_mm = [38, 30]",
     "overhang_mm = [38, 30], length_mm = [19, 15]",
     {"wool.toml:4: fabric.wool.bending.overhang_mm states the bending rigidity, as bending.length_mm does; "
      "wanted: one of them"}},
    {"strips_bending_of_nothing",
     "overhang_mm = [38, 30]",
     "poisson = 0.1",
     {"wool.toml:4: fabric.wool.bending.rigidity_uN_cm2 is missing; wanted: a list of two numbers in uN "
      "cm^2"}},
    {"pt2_good", "mass_g", "mass_g", {}},
    {"pt2_deflection_of_all",
     "63.5",
     "70",
     {"wool.toml:4: fabric.wool.bending.gost_10550.deflection_mm[0] = 70 mm; allowed: from 1 to 69 mm"}},
    {"pt2_mass_of_none",
     "3.17",
     "0",
     {"wool.toml:4: fabric.wool.bending.gost_10550.mass_g[0] = 0 g; allowed: from 0.001 to 1000 g"}},
    {"pt2_no_deflection",
     ", deflection_mm = [63.5, 65.1]",
     "",
     {"wool.toml:4: fabric.wool.bending.gost_10550.deflection_mm is missing; wanted: a number in mm or a "
      "list of two, [warp, weft]"}},
    {"pt2_number",
     "{ mass_g = [3.17, 3.15], deflection_mm = [63.5, 65.1] }",
     "42046",
     {"wool.toml:4: fabric.wool.bending.gost_10550 is a whole number; wanted: a table"}},
    {"pt2_and_rigidity",
     "poisson = 0.1",
     "rigidity_uN_cm2 = [2700, 1630]\nwidth = 0.03",
     {"wool.toml:4: fabric.wool.bending.gost_10550 states the bending rigidity, as bending.rigidity_uN_cm2 "
      "does; wanted: one of them"}},
    {"pt2_no_weight",
     "areal_density = 0.132\n",
     "",
     {"scene.toml:3: fabric.wool.areal_density is missing; wanted: a number in kg/m^2"}},
    {"strips_calibrated_as_a_sheet",
     "thickness = 0.0005\n",
     "thickness = 0.0005\ncalibration = { cell = 0.01, residual = 0, date = \"today\", weft = [1, 1] }\n",
     {"wool.toml:3: fabric.wool.calibration.weft belongs to a diagram from a sheet; wanted: "
      "weft.correction"}},
    {"strips_extension_huge",
     "extension_in = [0, 0.1]",
     "extension_in = [0, 30]",
     {"wool.toml:10: fabric.wool.weft.extension_in[1] = 30 in; allowed: from 0 to 29.5276 in, ten times the "
      "gauge"}},
};

INSTANTIATE_TEST_SUITE_P(Sheets, DatasheetFault, testing::ValuesIn(kSheets), name_of);

}  // namespace
}  // namespace drape::scene
