// Cameras of the views.
#include "apps/edit/tools/constraint_camera.h"
#include "apps/edit/window/workspace.h"

namespace trivet::edit {
namespace {

QString aim_note(const Selection& selection) {
  switch (selection.contact ? selection.contact->part : ActiveContact::Part::Area) {
    case ActiveContact::Part::Edge:
      return Workspace::tr("along the held edge of its contact with %1");
    case ActiveContact::Part::Point:
      return Workspace::tr("along the normal at the held point of its contact with %1");
    case ActiveContact::Part::Area:
      break;
  }
  return Workspace::tr("along the normal of its contact with %1");
}

}  // namespace

void Workspace::follow_scene() {
  const auto snapshot = m_document.snapshot();
  // Frames a newly opened scene, or the first object of an empty one.
  const Aabb box = snapshot->box();
  if (box.empty() && !m_is_empty) reset_cameras();
  if ((m_framed_title != m_document.title() || m_is_empty) && !box.empty() && !snapshot->drag) {
    m_framed_title = m_document.title();
    for (SceneView* const view : views()) view->frame(box);
  }
  m_is_empty = box.empty();
  aim_constraint_view();
}

void Workspace::aim_constraint_view() {
  const auto snapshot = m_document.snapshot();
  if (snapshot->drag) return;
  const auto active = m_document.selection().active();
  if (active != m_aimed_at) m_constraint_is_free = false;
  m_aimed_at = active;
  if (m_constraint_is_free) return;
  const View view = constraint_view(*snapshot, m_document.selection(), std::nullopt,
                                    m_constraint->width(), m_constraint->height());
  m_constraint->set_camera(ViewCamera::of(view));
  const ObjectContact* const entry = active_object_contact(m_document.selection(), *snapshot);
  const ObjectSnapshot* const with =
      entry && entry->with.is_object() ? snapshot->find(entry->with.object()) : nullptr;
  m_frames[3]->set_note(
      !entry ? tr("from above")
             : aim_note(m_document.selection())
                   .arg(with ? QString::fromStdString((*with)->name) : tr("the floor")));
}

void Workspace::aim_three_view(const QString& name) {
  ViewCamera camera = m_three->camera();
  const Vec3 target = camera.camera().target;
  const double shown = camera.camera().height.value_or(2);
  const Vec3 direction = name == "top"    ? Vec3(-Vec3::UnitZ())
                         : name == "side" ? Vec3(-Vec3::UnitX())
                                          : Vec3(Vec3::UnitY());
  camera = ViewCamera::orthographic(direction, name == "top" ? Vec3::UnitY() : Vec3::UnitZ());
  camera.look_at(target);
  camera.set_height(shown);
  m_three->set_camera(camera);
  m_three_shows = name;
  Q_EMIT three_view_aimed(name);
}

void Workspace::look_along(const Vec3& direction) {
  SceneView& view = active_view();
  const bool down = direction.z() != 0;
  if (&view == m_three) return aim_three_view(down ? "top" : direction.x() != 0 ? "side" : "front");
  ViewCamera camera = view.camera();
  // From above, a perspective view keeps its up axis for orbits.
  constexpr double kTilt = 0.01;
  const bool flat = &view == m_constraint;
  camera.look_along(down && !flat ? Vec3(0, kTilt, direction.z()) : direction,
                    down && flat ? Vec3::UnitY() : Vec3::UnitZ());
  view.set_camera(camera);
  if (flat) m_constraint_is_free = true;
}

void Workspace::show_camera(WindowKind kind, const ViewCamera& camera) {
  SceneView& shown = view(kind);
  shown.set_camera(camera);
  if (&shown == m_constraint) m_constraint_is_free = true;
  if (&shown != m_three) return;
  const Vec3 back = shown.view().axes().back.cwiseAbs();
  m_three_shows = back.z() > 0.9 ? "top" : back.x() > 0.9 ? "side" : "front";
  Q_EMIT three_view_aimed(m_three_shows);
}

void Workspace::reset_cameras() {
  m_perspective->set_camera(ViewCamera::perspective());
  m_three->set_camera(ViewCamera::orthographic(-Vec3::UnitZ(), Vec3::UnitY()));
  aim_three_view(m_three_shows);
  m_constraint_is_free = false;
  m_constraint->set_camera(ViewCamera::orthographic(-Vec3::UnitZ(), Vec3::UnitY()));
}

void Workspace::follow_contact() {
  m_constraint_is_free = false;
  aim_constraint_view();
}

}  // namespace trivet::edit
