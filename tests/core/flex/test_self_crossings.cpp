#include <gtest/gtest.h>

#include "core/flex/self_crossings.h"

using namespace trivet;
using namespace trivet::flex;

namespace {

using Faces = std::vector<std::array<int, 3>>;

// Two faces at the edge from 0 to 1, with apexes 2 and 3.
const Faces kHinge{{0, 1, 2}, {1, 0, 3}};
// Two faces at vertex 0.
const Faces kFan{{0, 1, 2}, {0, 3, 4}};

TEST(SelfCrossings, FlatSheetHasNone) {
  const Points x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  EXPECT_FALSE(self_crossing(x, kHinge));
}

TEST(SelfCrossings, FoldedFlatIsFound) {
  const Points flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.5, 0}};
  EXPECT_TRUE(self_crossing(flat, kHinge));
  Points apart = flat;
  apart[3].z() = 1e-300;
  EXPECT_FALSE(self_crossing(apart, kHinge));
  EXPECT_TRUE(self_crossing(rounded_to_float32(apart), kHinge));
}

TEST(SelfCrossings, FoldedFlatInAnyPlane) {
  for (int axis = 0; axis < 3; ++axis) {
    Points x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.5, 0}};
    for (Vec3& p : x)
      p = axis == 0 ? p : axis == 1 ? Vec3(p.z(), p.x(), p.y()) : Vec3(p.y(), p.z(), p.x());
    EXPECT_TRUE(self_crossing(x, kHinge)) << axis;
  }
}

TEST(SelfCrossings, FacesOfOneVertexCrossBeyondIt) {
  const Points crossing{{0, 0, 0}, {2, -1, 0}, {2, 1, 0}, {1, 0, -1}, {1, 0, 1}};
  EXPECT_TRUE(self_crossing(crossing, kFan));
  const Points apart{{0, 0, 0}, {2, -1, 0}, {2, 1, 0}, {-1, 0, -1}, {-1, 0, 1}};
  EXPECT_FALSE(self_crossing(apart, kFan));
}

TEST(SelfCrossings, FacesApartCrossOrTouch) {
  Points x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 0}, {0.2, 0.3, 1}, {0.3, 0.2, 1}};
  const Faces faces{{0, 1, 2}, {3, 4, 5}};
  const auto touching = self_crossing(x, faces);
  ASSERT_TRUE(touching);
  EXPECT_EQ(touching->a, 0);
  EXPECT_EQ(touching->b, 1);
  x[3].z() = 1e-300;
  EXPECT_FALSE(self_crossing(x, faces));
  x[3].z() = -1e-300;
  EXPECT_TRUE(self_crossing(x, faces));
}

}  // namespace
