// Bad input about seams.
#include "fault_case.h"

namespace drape::validation {

using namespace tests;
namespace {

const std::string kSewn = R"([scene]
name = "sewn"
[fabric.wool]
file = "wool.toml"
[[piece]]
name = "front"
fabric = "wool"
cell = 0.01
outline = [[0, 0], [0.4, 0], [0.4, 0.6], [0, 0.6]]
[[piece]]
name = "back"
fabric = "wool"
cell = 0.02
outline = [[0, 0], [0.4, 0], [0.5, 0.3], [0.4, 0.6], [0, 0.6]]
[[seam]]
name = "side"
a = { piece = "front", edges = [1] }
b = { piece = "back", edges = [1, 2], reverse = true }
closed_at = inf
gap_tol = 0.0002
pull = 500
speed = 0.5
tape = 20
[[seam]]
name = "tube"
a = { piece = "front", edges = [3] }
b = { piece = "back", edges = [4] }
)";

class SeamFault : public testing::TestWithParam<Case> {};

TEST_P(SeamFault, GivesItsMessages) { EXPECT_EQ(scene_fault(GetParam(), kSewn), GetParam().messages); }

TEST(Seams, AreReadWithoutFault) {
  EXPECT_EQ(scene_fault({"none", "[scene]", "[scene]", {}}, kSewn), Messages{});
}

const Case kSeams[] = {
    {"missing_piece",
     "piece = \"back\", edges = [1, 2]",
     "piece = \"sleeve\", edges = [1, 2]",
     {"scene.toml:18: seam.side.b.piece = \"sleeve\" names no piece; known: \"front\", \"back\""}},
    {"missing_side",
     "b = { piece = \"back\", edges = [4] }\n",
     "",
     {"scene.toml:24: seam.tube.b is missing; wanted: a table { piece, edges }"}},
    {"missing_edges",
     "a = { piece = \"front\", edges = [3] }",
     "a = { piece = \"front\" }",
     {"scene.toml:26: seam.tube.a.edges is missing; wanted: a list of whole numbers"}},
    {"no_edges",
     "edges = [3]",
     "edges = []",
     {"scene.toml:26: seam.tube.a.edges is an empty list; wanted: a list of whole numbers"}},
    {"edge_that_is_not_there",
     "edges = [3]",
     "edges = [3, 4, -1]",
     {"scene.toml:26: seam.tube.a.edges[1] = 4; allowed: 0 to 3 (edge i runs from point i of the outline to "
      "the "
      "next)",
      "scene.toml:26: seam.tube.a.edges[2] = -1; allowed: 0 to 3 (edge i runs from point i of the outline to "
      "the next)"}},
    {"edge_twice_on_a_side",
     "edges = [1, 2]",
     "edges = [1, 2, 1]",
     {"scene.toml:18: seam.side.b.edges[2] = 1 stands there twice"}},
    {"edges_apart",
     "edges = [1, 2]",
     "edges = [1, 3]",
     {"scene.toml:18: seam.side.b.edges do not follow each other along the outline of the piece \"back\"; "
      "wanted: one run of edges"}},
    {"edge_in_two_seams",
     "edges = [4]",
     "edges = [2]",
     {"scene.toml:27: seam.tube.b.edges[0] = 2 is sewn by seam.side.b already; an edge belongs to one seam"}},
    {"edge_to_itself",
     "b = { piece = \"back\", edges = [4] }",
     "b = { piece = \"front\", edges = [3], reverse = true }",
     {"scene.toml:27: seam.tube.b.edges[0] = 3 is sewn by seam.tube.a already; an edge belongs to one seam"}},
    {"unknown_key",
     "reverse = true",
     "revers = true",
     {"scene.toml:18: seam.side.b.revers is no known key; the nearest is \"reverse\""}},
    {"numbers",
     "closed_at = inf\ngap_tol = 0.0002\npull = 500\nspeed = 0.5\ntape = 20",
     "closed_at = -1\ngap_tol = 0\npull = 0\nspeed = 0\ntape = -1",
     {"scene.toml:19: seam.side.closed_at = -1 s; allowed: from 0 to inf s",
      "scene.toml:20: seam.side.gap_tol = 0 m; allowed: from 1e-09 to 1 m",
      "scene.toml:21: seam.side.pull = 0 1/s; allowed: above 0, at most 1e+06 1/s",
      "scene.toml:22: seam.side.speed = 0 m/s; allowed: above 0, at most 1000 m/s",
      "scene.toml:23: seam.side.tape = -1 N; allowed: from 0 to 1e+06 N"}},
    {"no_number",
     "closed_at = inf",
     "closed_at = nan",
     {"scene.toml:19: seam.side.closed_at = nan s; allowed: from 0 to inf s"}},
    {"higher_order",
     "name = \"sewn\"",
     "name = \"sewn\"\norder = 4",
     {"scene.toml:3: scene.order = 4 does not go with seams, whose pull is damped; wanted: order = 2, or no "
      "seam"}},
    {"name_twice",
     "name = \"tube\"",
     "name = \"side\"",
     {"scene.toml:25: seam[1].name = \"side\" is taken by another seam; names differ within a kind"}},
};

INSTANTIATE_TEST_SUITE_P(Seam, SeamFault, testing::ValuesIn(kSeams), name_of);

}  // namespace
}  // namespace drape::validation
