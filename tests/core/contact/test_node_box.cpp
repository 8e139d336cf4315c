// The inlined boxes of placed trees are those of PlacedBvh, to the bit.
#include <gtest/gtest.h>

#include "core/contact/node_box.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

void expect_same_boxes(const PlacedBvh& tree) {
  for (Index node = 0; node < static_cast<Index>(tree.bvh.nodes.size()); ++node) {
    const PlacedBvh::Box expected = tree.box(node), found = placed_box(tree, node);
    ASSERT_EQ(found.centre, expected.centre) << node;
    ASSERT_EQ(found.half, expected.half) << node;
    ASSERT_EQ(found.radius, expected.radius) << node;
    ASSERT_EQ(found.own_half, expected.own_half) << node;
  }
}

TEST(NodeBox, IsThatOfPlacedBvh) {
  constexpr unsigned kSeed = 17;
  const test::MeshPool pool(kSeed, 16);
  for (int i = 0; i < 60; ++i) {
    const test::RandomQuery q = test::random_query(pool, kSeed, i);
    const Body moving = q.moving[0].body(), fixed = q.fixed[0].body();
    const UnitFrame frame(fixed);
    expect_same_boxes(PlacedBvh(moving));
    expect_same_boxes(frame.tree(moving));
    expect_same_boxes(frame.own_tree(fixed));
  }
}

}  // namespace
}  // namespace trivet
