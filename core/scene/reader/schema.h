// The keys of a scene file: every name, range, unit and default in one place. Each row points to the member
// that it fills; the initial values of the struct are the defaults. Entries of lists are counted from 0, as
// are the edges of an outline.
#pragma once
#include <string>
#include <vector>

#include "scene/datasheet/datasheet.h"
#include "scene/reader/value_reader.h"
#include "scene/scene.h"

namespace drape::scene {

// A fabric as its text gives it, before conversion.
struct FabricText {
  Diagrams diagrams = Diagrams::kFinished;
  FabricSpec spec;
  DiagramSpec raw[3];   // samples kept beside the diagrams, in the order of kDiagrams
  Vec2 rigidity{0, 0};  // N m^2, EI of the bending specimen, warp and weft
  double bending_width = 0.03;
  std::string file, description, source;
  double calibration_cell = 0, calibration_residual = 0;
  std::string calibration_date;
  std::vector<double> calibration[3];  // corrections of diagrams from data sheets, in the order of kDiagrams
  DatasheetText datasheet;
};

std::vector<Key> scene_keys(Scene& scene);  // of the whole file; the rows below are of separate tables
std::vector<Key> fabric_keys(FabricText& text);
std::vector<Key> piece_keys(PieceSpec& piece, const std::vector<std::string>& fabrics);
std::vector<Key> curve_keys(CurveSpec& curve);
std::vector<Key> pin_keys(PinSpec& pin, const std::vector<std::string>& pieces);
std::vector<Key> seam_keys(SeamSpec& seam, const std::vector<std::string>& pieces);
// The mesh file of a body as written in the scene, and the four numbers of its orientation.
struct BodyText {
  std::string mesh;
  std::vector<double> orientation;
};
std::vector<Key> body_keys(BodySpec& body, BodyText& text);
std::vector<Key> probe_keys(ProbeSpec& probe, const std::vector<std::string>& pieces);

}  // namespace drape::scene
