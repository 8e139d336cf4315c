// Latency from mouse move to new pose in BREAKFAST, through the editor's own event path. Prints the
// figure; the goal, 8 ms, is for an idle machine, so a busy one does not fail the test.
#include <algorithm>
#include <cstdio>
#include <ctime>

#include "apps/edit_document/hand.h"

namespace trivet::edit::test {
namespace {

constexpr double kHangsMs = 2000;

TEST(Response, MeasuresLatencyFromMouseMoveToNewPose) {
  TemporaryFolder folder;
  Recorder document(folder.file("recovery"));
  ASSERT_TRUE(document.done(document->open_demo("breakfast"))) << document.last_text();
  Toolbox toolbox(*document);
  Hand hand(document, toolbox);
  hand.look_at(document->snapshot()->box());
  for (const ToolKind kind : {ToolKind::Push, ToolKind::Move}) {
    toolbox.take(kind);
    std::vector<double> all;
    int num_poses = 0;
    Vec3 last = Vec3::Zero();
    std::string dragged;
    const std::clock_t began = std::clock();
    const auto counting = QObject::connect(&*document, &Document::snapshot_changed, [&] {
      if (!document->snapshot()->drag) return;
      const Vec3 now = document.object(dragged).pose.translation;
      num_poses += now != last;
      last = now;
    });
    for (const char* name : {"teapot", "plate_front", "bowl", "glass_back", "jug", "loaf"}) {
      dragged = name;
      const auto at = hand.seen(name);
      ASSERT_TRUE(at) << name;
      hand.drag(*at, *at + Vec2(25, kind == ToolKind::Push ? -12 : -40), 20);
      const auto& took = document->drag_milliseconds();
      all.insert(all.end(), took.begin(), took.end());
    }
    QObject::disconnect(counting);
    const double cpu_ms = 1e3 * double(std::clock() - began) / CLOCKS_PER_SEC;
    ASSERT_GE(all.size(), 60u);
    EXPECT_GT(num_poses, 20);
    std::sort(all.begin(), all.end());
    std::printf(
        "%s: %zu moves, %d new poses, median %.2f ms, 90 %% %.2f ms, largest %.2f ms; "
        "of processor time, with picks, commits and ghosts, %.2f ms each\n",
        kind == ToolKind::Push ? "push" : "translate", all.size(), num_poses, all[all.size() / 2],
        all[all.size() * 9 / 10], all.back(), cpu_ms / double(all.size()));
    EXPECT_LT(all[all.size() / 2], kHangsMs);
  }
}

}  // namespace
}  // namespace trivet::edit::test
