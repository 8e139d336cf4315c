// A material that is changed changes what is held.
#include "core/scene/materials.h"
#include "stage.h"

namespace trivet {
namespace {

using test::box_triangles;
using test::Stage;

// A block on a slope of 20 degrees, held while friction is more than tan 20 = 0.364.
TEST(Material, IsRatedAgainWhereItLies) {
  Stage s;
  const double angle = 20 * M_PI / 180;
  s.fix("slope", test::prism({{0, 0}, {1, 0}, {1, std::tan(angle)}}, 0.5), {0, 0, 1e-5});
  s.put("block", box_triangles(Vec3(0.1, 0.1, 0.02)), {0.5, 0, 1},
        Rotation::about_axis(Vec3::UnitY(), -std::tan(angle / 2)));
  ASSERT_EQ(s.at("block").state, ObjectState::Stable);
  const Vec3 before = s.position("block");
  const OperationResult slips = s.run(MaterialOperation{"block", {"", 0.3}});
  ASSERT_TRUE(slips.ok()) << slips.reason();
  EXPECT_EQ(slips.unsupported, std::vector<std::string>{"block"});
  EXPECT_EQ(s.at("block").state, ObjectState::Unsupported);
  EXPECT_EQ(s.position("block"), before);
  const OperationResult holds = s.run(MaterialOperation{"block", {"", 0.4}});
  EXPECT_TRUE(holds.unsupported.empty());
  EXPECT_EQ(s.at("block").state, ObjectState::Stable);
  // The support's own friction counts as well.
  EXPECT_EQ(s.run(MaterialOperation{"slope", {"", 0.3}}).unsupported,
            std::vector<std::string>{"block"});
  // By perfect friction no rest depends on a material: what finite friction has judged stays.
  const OperationResult other =
      perform(s.scene, MaterialOperation{"slope", {"", 0.4}}, test::perfect_friction());
  EXPECT_TRUE(other.ok() && other.unsupported.empty());
  EXPECT_EQ(s.at("block").state, ObjectState::Unsupported);
  s.run(MaterialOperation{"slope", {"", 0.5}});
  EXPECT_EQ(s.at("block").state, ObjectState::Stable);
  s.options.perfect_friction = true;
  EXPECT_TRUE(s.run(MaterialOperation{"slope", {"", 0.1}}).unsupported.empty());
}

}  // namespace
}  // namespace trivet
