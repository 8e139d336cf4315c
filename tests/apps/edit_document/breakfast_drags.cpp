#include "apps/edit_document/breakfast_drags.h"

#include <stdexcept>

namespace trivet::edit::test {

void append(const Pose& pose, Poses& out) {
  const Rotation& r = pose.rotation;
  out.insert(out.end(), {r.w, r.x, r.y, r.z, pose.translation.x(), pose.translation.y(),
                         pose.translation.z()});
}

BackendOptions backend(Backend which) {
  BackendOptions options;
  options.backend = which;
  return options;
}

Table::Table(BackendOptions detection)
    : document(folder.file("recovery"), std::move(detection)),
      toolbox(*document),
      hand(document, toolbox) {
  QObject::connect(&*document, &Document::snapshot_changed, [this] {
    const auto snapshot = document->snapshot();
    if (!snapshot->drag) return;
    for (const ObjectId id : snapshot->drag->moving) append((*snapshot->find(id))->pose, poses);
  });
  QObject::connect(&*document, &Document::detection_noted,
                   [this](const QString& note) { notes << note; });
  if (!document.done(document->open_demo("breakfast")))
    throw std::runtime_error(document.last_text());
  hand.look_at(document->snapshot()->box());
}

void Table::drag(const std::string& name, const Vec2& way) {
  const auto at = hand.seen(name);
  ASSERT_TRUE(at) << name;
  hand.drag(*at, *at + way, 8);
}

void Table::drag_several() {
  toolbox.take(ToolKind::Push);
  drag("teapot", Vec2(40, -12));
  drag("glass_back", Vec2(-60, 10));
  drag("plate_front", Vec2(25, -20));
  toolbox.take(ToolKind::Move);
  drag("jug", Vec2(20, -50));
  drag("bowl", Vec2(-40, 5));
  toolbox.take(ToolKind::Turn);
  drag("loaf", Vec2(30, 30));
  for (const ObjectSnapshot& object : document->snapshot()->objects) append(object->pose, poses);
}

const Poses& poses_of_bvhs() {
  static const Poses poses = [] {
    Table table(backend(Backend::Bvh));
    table.drag_several();
    return table.poses;
  }();
  return poses;
}

}  // namespace trivet::edit::test
