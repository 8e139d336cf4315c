// What a free move left interpenetrating is said to be invalid for as long as it does: whatever is
// done beside it, and whichever of the two goes away.
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
    const OperationResult result = perform(scene, operation);
    EXPECT_TRUE(result.ok()) << result.reason;
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

TEST(Invalid, StaysSoWhateverIsDoneBesideIt) {
  Crossed s;
  s.go(put_at("cube", Vec3(0.02, 0.26, 1)));
  s.go(TranslateOperation{{"cube"}, Vec3(0, -0.05, 0)});
  s.go(PickUpOperation{{"cube"}, 0.3, {}});
  EXPECT_EQ(s.at("box").state, ObjectState::Invalid);
}

TEST(Invalid, IsNoMoreWhenTheOtherIsGone) {
  for (const Operation& operation :
       {Operation{put_at("cup", Vec3(-0.5, 0, 1))}, Operation{DeleteOperation{{"cup"}}}}) {
    Crossed s;
    const OperationResult result = s.go(operation);
    EXPECT_EQ(s.at("box").state, ObjectState::Stable);
    EXPECT_TRUE(result.unsupported.empty());
  }
}

TEST(Invalid, WhatThenHangsInTheAirIsNamed) {
  Crossed s;
  TranslateOperation up{{"box"}, Vec3(0, 0, 0.05)};
  up.free = true;
  s.go(up);
  const OperationResult result = s.go(put_at("cup", Vec3(-0.5, 0, 1)));
  EXPECT_EQ(s.at("box").state, ObjectState::Unsupported);
  EXPECT_EQ(result.unsupported, std::vector<std::string>{"box"});
}

TEST(Invalid, IsALoadThatIsMovedIntoSomething) {
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

TEST(Invalid, AreTwoThatAreMovedAsOne) {
  Crossed s;
  TranslateOperation o{{"box"}, Vec3(0, 0, 0.5)};
  o.free = true;
  o.together = {"cup"};
  s.go(o);
  EXPECT_EQ(s.at("box").state, ObjectState::Invalid);
  const OperationResult out = perform(s.scene, PutOperation{{"cup"}, {{}, Vec3(1, 1, 1)}, {}});
  EXPECT_TRUE(out.ok()) << out.reason;
  EXPECT_EQ(s.at("box").state, ObjectState::Unsupported);
}

}  // namespace
}  // namespace trivet
