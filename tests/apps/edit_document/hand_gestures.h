// A table and a mouse over it, for things moved by hand without a tool.
#pragma once

#include "apps/edit_document/hand.h"
#include "apps/edit_document/scene_checks.h"

namespace trivet::edit::test {

inline constexpr double kSlack = 2e-3;  // metres

/// A fixed table, 1.2 x 0.8 m, 2 cm thick, seen from the front and above.
class HandGestures : public testing::Test {
 protected:
  HandGestures() : document(folder.file("recovery")), toolbox(*document), hand(document, toolbox) {
    write("table", {{{-0.6, -0.4, 0}, {0.6, 0.4, 0.02}}});
    write("box", {{{-0.05, -0.05, 0}, {0.05, 0.05, 0.1}}});
    write("cup", {{{-0.03, -0.03, 0}, {0.03, 0.03, 0.06}}});
    write("book", {{{-0.02, -0.08, 0}, {0.02, 0.08, 0.2}}});
    write("tray", {{{-0.15, -0.1, 0}, {0.15, 0.1, 0.01}},
                   {{-0.15, -0.1, 0.01}, {-0.145, 0.1, 0.03}},
                   {{0.145, -0.1, 0.01}, {0.15, 0.1, 0.03}}});
    document.import(folder.file("table.obj"), "table", true);
    top = world_box(document.object("table")).upper.z();
    hand.view = View();
    hand.view.width_px = 1280, hand.view.height_px = 720;
    hand.view.eye = Vec3(0, -1.6, 1.2), hand.view.target = Vec3(0, 0, 0.05);
  }

  void write(const std::string& name, const std::vector<Aabb>& boxes) {
    write_boxes(folder.file(name + ".obj"), boxes);
  }

  void put(const std::string& model, const std::string& name, double x, double y, double z = 0.01) {
    document.import(folder.file(model + ".obj"), name);
    PutOperation operation;
    operation.object = name;
    operation.start.translation = Vec3(x, y, top + z);
    if (!document.done(document->perform(operation)))
      throw std::runtime_error(document.last_text());
    document->select({});
    steps = document->history().num_done;
  }

  Vec3 at(const std::string& name) { return document.object(name).pose.translation; }
  Aabb box(const std::string& name) { return world_box(document.object(name)); }

  /// Presses on the middle of an object, and moves so that its foot points there.
  void pull(const std::string& name, const Vec3& to, int num_moves = 8) {
    const Aabb here = box(name);
    from = hand.px(here.centre());
    const Vec2 foot = hand.px(Vec3(here.centre().x(), here.centre().y(), here.lower.z()));
    end = from + hand.px(to) - foot;
    hand.press(from);
    for (int i = 1; i <= num_moves; ++i) move(from + (end - from) * i / num_moves);
  }
  void move(const Vec2& px) {
    hand.move(px);
    document->wait_until_idle();
  }
  /// Lets go. @return whether the object came to rest where the ghost was.
  void let_go() {
    const std::optional<Ghost> ghost = document->ghost();
    hand.release(end);
    document->wait_until_idle();
    EXPECT_EQ(wrong_with(*document->snapshot()), "");
    EXPECT_FALSE(document->ghost());
    if (!ghost || !ghost->ok) return;
    for (const Ghost::Member& member : ghost->members)
      EXPECT_LT((document->snapshot()->find(member.id)->object->pose.translation -
                 member.pose.translation)
                    .norm(),
                1e-6)
          << (*document->snapshot()->find(member.id))->name;
  }
  void drag(const std::string& name, const Vec3& to) {
    pull(name, to);
    let_go();
  }
  size_t new_steps() const { return document->history().num_done - steps; }

  TemporaryFolder folder;
  Recorder document;
  Toolbox toolbox;
  Hand hand;
  double top = 0;
  size_t steps = 0;
  Vec2 from, end;
};

}  // namespace trivet::edit::test
