// Saved states as bytes. A cloth that reads them moves on with the bits of one that never stopped: the states
// at the end are equal byte for byte. Bytes that are not whole, or of another scene, are refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "api/logged_cloth.h"
#include "api/snapshot.h"
#include "scene_file.h"
#include "state/sealed.h"

namespace drape::tests {
namespace {

using Bytes = std::vector<unsigned char>;

constexpr int kSaved = 150, kEnd = 400;  // communication intervals

// `added`: to the mesh of the box.
Cloth open_seed(const std::string& name, Logged& logged, const std::string& added = "") {
  const std::filesystem::path seeds = std::filesystem::path(DRAPE_SOURCE_DIR) / "tests/stress/fuzz/seeds";
  const SceneFolder folder;
  for (const char* mesh : {"box.obj", "ball.obj"})
    std::filesystem::copy_file(seeds / mesh, folder.path / mesh);
  std::ofstream(folder.path / "box.obj", std::ios::app) << added;
  std::filesystem::copy_file(seeds / "fmi" / (name + ".toml"), folder.path / "scene.toml");
  return Cloth(drape_open((folder.path / "scene.toml").c_str(), on_message, &logged));
}

Bytes bytes_of(const Cloth& c) {
  drape_snapshot* saved = drape_save(c.get(), nullptr);
  Bytes bytes(drape_snapshot_size(saved), 0xcd);
  drape_snapshot_write(c.get(), saved, bytes.data());
  drape_snapshot_free(saved);
  return bytes;
}

Bytes bits_of(const void* values, std::size_t size) {
  const auto* begin = static_cast<const unsigned char*>(values);
  return {begin, begin + size};
}

bool restore(const Cloth& c, const Bytes& bytes) {
  drape_snapshot* read = drape_snapshot_read(c.get(), bytes.data(), bytes.size());
  if (!read) return false;
  drape_restore(c.get(), read);
  drape_snapshot_free(read);
  return true;
}

// Pins and bodies move, wind blows, and values are tuned along ramps, as functions of the interval alone.
void interval(const Cloth& c, int k, double speed = 0.2) {
  const double q = drape_communication(c.get()), t = k * q;
  drape_inputs& in = *drape_inputs_of(c.get());
  const auto move = [&](drape_pin_input* list, int count) {
    for (int p = 0; p < count; ++p) {
      list[p].position[0] += speed * q;
      list[p].velocity[0] = speed;
      list[p].orientation[3] = 0.5 * t;
      list[p].angular_velocity[2] = t;
    }
  };
  move(in.pin, in.pin_count);
  move(in.body, in.body_count);
  if (in.has_wind) in.wind[1] = 300 * t;
  drape_parameters& p = *drape_parameters_of(c.get());
  if (k == 100) {
    p.ramp = 120.5 * q;  // not yet over where the state is saved
    p.gravity[0] = 2;
    p.fabric[0].areal_density *= 1.2;
    p.fabric[0].warp.force[2] *= 1.1;
    p.damping = 3;
  }
  if (k == 220 && p.has_air) p.fabric[0].damping = 1e-5;
  ASSERT_EQ(drape_advance(c.get(), k % 7 == 3 ? 1.3 * q : q), DRAPE_OK);
}

void intervals(const Cloth& c, int from, int to, double speed = 0.2) {
  for (int k = from; k < to; ++k) interval(c, k, speed);
}

class Snapshots : public testing::TestWithParam<const char*> {
 protected:
  Logged logged;
};

TEST_P(Snapshots, AnotherClothGoesOnWithTheSameBits) {
  const Cloth whole = open_seed(GetParam(), logged);
  ASSERT_TRUE(whole) << logged.errors.back();
  const Bytes start = bytes_of(whole);
  intervals(whole, 0, kSaved);
  const Bytes saved = bytes_of(whole);
  intervals(whole, kSaved, kEnd);
  const Bytes end = bytes_of(whole);
  EXPECT_NE(saved, end);
  for (const auto& [bytes, from] : {std::pair{&saved, kSaved}, {&start, 0}}) {
    const Cloth other = open_seed(GetParam(), logged);
    drape_get_outputs(other.get(), DRAPE_OUT_ALL);
    ASSERT_TRUE(restore(other, *bytes)) << logged.errors.back();
    EXPECT_EQ(bytes_of(other), *bytes);
    intervals(other, from, kEnd);
    EXPECT_EQ(bytes_of(other), end) << "from interval " << from;
    // What is read are the bits of the other cloth too.
    const drape_outputs *a = drape_get_outputs(whole.get(), DRAPE_OUT_ALL),
                        *b = drape_get_outputs(other.get(), DRAPE_OUT_ALL);
    const std::size_t velocities = sizeof(double) * 3 * std::size_t(a->node_count);
    EXPECT_EQ(bits_of(a->node_velocity, velocities), bits_of(b->node_velocity, velocities));
    EXPECT_EQ(bits_of(&a->energy, sizeof a->energy), bits_of(&b->energy, sizeof b->energy));
    for (int p = 0; p < a->pin_count; ++p)
      EXPECT_EQ(bits_of(a->pin[p].force, sizeof a->pin[p].force),
                bits_of(b->pin[p].force, sizeof b->pin[p].force));
  }
}

TEST_P(Snapshots, RollbackLeavesNoTraceOfHavingGoneAhead) {
  const Cloth straight = open_seed(GetParam(), logged), back = open_seed(GetParam(), logged);
  ASSERT_TRUE(straight && back);
  intervals(straight, 0, kEnd);
  intervals(back, 0, kSaved);
  drape_snapshot* saved = drape_save(back.get(), nullptr);
  drape_parameters& p = *drape_parameters_of(back.get());
  p.ramp = 0;
  p.gravity[1] = 5;
  p.fabric[0].bending_warp *= 2;
  p.fabric[0].friction = 0.1;
  for (int s = 0; s < p.seam_count; ++s) p.seam[s].close = 1;
  intervals(back, kSaved, kEnd, -1.5);
  drape_get_outputs(back.get(), DRAPE_OUT_ALL);
  drape_restore(back.get(), saved);
  drape_snapshot_free(saved);
  intervals(back, kSaved, kEnd);
  EXPECT_EQ(bytes_of(back), bytes_of(straight));
}

// Whatever single bit is flipped, wherever the bytes end, the cloth says so in one sentence and stays.
TEST_P(Snapshots, DamagedBytesAreRefused) {
  const Cloth c = open_seed(GetParam(), logged);
  ASSERT_TRUE(c);
  const Bytes before = bytes_of(c);
  intervals(c, 0, 20);
  const Bytes whole = bytes_of(c);
  const auto refused = [&](const Bytes& bytes, std::size_t at) {
    logged.errors.clear();
    EXPECT_FALSE(restore(c, bytes)) << at;
    EXPECT_EQ(logged.errors.size(), 1u) << at;
  };
  for (std::size_t at = 0; at < whole.size(); at += at < 64 ? 1 : 97) {
    Bytes bytes = whole;
    bytes[at] ^= static_cast<unsigned char>(1u << at % 8);
    refused(bytes, at);
    refused(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(at)), at);
  }
  Bytes longer = whole;
  longer.push_back(0);
  refused(longer, whole.size());
  EXPECT_EQ(bytes_of(c), whole);
  EXPECT_TRUE(restore(c, before));
}

INSTANTIATE_TEST_SUITE_P(Seeds, Snapshots,
                         testing::Values("hanging", "driven", "order_4", "order_6", "sewn", "fitted", "paper",
                                         "bodies", "self_contact", "bodies_and_self_contact"),
                         [](const auto& seed) { return std::string(seed.param); });

// Scratch beside an outline is read by whole vectors, and its values are multiplied by zero: it may hold no
// infinity of the state before.
TEST(Snapshot, RestoringForgetsWhatDiverged) {
  std::string outline;
  for (int k = 0; k < 48; ++k) {
    const double a = std::numbers::pi * k / 24;
    outline += (k ? ", [" : "[") + std::to_string(0.19 * std::cos(a)) + ", " +
               std::to_string(0.19 * std::sin(a)) + "]";
  }
  const SceneFolder folder;
  const std::string scene = folder.write(
      "scene.toml", "[scene]\nname = \"disc\"\n[fabric.wool]\nfile = \"" DRAPE_SOURCE_DIR
                    "/examples/fabrics/wool.toml\"\n[[piece]]\nname = \"disc\"\nfabric = \"wool\"\ncell = "
                    "0.01\noutline = [" +
                        outline +
                        "]\nplace = { origin = [0, 0, 0], axis_x = [1, 0, 0], axis_y = [0, 1, 0] }\n");
  Logged logged;
  const Cloth c(drape_open(scene.c_str(), on_message, &logged));
  ASSERT_TRUE(c) << logged.errors.back();
  drape_snapshot* start = drape_save(c.get(), nullptr);
  intervals(c, 0, 3);
  const Bytes end = bytes_of(c);
  for (dynamics::ThreadWorkspace& one : c.get()->motion.workspace.threads)
    std::fill(one.rows.begin(), one.rows.end(), INFINITY);
  drape_restore(c.get(), start);
  drape_snapshot_free(start);
  intervals(c, 0, 3);
  EXPECT_EQ(bytes_of(c), end);
}

TEST(Snapshot, BytesOfAnotherSceneAreRefused) {
  Logged logged;
  const Cloth c = open_seed("hanging", logged), other = open_seed("sewn", logged);
  EXPECT_FALSE(restore(c, bytes_of(other)));
  ASSERT_EQ(logged.errors.size(), 1u);
  EXPECT_EQ(logged.errors[0], "the saved state is of another scene than 'hanging', or of other meshes");
}

// The scene is the same word for word; the mesh that it names is another.
TEST(Snapshot, BytesOfOtherMeshesAreRefused) {
  Logged logged;
  const Cloth c = open_seed("bodies", logged), other = open_seed("bodies", logged, "v 0 0 0\n");
  ASSERT_TRUE(c && other);
  EXPECT_FALSE(restore(c, bytes_of(other)));
  ASSERT_EQ(logged.errors.size(), 1u);
  EXPECT_NE(logged.errors[0].find("or of other meshes"), std::string::npos) << logged.errors[0];
}

// Bytes that somebody has made, with a checksum that is right.
TEST(Snapshot, ForgedValuesAreRefused) {
  Logged logged;
  const Cloth c = open_seed("hanging", logged);
  const Bytes whole = bytes_of(c);
  std::uint64_t layout, scene;
  std::memcpy(&layout, whole.data() + 8, sizeof layout);
  std::memcpy(&scene, whole.data() + 24, sizeof scene);
  const auto forged = [&](std::size_t at, std::uint64_t word, std::size_t cut = 0) {
    Bytes bytes = whole;
    std::memcpy(bytes.data() + at, &word, sizeof word);
    bytes.resize(bytes.size() - cut);
    state::seal_write(bytes.data(), bytes.size(), {layout, scene});
    EXPECT_FALSE(restore(c, bytes));
    return logged.errors.empty() ? std::string() : logged.errors.back();
  };
  ++layout;
  EXPECT_EQ(forged(8, layout),
            "the saved state is of another version of Drape, whose states have other fields");
  --layout;
  std::uint64_t nodes;
  std::memcpy(&nodes, whole.data() + state::kHeaderSize, sizeof nodes);
  EXPECT_EQ(forged(state::kHeaderSize, nodes + 1), "the saved state is damaged: state.x has " +
                                                       std::to_string(nodes + 1) +
                                                       " elements; expected: " + std::to_string(nodes));
  EXPECT_EQ(forged(state::kHeaderSize + 8, 0x7ff8000000000000),
            "the saved state is damaged: state.x has a value out of its range");
  EXPECT_EQ(forged(whole.size() - 8, 1ull << 60), "the saved state is damaged: attached is cut off");
  EXPECT_EQ(forged(whole.size() - 8, 0, 4), "the saved state is damaged: attached is cut off");
}

// Lists whose lengths and numbers are legal one by one, and do not fit together.
TEST(Snapshot, ForgedListsAreRefused) {
  const auto expect_refused = [](const char* seed, const std::string& said, auto forge) {
    SCOPED_TRACE(said);
    Logged logged;
    const Cloth c = open_seed(seed, logged);
    intervals(c, 0, 20);
    drape_snapshot* saved = drape_save(c.get(), nullptr);
    forge(saved->state);
    Bytes bytes(drape_snapshot_size(saved));
    drape_snapshot_write(c.get(), saved, bytes.data());
    drape_snapshot_free(saved);
    EXPECT_FALSE(restore(c, bytes));
    ASSERT_EQ(logged.errors.size(), 1u);
    EXPECT_EQ(logged.errors[0], "the saved state is damaged: " + said);
  };
  expect_refused("hanging", "wx does not fit to the damping and air in force", [](State& s) {
    if (s.wx.empty()) s.wx = s.x;
    else s.wx = {};
  });
  expect_refused("hanging", "inverse_mass_scale belongs to a fit",
                 [](State& s) { s.inverse_mass_scale.assign(s.x.size(), 1); });
  expect_refused("bodies", "body.blocks do not fit together",
                 [](State& s) { s.body[0].blocks.free.push_back(1u << 30); });
  expect_refused("bodies", "body.edges do not fit together",
                 [](State& s) { s.body[0].edges.active_after_travel.push_back(0); });
  expect_refused("self_contact", "self.pairs do not fit together",
                 [](State& s) { s.self.active_after_travel.push_back(0); });
}

TEST(Snapshot, AttachedBytesTravelWithACopy) {
  Logged logged;
  const Cloth c = open_seed("hanging", logged), other = open_seed("hanging", logged);
  drape_snapshot* saved = drape_save(c.get(), nullptr);
  drape_snapshot_attach(saved, "four", 4);
  Bytes bytes(drape_snapshot_size(saved));
  drape_snapshot_write(c.get(), saved, bytes.data());
  drape_snapshot_free(saved);
  drape_snapshot* read = drape_snapshot_read(other.get(), bytes.data(), bytes.size());
  ASSERT_TRUE(read);
  std::size_t size = 0;
  const void* attached = drape_snapshot_attached(read, &size);
  ASSERT_EQ(size, 4u);
  EXPECT_EQ(std::memcmp(attached, "four", 4), 0);
  drape_snapshot_free(read);
}

}  // namespace
}  // namespace drape::tests
