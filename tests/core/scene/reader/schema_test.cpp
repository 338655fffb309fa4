// The page of all keys names every key that the reader knows.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "scene/reader/schema.h"

namespace drape::scene {
namespace {

TEST(KeysPage, NamesEveryKey) {
  std::ifstream file(DRAPE_SOURCE_DIR "/core/scene/README.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  Scene scene;
  FabricText fabric;
  PieceSpec piece;
  CurveSpec curve;
  PinSpec pin;
  SeamSpec seam;
  ProbeSpec probe;
  BodySpec body;
  BodyText body_text;
  for (const std::vector<Key>& keys :
       {scene_keys(scene), fabric_keys(fabric), piece_keys(piece, {}), curve_keys(curve), pin_keys(pin, {}),
        seam_keys(seam, {}), body_keys(body, body_text), probe_keys(probe, {})})
    for (const Key& key : keys) {
      const std::string name = key.name.substr(key.name.rfind('.') + 1);
      EXPECT_NE(page.find(name), std::string::npos) << key.name;
    }
}

}  // namespace
}  // namespace drape::scene
