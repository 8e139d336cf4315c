// Materials of objects, as steps of a session.
#include <gtest/gtest.h>

#include "core/scene/materials.h"
#include "session_testing.h"

namespace trivet::test {
namespace {

const PhysicsMaterial& material_in(const Session& session, const std::string& name) {
  return session.scene().at(*session.scene().find(name)).material;
}

TEST(MaterialOperation, IsOneStepThatMovesNothing) {
  Session session = small_session();
  ASSERT_TRUE(session.perform(put_at("a", 0, 0)).ok());
  const Scene before = session.scene();
  const std::uint64_t state = fingerprint(before);
  const PhysicsMaterial wood = *material_preset("wood");
  const OperationResult result = session.perform(MaterialOperation{"a", wood});
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(session.steps().back().name, "material \"a\"");
  EXPECT_TRUE(same_material(material_in(session, "a"), wood));
  EXPECT_EQ(difference(session.scene(), before), "material of a");
  EXPECT_NE(fingerprint(session.scene()), state);
  ASSERT_TRUE(session.undo());
  EXPECT_EQ(difference(session.scene(), before), "");
  EXPECT_EQ(fingerprint(session.scene()), state);
  ASSERT_TRUE(session.redo());
  EXPECT_TRUE(same_material(material_in(session, "a"), wood));
}

TEST(MaterialOperation, GoesWithDuplicatesAndAppends) {
  Session session = small_session();
  ASSERT_TRUE(session.perform(MaterialOperation{"a", *material_preset("ice")}).ok());
  ASSERT_TRUE(session.perform(DuplicateOperation{"a", "a2"}).ok());
  EXPECT_EQ(material_in(session, "a2").name, "ice");
  AppendOperation append = append_of("d", "m");
  append.material = *material_preset("steel");
  ASSERT_TRUE(session.perform(append).ok());
  EXPECT_EQ(material_in(session, "d").density, 7850);
  ASSERT_TRUE(session.perform(append_of("e", "m")).ok());
  EXPECT_TRUE(same_material(material_in(session, "e"), {}));
}

TEST(MaterialOperation, RefusesWhatNoMaterialHas) {
  Session session = small_session();
  const auto reason = [&](const PhysicsMaterial& material) {
    return session.perform(MaterialOperation{"a", material}).reason();
  };
  EXPECT_EQ(reason({"", 0}),
            "material: friction: 0 is not accepted; accepted: a number from 0.001 to 10");
  EXPECT_EQ(reason({"", 11}),
            "material: friction: 11 is not accepted; accepted: a number from 0.001 to 10");
  EXPECT_EQ(reason({"", 1, 0}),
            "material: density: 0 is not accepted; accepted: a number from 0.001 to 100000");
  EXPECT_EQ(reason({"", 1, 1, 1.1}),
            "material: restitution: 1.1 is not accepted; accepted: a number from 0 to 1");
  EXPECT_NE(reason({"wood", 1, 1, 1}).find("material: \"wood\" is not accepted"),
            std::string::npos);
  EXPECT_NE(reason({"", std::nan("")}), "");
  EXPECT_EQ(session.num_done(), 0u);
}

}  // namespace
}  // namespace trivet::test
