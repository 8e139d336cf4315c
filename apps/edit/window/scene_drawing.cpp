#include "apps/edit/window/scene_drawing.h"

#include <algorithm>
#include <cmath>

#include "apps/edit/window/live_objects.h"
#include "apps/edit/window/wish_marks.h"

namespace trivet::edit {
namespace {

constexpr double kSamePlace = 0.01;  // of the size; of a turn in radians
constexpr int kRestsMs = 120;        // without motion, after which what is held counts as still

bool moves(const QElapsedTimer& moved) { return moved.isValid() && moved.elapsed() < kRestsMs; }

/// Marks whole objects weakly when faces are lit.
float strength(float alone, bool faces_are_lit) { return faces_are_lit ? 0.35f * alone : alone; }

// A ghost where its object is drawn anyway would only tint it.
std::vector<Ghost::Member> elsewhere(const SceneSnapshot& scene,
                                     std::vector<Ghost::Member> members) {
  std::erase_if(members, [&](const Ghost::Member& member) {
    const ObjectSnapshot* const object = scene.find(member.id);
    if (!object || !(*object)->placed) return false;
    const Pose& here = (*object)->pose;
    const double size = world_box(*object->object).diagonal();
    return (here.translation - member.pose.translation).norm() < kSamePlace * size &&
           (here.rotation.matrix() - member.pose.rotation.matrix()).norm() < kSamePlace;
  });
  return members;
}

}  // namespace

SceneDrawing::SceneDrawing(Document& document, Toolbox& toolbox, QObject* parent)
    : QObject(parent), m_document(document), m_toolbox(toolbox), m_before(document.snapshot()) {
  connect(&m_document, &Document::snapshot_changed, this, &SceneDrawing::follow_document);
  connect(&m_document, &Document::selection_changed, this, &SceneDrawing::changed);
  connect(&m_document, &Document::looks_changed, this, &SceneDrawing::changed);
  connect(&m_document, &Document::ghost_changed, this, [this] {
    m_ghost_moved.start();
    Q_EMIT changed();
  });
  for (const auto signal :
       {&Document::verdict_changed, &Document::wishes_changed, &Document::layout_changed})
    connect(&m_document, signal, this, &SceneDrawing::changed);
  connect(&m_document, &Document::zlists_changed, this, &SceneDrawing::changed);
  connect(&m_document, &Document::message, this, &SceneDrawing::light);
  connect(&m_playback, &Playback::changed, this, &SceneDrawing::changed);
}

bool SceneDrawing::is_moving() const {
  return m_playback.is_on() || moves(m_ghost_moved) ||
         (m_document.snapshot()->drag && moves(m_drag_moved));
}

void SceneDrawing::set_theme(const Theme& theme) {
  m_theme = theme;
  Q_EMIT changed();
}

void SceneDrawing::set_options(const DrawingOptions& options) {
  m_options = options;
  Q_EMIT changed();
}

void SceneDrawing::light(const Message& message) {
  m_lit = message;
  Q_EMIT changed();
}

void SceneDrawing::put_out_lights() {
  if (m_lit.objects.empty() && m_lit.points.empty() && m_lit.faces.empty()) return;
  light({});
}

void SceneDrawing::follow_document() {
  const auto now = m_document.snapshot();
  if (now->committed != m_before->committed) {
    put_out_lights();
    if (m_options.watch_settling)
      m_playback.play(*m_before, now);
    else
      m_playback.end();
  }
  m_before = now;
  if (now->drag) m_drag_moved.start();
  Q_EMIT changed();
}

bool SceneDrawing::is_dragged(ObjectId id) const {
  const auto& drag = m_document.snapshot()->drag;
  return drag && std::find(drag->moving.begin(), drag->moving.end(), id) != drag->moving.end();
}

bool SceneDrawing::stops_drag(const ObjectSnapshot& object) const {
  const auto& drag = m_document.snapshot()->drag;
  return drag && drag->blocked && object->name == drag->blocked_by.name;
}

bool SceneDrawing::is_lit(ObjectId id) const {
  return std::find(m_lit.objects.begin(), m_lit.objects.end(), id) != m_lit.objects.end();
}

LiveColour SceneDrawing::tint_of(const ObjectSnapshot& object) const {
  const auto snapshot = m_document.snapshot();
  if (m_lit.kind == Message::Kind::Warning && is_lit(object.id) && !snapshot->invalid)
    return live_colour(m_theme.warning(), 0.35f);
  switch (object->state) {
    case ObjectState::Invalid:
      return {0.9f, 0.1f, 0.15f, strength(0.55f, snapshot->invalid != nullptr)};
    case ObjectState::Unsupported:
      return {0.95f, 0.55f, 0.1f, 0.45f};
    case ObjectState::Wedged:
      return {0.9f, 0.8f, 0.2f, 0.25f};
    default:
      return look_of(object);
  }
}

// The colour that was chosen for it. What is selected keeps its own: an outline shows it.
LiveColour SceneDrawing::look_of(const ObjectSnapshot& object) const {
  const auto colour = m_document.looks().shown(object.id).colour;
  return colour ? LiveColour{(*colour)[0], (*colour)[1], (*colour)[2], 0.8f} : LiveColour{};
}

LiveScene SceneDrawing::scene(const View& view) const {
  const auto snapshot = m_document.snapshot();
  LiveScene out;
  out.floor = snapshot->floor;
  for (const ObjectSnapshot& object : snapshot->objects) {
    if (!object->placed || m_document.looks().shown(object.id).hidden) continue;
    LiveObject live = live_object(*object.object, m_playback.pose_of(object));
    live.tint = tint_of(object);
    live.outlined = m_document.selection().contains(object.id) || is_lit(object.id);
    live.moving = m_playback.moves(object.id) || is_dragged(object.id);
    out.objects.push_back(std::move(live));
    add_in_the_way(object, out);
  }
  if (snapshot->falling) {
    LiveObject live = live_object(*snapshot->falling, snapshot->falling->pose);
    live.moving = true;
    out.objects.push_back(std::move(live));
  }
  add_ghost(out);
  if (!m_playback.is_on()) add_arrangement(m_document, m_theme, out);
  add_active(out.overlay, view);
  add_drag(out.overlay);
  add_playback(out.overlay);
  add_interference(out.overlay);
  add_toppling(out.overlay, view);
  add_zlists(out.overlay);
  if (!m_playback.is_on()) add_tool(out.overlay, view);  // handles appear at the final pose
  for (const Vec3& point : m_lit.points)
    out.overlay.points.push_back(
        {point, live_colour(m_theme.refused()), m_lit.faces.empty() ? 6.0f : 4.0f, Hidden::Shown});
  return out;
}

// The outline of the blocker, which is drawn once more as if it moved: what stands still need not
// be drawn again whenever it is touched. A table may fill the picture: of what is fixed, the place
// of the contact is marked alone.
void SceneDrawing::add_in_the_way(const ObjectSnapshot& object, LiveScene& scene) const {
  if (!stops_drag(object) || object->fixed) return;
  LiveObject again = scene.objects.back();
  again.outlined = true;
  again.moving = true;
  scene.objects.push_back(std::move(again));
}

void SceneDrawing::add_ghost(LiveScene& scene) const {
  if (!m_document.ghost()) return;
  const Ghost& ghost = *m_document.ghost();
  const auto snapshot = m_document.snapshot();
  if (!ghost.ok && snapshot->drag) return;  // the dragged object is there
  add_ghosts(*snapshot, elsewhere(*snapshot, ghost.members),
             ghost.ok ? live_colour(m_theme.accent(), 0.45f) : live_colour(m_theme.lit(), 0.7f),
             scene);
  if (ghost.ok) return;
  for (const Vec3& point : ghost.points)
    scene.overlay.points.push_back({point, live_colour(m_theme.refused()), 6, Hidden::Shown});
}

}  // namespace trivet::edit
