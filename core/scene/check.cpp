// What no single key can show: diagrams as a whole, outlines, pins and probes against their pieces. Values
// that the reader could not land are empty, 0 or -1; they have been reported, and are passed over here.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "scene/faults.h"
#include "scene/read.h"

namespace drape {

namespace {

using Problems = std::vector<Problem>;

constexpr double kTouch =
    1e-9;  // m, and the same fraction of the piece's size: coordinates closer than that coincide
constexpr double kMostNodes = 4e6;    // of a piece
constexpr double kLeastRise = 1e-8;   // of a diagram's elongation from point to point
constexpr double kLocking = 0.41421;  // below sqrt(2) - 1, where the trellis of a bias strip locks

std::string rounded(double value) {  // for numbers that have been computed
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string point_text(Vec2 p) { return "[" + rounded(p[0]) + ", " + rounded(p[1]) + "] m"; }

std::string entry(const std::string& path, std::size_t i) { return path + "[" + std::to_string(i) + "]"; }

// ---- Fabrics

void diagram_check(const DiagramSpec& d, const std::string& path, Problems& problems) {
  const std::string elongation = path + ".elongation_percent", force = path + ".force";
  const auto percent = [](double e) { return rounded(100 * e) + " percent"; };
  const auto length_check = [&](const std::vector<double>& list, const std::string& name) {
    if (!list.empty() && !d.elongation.empty() && list.size() != d.elongation.size())
      problems.push_back({name, "has " + entries_text(list.size()) + ", elongation_percent has " +
                                    std::to_string(d.elongation.size()) + "; wanted: as many"});
  };
  if (!d.elongation.empty() && (d.elongation.size() < 2 || d.elongation.size() > 64))
    problems.push_back({elongation, "has " + entries_text(d.elongation.size()) + "; allowed: 2 to 64"});
  length_check(d.force, force);
  length_check(d.correction, path + ".correction");

  if (!d.elongation.empty() && d.elongation[0] != 0)
    problems.push_back(
        {entry(elongation, 0), "= " + percent(d.elongation[0]) + "; a diagram starts at 0 percent"});
  if (!d.force.empty() && d.force[0] != 0)
    problems.push_back({entry(force, 0), "= " + number_text(d.force[0]) + " N; a diagram starts at 0 N"});
  for (std::size_t i = 1; i < d.elongation.size(); ++i)
    if (!(d.elongation[i] - d.elongation[i - 1] >= kLeastRise))
      problems.push_back({entry(elongation, i), "= " + percent(d.elongation[i]) + " after " +
                                                    percent(d.elongation[i - 1]) +
                                                    "; wanted: a rise of at least " + percent(kLeastRise)});
  for (std::size_t i = 1; i < d.force.size(); ++i)
    if (!(d.force[i] >= d.force[i - 1]))
      problems.push_back({entry(force, i), "= " + number_text(d.force[i]) + " N after " +
                                               number_text(d.force[i - 1]) +
                                               " N; the force of a diagram does not fall"});
  if (d.correction.size() != d.force.size()) return;
  for (std::size_t i = 1; i < d.force.size(); ++i)
    if (const double law = d.force[i] * d.correction[i], last = d.force[i - 1] * d.correction[i - 1];
        law < last && d.force[i] >= d.force[i - 1])
      problems.push_back({entry(path + ".correction", i), "= " + number_text(d.correction[i]) + " gives " +
                                                              rounded(law) + " N after " + rounded(last) +
                                                              " N; force x correction does not fall"});
}

// A bias diagram without a stored correction is worked up from the strip's geometry, which sets limits of its
// own.
void bias_check(const Scene& scene, const FabricSpec& f, const std::string& path, Problems& problems) {
  const std::vector<double>& force = f.bias.force;
  const bool off = std::all_of(force.begin(), force.end(), [](double v) { return v == 0; });
  if (off || !f.bias.correction.empty()) return;
  const double ratio = f.strip_gauge / f.strip_width;
  if (scene.clamp_correction && !(ratio > 1.25))
    problems.push_back(
        {path + ".strip", "has gauge/width = " + rounded(ratio) +
                              "; the clamp correction of a bias diagram takes values above 1.25 (or set "
                              "options.clamp_correction = false)"});
  if (scene.bias_model == BiasModel::kOdd && f.bias.elongation.size() > 1 && f.bias.elongation[1] > kLocking)
    problems.push_back(
        {path + ".bias.elongation_percent[1]", "= " + rounded(100 * f.bias.elongation[1]) +
                                                   " percent; bias_model \"odd\" takes at least one point "
                                                   "above 0 and below 41.42 percent, where the threads "
                                                   "of a strip lie along the pull"});
}

// ---- Pieces

struct Box {  // of points and edges alike: both are boxes along the axes
  Vec2 low, high;
  double size() const { return std::max(high[0] - low[0], high[1] - low[1]); }
  double touch() const { return kTouch + kTouch * size(); }
};

Box box_of(const std::vector<Vec2>& points) {
  Box box{points[0], points[0]};
  for (const Vec2& p : points)
    for (int k = 0; k < 2; ++k)
      box.low[k] = std::min(box.low[k], p[k]), box.high[k] = std::max(box.high[k], p[k]);
  return box;
}

// Four points that go round the corners of their box: each corner once, neighbours differ in one coordinate.
bool is_rectangle(const std::vector<Vec2>& outline, const Box& box) {
  if (outline.size() != 4) return false;
  const double tolerance = kTouch * box.size();
  int corner[4];
  for (int i = 0; i < 4; ++i) {
    corner[i] = 0;
    for (int k = 0; k < 2; ++k) {
      const bool high = outline[i][k] > (box.low[k] + box.high[k]) / 2;
      if (std::abs(outline[i][k] - (high ? box.high[k] : box.low[k])) > tolerance) return false;
      corner[i] |= high << k;
    }
  }
  return corner[0] != corner[2] && corner[1] != corner[3] && (corner[0] ^ corner[1]) != 3 &&
         (corner[1] ^ corner[2]) != 3 && (corner[2] ^ corner[3]) != 3;
}

// True if the outline is one that this version takes.
bool outline_check(const PieceSpec& piece, const std::string& path, Problems& problems) {
  const std::vector<Vec2>& outline = piece.outline;
  if (outline.empty()) return false;
  const std::string kTakes =
      "this version takes rectangles along the threads: four corners, sides parallel to x and y";
  const Box box = box_of(outline);
  std::string flaw;
  if (!(std::min(box.high[0] - box.low[0], box.high[1] - box.low[1]) > kTouch * box.size()))
    flaw = "encloses no area";
  else if (outline.size() > 1 && outline.front() == outline.back())
    flaw = "repeats its first point at the end; an outline closes by itself";
  else if (outline.size() != 4) flaw = "has " + std::to_string(outline.size()) + " corners; " + kTakes;
  else if (!is_rectangle(outline, box)) flaw = "is no rectangle along the threads; " + kTakes;
  if (!flaw.empty()) problems.push_back({path + ".outline", flaw});
  return flaw.empty();
}

void cell_check(const PieceSpec& piece, const std::string& path, Problems& problems) {
  if (!(piece.cell > 0)) return;
  const Box box = box_of(piece.outline);
  const double width = box.high[0] - box.low[0], height = box.high[1] - box.low[1],
               shorter = std::min(width, height);
  const double nodes = (width / piece.cell + 1) * (height / piece.cell + 1);
  const std::string value = "= " + number_text(piece.cell) + " m";
  if (piece.cell > shorter * (1 + kTouch))
    problems.push_back(
        {path + ".cell", value + "; allowed: at most the piece's shorter side, " + rounded(shorter) + " m"});
  if (nodes > kMostNodes)
    problems.push_back({path + ".cell", value + " makes about " + rounded(nodes) +
                                            " nodes; allowed: at most " + rounded(kMostNodes) + " a piece"});
}

// ---- Pins and probes

void point_check(const Scene& scene, int piece, Vec2 p, const std::string& path, Problems& problems) {
  const Box box = box_of(scene.pieces[piece].outline);
  const auto beyond = [&](int k) { return std::max({0.0, box.low[k] - p[k], p[k] - box.high[k]}); };
  const double distance = std::hypot(beyond(0), beyond(1));
  if (distance > box.touch())
    problems.push_back({path, "= " + point_text(p) + " lies " + rounded(distance) + " m off the piece " +
                                  in_quotes(scene.pieces[piece].name)});
}

void edges_check(const Scene& scene, const PinSpec& pin, const std::string& path, Problems& problems) {
  const int count = static_cast<int>(scene.pieces[pin.piece].outline.size());
  for (std::size_t i = 0; i < pin.edges.size(); ++i)
    if (pin.edges[i] < 0 || pin.edges[i] >= count)
      problems.push_back(
          {entry(path + ".edges", i), "= " + std::to_string(pin.edges[i]) + "; allowed: 0 to " +
                                          std::to_string(count - 1) +
                                          " (edge i runs from point i of the outline to the next)"});
}

// What a pin holds, as boxes: its points and its edges.
std::vector<Box> pin_boxes(const Scene& scene, const PinSpec& pin) {
  std::vector<Box> boxes;
  const std::vector<Vec2>& outline = scene.pieces[pin.piece].outline;
  const int count = static_cast<int>(outline.size());
  for (const Vec2& p : pin.at) boxes.push_back({p, p});
  for (int e : pin.edges)
    if (e >= 0 && e < count) boxes.push_back(box_of({outline[e], outline[(e + 1) % count]}));
  return boxes;
}

// Two pins on one point could pull it two ways. One message for each pair of pins.
void clash_check(const Scene& scene, const PinSpec& a, const PinSpec& b, Problems& problems) {
  const double touch = box_of(scene.pieces[a.piece].outline).touch();
  for (const Box& p : pin_boxes(scene, a))
    for (const Box& q : pin_boxes(scene, b)) {
      const Vec2 low{std::max(p.low[0], q.low[0]), std::max(p.low[1], q.low[1])};
      const Vec2 high{std::min(p.high[0], q.high[0]), std::min(p.high[1], q.high[1])};
      if (low[0] > high[0] + touch || low[1] > high[1] + touch) continue;
      return problems.push_back({"pin." + b.name, "and pin." + a.name + " both hold the point " +
                                                      point_text(low) + " of the piece " +
                                                      in_quotes(scene.pieces[a.piece].name) +
                                                      "; a point belongs to one pin"});
    }
}

}  // namespace

void scene_check(const Scene& scene, std::vector<Problem>& problems) {
  for (const FabricSpec& f : scene.fabrics) {
    const std::string path = "fabric." + f.name;
    diagram_check(f.warp, path + ".warp", problems);
    diagram_check(f.weft, path + ".weft", problems);
    diagram_check(f.bias, path + ".bias", problems);
    bias_check(scene, f, path, problems);
  }

  std::vector<bool> laid_out;  // pieces against which points can be judged
  for (const PieceSpec& piece : scene.pieces) {
    const std::string path = "piece." + piece.name;
    laid_out.push_back(outline_check(piece, path, problems));
    if (laid_out.back()) cell_check(piece, path, problems);
  }

  std::vector<const PinSpec*> pins;
  for (const PinSpec& pin : scene.pins) {
    if (pin.piece < 0 || !laid_out[pin.piece]) continue;
    const std::string path = "pin." + pin.name;
    for (std::size_t i = 0; i < pin.at.size(); ++i)
      point_check(scene, pin.piece, pin.at[i], entry(path + ".at", i), problems);
    edges_check(scene, pin, path, problems);
    for (const PinSpec* other : pins)
      if (other->piece == pin.piece) clash_check(scene, *other, pin, problems);
    pins.push_back(&pin);
  }
  for (const ProbeSpec& probe : scene.probes)
    if (probe.piece >= 0 && laid_out[probe.piece])
      point_check(scene, probe.piece, probe.at, "probe." + probe.name + ".at", problems);
}

}  // namespace drape
