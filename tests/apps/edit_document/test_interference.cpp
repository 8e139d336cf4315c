// Highlighted faces during a blocked drag and while objects interpenetrate.
#include "apps/edit_document/hand.h"
#include "core/contact/triangle_distance.h"

namespace trivet::edit::test {
namespace {

class Interference : public testing::Test {
 protected:
  Interference() : document(folder.file("recovery")), toolbox(*document), hand(document, toolbox) {
    document.done(document->open_demo("breakfast"));
    hand.look_at(document->snapshot()->box());
  }

  /// Keeps the button down; returns the snapshot in which the drag was blocked.
  std::shared_ptr<const SceneSnapshot> drag_until_blocked(const std::string& name) {
    for (const Vec2& way : {Vec2(200, 0), Vec2(-200, 0), Vec2(0, 120), Vec2(0, -120)}) {
      const auto from = hand.seen(name);
      if (!from) return nullptr;
      hand.press(*from);
      for (int i = 1; i <= 20; ++i) {
        hand.move(*from + way * i / 20);
        document->wait_until_idle();
        const auto snapshot = document->snapshot();
        if (snapshot->drag && !snapshot->drag->blocked_by.name.empty()) return snapshot;
      }
      hand.key(KeyEvent::Key::Escape);
      hand.release(*from);
      document->wait_until_idle();
    }
    return nullptr;
  }

  const FacesOfObject* of(const SceneSnapshot& scene, const InterferingFaces& faces,
                          const std::string& name) {
    for (const FacesOfObject& found : faces.objects)
      if (scene.find(found.id)->object->name == name) return &found;
    return nullptr;
  }

  TemporaryFolder folder;
  Recorder document;
  Toolbox toolbox;
  Hand hand;
};

double distance(const SceneSnapshot& scene, const FacesOfObject& a, const FacesOfObject& b) {
  const auto triangle = [&](ObjectId id, Index face) {
    const Object& object = *scene.find(id)->object;
    Triangle t = object.shape->mesh.triangle(face);
    for (Vec3& p : t) p = object.world_from_object().apply(p);
    return t;
  };
  double nearest = kInfinity;
  for (const Index i : a.faces)
    for (const Index j : b.faces)
      nearest = std::min(nearest, closest_points(triangle(a.id, i), triangle(b.id, j)).distance);
  return nearest;
}

TEST_F(Interference, HighlightsTouchingFacesOfBlockedDrag) {
  toolbox.take(ToolKind::Push);
  const auto blocked = drag_until_blocked("glass_back");
  ASSERT_TRUE(blocked) << "the drag was not blocked";
  const DragSnapshot& drag = *blocked->drag;
  const FacesOfObject* const moved = of(*blocked, drag.faces, "glass_back");
  const FacesOfObject* const stands = of(*blocked, drag.faces, drag.blocked_by.name);
  ASSERT_TRUE(moved && stands) << "blocked by " << drag.blocked_by.name;
  EXPECT_LT(distance(*blocked, *moved, *stands), 1e-5) << "metres: they touch";
  EXPECT_LT(moved->faces.size(), document.object("glass_back").shape->mesh.triangles.size() / 4)
      << "not the whole object";
  // After the release, the message refers to the same faces.
  toolbox.options().settle = false;
  hand.release(hand.px(Vec3::Zero()));
  ASSERT_TRUE(document->wait_until_idle());
  ASSERT_FALSE(document.messages().empty());
  EXPECT_FALSE(document.messages().back().faces.empty()) << document.last_text();
}

TEST_F(Interference, HighlightsCrossingFacesOfFreeMoveUntilResolved) {
  toolbox.take(ToolKind::Move);
  toolbox.options().free = true;
  const auto from = hand.seen("teapot");
  ASSERT_TRUE(from);
  hand.press(*from);
  hand.move(*from + Vec2(0, 10));
  hand.move(*from + Vec2(0, 40));  // down, into the table
  ASSERT_TRUE(document->wait_until_idle());
  auto snapshot = document->snapshot();
  ASSERT_TRUE(snapshot->drag);
  const FacesOfObject* const dragged = of(*snapshot, snapshot->drag->faces, "teapot");
  ASSERT_TRUE(dragged && of(*snapshot, snapshot->drag->faces, "table"));
  const std::vector<Index> faces = dragged->faces;
  EXPECT_FALSE(snapshot->invalid);
  hand.release(*from + Vec2(0, 40));
  ASSERT_TRUE(document->wait_until_idle());
  snapshot = document->snapshot();
  ASSERT_EQ(document.object("teapot").state, ObjectState::Invalid) << document.last_text();
  EXPECT_EQ(document.messages().back().kind, Message::Kind::Warning);
  ASSERT_TRUE(snapshot->invalid);
  ASSERT_EQ(snapshot->invalid->size(), 1u);
  EXPECT_EQ(snapshot->invalid->front().id, document.id("teapot"));
  const FacesOfObject* const lit = of(*snapshot, snapshot->invalid->front().faces, "teapot");
  ASSERT_TRUE(lit);
  EXPECT_EQ(lit->faces, faces) << "as while it was dragged";
  document->undo();
  ASSERT_TRUE(document->wait_until_idle());
  EXPECT_FALSE(document->snapshot()->invalid);
}

}  // namespace
}  // namespace trivet::edit::test
