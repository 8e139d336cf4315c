// Objects left interpenetrating by a free move stay invalid as long as they interpenetrate,
// whatever else is moved, and whichever of the two goes away.
#include "pile.h"

namespace trivet {
namespace {

using test::box_triangles;

/// A box in the middle of "cup", which stands on the floor beside "cube"; the box is the invalid
/// one.
struct Crossed : test::Stage {
  Crossed() {
    put("cup", box_triangles(Vec3(0.1, 0.1, 0.1)), {0, 0, 1});
    put("cube", box_triangles(Vec3(0.1, 0.1, 0.1)), {0.5, 0, 1});
    put("box", box_triangles(Vec3(0.05, 0.05, 0.05)), {0, 0.5, 1});
    TranslateOperation o{{"box"}, Vec3(0.08, -0.5, 0)};
    o.free = true;
    EXPECT_EQ(run(o).interpenetrates, std::vector<std::string>{"cup"});
    EXPECT_EQ(at("box").state, ObjectState::Invalid);
  }
  OperationResult go(const Operation& operation) {
    const OperationResult result = perform(scene, operation, options);
    EXPECT_TRUE(result.ok()) << result.reason();
    Scene anew = scene;
    update_contacts(anew);
    EXPECT_EQ(test::loads_text(scene), test::loads_text(anew));
    return result;
  }
};

PutOperation put_at(const std::string& name, const Vec3& from) {
  PutOperation put;
  put.object = name;
  put.start.translation = from;
  return put;
}

TEST(Invalid, PersistsThroughOtherOperations) {
  Crossed s;
  s.go(put_at("cube", Vec3(0.02, 0.26, 1)));
  s.go(TranslateOperation{{"cube"}, Vec3(0, -0.05, 0)});
  s.go(PickUpOperation{{"cube"}, 0.3, {}});
  EXPECT_EQ(s.at("box").state, ObjectState::Invalid);
}

TEST(Invalid, EndsWhenOtherObjectIsGone) {
  for (const Operation& operation :
       {Operation{put_at("cup", Vec3(-0.5, 0, 1))}, Operation{DeleteOperation{{"cup"}}}}) {
    Crossed s;
    const OperationResult result = s.go(operation);
    EXPECT_EQ(s.at("box").state, ObjectState::Stable);
    EXPECT_TRUE(result.unsupported.empty());
  }
}

TEST(Invalid, NamesObjectThenLeftInAir) {
  Crossed s;
  s.options = test::objects_alone();
  TranslateOperation up{{"box"}, Vec3(0, 0, 0.05)};
  up.free = true;
  s.go(up);
  const OperationResult result = s.go(put_at("cup", Vec3(-0.5, 0, 1)));
  EXPECT_EQ(s.at("box").state, ObjectState::Unsupported);
  EXPECT_EQ(result.unsupported, std::vector<std::string>{"box"});
}

TEST(Invalid, MarksLoadMovedIntoAnother) {
  test::Pile s;  // b is on the table, and c on b
  s.fix("lamp", box_triangles(Vec3(0.01, 0.01, 0.5)), {0.2, 2, 0.5 + 0.6});
  TranslateOperation o{{"table"}, Vec3(0, 2, 0)};
  o.free = true;
  EXPECT_EQ(s.run(o).interpenetrates, std::vector<std::string>{"lamp"});
  EXPECT_EQ(s.at("b").state, ObjectState::Invalid);
  EXPECT_EQ(s.at("table").state, ObjectState::Stable);  // on the floor
  o.by = Vec3(0, -1, 0);
  s.run(o);
  EXPECT_EQ(s.at("b").state, ObjectState::Stable);
}

// Neither holds the other, however deep; nor does the floor hold objects sunk into it.
TEST(Invalid, DoesNotHoldInterpenetratingObject) {
  for (const double deep : {1e-5, 1e-3, 2e-2}) {
    Crossed s;
    s.go(DeleteOperation{{"cup"}});
    s.go(PickUpOperation{{"cube"}, 0.5, {}});
    TranslateOperation below{{"box"},
                             s.position("cube") - s.position("box") - Vec3(0, 0, 0.15 - deep)};
    below.free = true;
    s.go(below);
    EXPECT_EQ(s.at("box").state, ObjectState::Invalid);
    s.put("plate", box_triangles(Vec3(0.02, 0.02, 0.01)), s.position("cube") + Vec3(0, 0, 1));
    EXPECT_EQ(s.at("cube").state, ObjectState::Held);
    const SceneCheck found = check_scene(s.scene, 1);
    EXPECT_EQ(found.not_at_rest, (std::vector<std::string>{"cube", "box"}));
    s.go(TranslateOperation{{"box"}, Vec3(0, 0, -1), true});
    EXPECT_EQ(check_scene(s.scene, 1).not_at_rest, (std::vector<std::string>{"cube", "box"}));
  }
}

TEST(Invalid, IsNamedWhenBlockingMove) {
  Crossed s;
  const auto reason = [&](TranslateOperation o, const std::vector<std::string>& together) {
    o.together = together;
    return perform(s.scene, o).reason();
  };
  const Vec3 up(0, 0, 0.1);
  const std::string first = ", by 0.07 m near (0.1, 0, 9.549e-07): move it out freely first";
  EXPECT_EQ(reason({{"box"}, up}, {}), "\"box\" passes through \"cup\"" + first);
  EXPECT_EQ(reason({{"cup"}, up}, {}), "\"cup\" passes through \"box\"" + first);
  EXPECT_EQ(reason({{"box"}, up}, {"cup"}), "\"box\" passes through \"cup\"" + first);
  EXPECT_EQ(reason({{"cube"}, up}, {}), "");
}

TEST(Invalid, MovesBothAsOne) {
  Crossed s;
  s.options = test::objects_alone();
  TranslateOperation o{{"box"}, Vec3(0, 0, 0.5)};
  o.free = true;
  o.together = {"cup"};
  s.go(o);
  EXPECT_EQ(s.at("box").state, ObjectState::Invalid);
  const OperationResult out =
      perform(s.scene, PutOperation{{"cup"}, {{}, Vec3(1, 1, 1)}, {}}, s.options);
  EXPECT_TRUE(out.ok()) << out.reason();
  EXPECT_EQ(s.at("box").state, ObjectState::Unsupported);
}

}  // namespace
}  // namespace trivet
