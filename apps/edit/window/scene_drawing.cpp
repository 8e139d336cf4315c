#include "apps/edit/window/scene_drawing.h"

#include <algorithm>
#include <cmath>

namespace trivet::edit {
namespace {

constexpr int kGhostRestsMs = 120;  // without motion, after which it counts as still
constexpr double kNormalPx = 26, kNormalOfObject = 0.15;  // length of normals: the shorter of both
constexpr double kHeadPx = 9, kHeadOfArrow = 0.3;         // of arrows: the shorter of both
constexpr size_t kManyPoints = 12;                        // of a contact
constexpr size_t kManyFaces = 300;  // above, faces are lit without their edges
const LiveColour kContactRed{0.92f, 0.20f, 0.18f, 1};
const LiveColour kGravityLine{0.30f, 0.55f, 0.95f, 1};
const LiveColour kBox{0.55f, 0.62f, 0.72f, 0.8f};
const LiveColour kAxes[4] = {{0.86f, 0.27f, 0.27f, 1},
                             {0.35f, 0.68f, 0.25f, 1},
                             {0.25f, 0.45f, 0.90f, 1},
                             {0.75f, 0.75f, 0.75f, 1}};

LiveColour with_alpha(LiveColour colour, float alpha) {
  colour[3] = alpha;
  return colour;
}

LiveObject live_object(const Object& object, const Pose& pose) {
  LiveObject out;
  out.model = object.model;
  out.world_from_object = world_from_object(pose, object.up, object.scale);
  return out;
}

/// Lower end of the gravity line: the floor, or the bottom of the scene.
double foot_height(const SceneSnapshot& scene) {
  if (scene.floor) return 0;
  const Aabb box = scene.box();
  return box.empty() ? 0 : box.lower.z();
}

std::vector<Triangle> triangles_of(const SceneSnapshot& scene, const FacesOfObject& of) {
  std::vector<Triangle> out;
  const ObjectSnapshot* const object = scene.find(of.id);
  if (!object) return out;
  const Affine world = (*object)->world_from_object();
  for (const Index face : of.faces) {
    out.push_back((*object)->shape->mesh.triangle(face));
    for (Vec3& corner : out.back()) corner = world.apply(corner);
  }
  return out;
}

/// Marks whole objects weakly when faces are lit.
float strength(float alone, bool faces_are_lit) { return faces_are_lit ? 0.35f * alone : alone; }

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
  connect(&m_document, &Document::verdict_changed, this, &SceneDrawing::changed);
  connect(&m_document, &Document::zlists_changed, this, &SceneDrawing::changed);
  connect(&m_document, &Document::message, this, &SceneDrawing::light);
  connect(&m_playback, &Playback::changed, this, &SceneDrawing::changed);
}

bool SceneDrawing::is_moving() const {
  return m_playback.is_on() || m_document.snapshot()->drag ||
         (m_ghost_moved.isValid() && m_ghost_moved.elapsed() < kGhostRestsMs);
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

LiveColour SceneDrawing::tint_of(const ObjectSnapshot& object) const {
  const auto snapshot = m_document.snapshot();
  if (stops_drag(object))
    return live_colour(m_theme.refused(), strength(0.45f, !snapshot->drag->faces.empty()));
  const bool is_lit =
      std::find(m_lit.objects.begin(), m_lit.objects.end(), object.id) != m_lit.objects.end();
  const bool warns = m_lit.kind == Message::Kind::Warning;
  const bool is_done = warns || m_lit.kind == Message::Kind::Info;
  const bool faces = snapshot->invalid || !m_lit.faces.empty();
  if (is_lit && !(is_done && faces))
    return !is_done ? live_colour(m_theme.refused(), 0.5f)
                    : live_colour(warns ? m_theme.warning() : m_theme.information(), 0.35f);
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

// The colour that was chosen for it; of several selected objects, those that are not the active one
// are told apart.
LiveColour SceneDrawing::look_of(const ObjectSnapshot& object) const {
  const Selection& selection = m_document.selection();
  if (selection.contains(object.id) && selection.active() != object.id)
    return live_colour(m_theme.accent(), 0.3f);
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
    live.outlined = m_document.selection().contains(object.id);
    live.moving = m_playback.moves(object.id) || is_dragged(object.id);
    out.objects.push_back(std::move(live));
  }
  add_ghost(out);
  add_active(out, view);
  add_drag(out);
  add_interference(out.overlay);
  add_toppling(out.overlay, view);
  add_zlists(out.overlay);
  if (!m_playback.is_on()) add_tool(out.overlay, view);  // handles appear at the final pose
  for (const Vec3& point : m_lit.points)
    out.overlay.points.push_back(
        {point, live_colour(m_theme.refused()), m_lit.faces.empty() ? 6.0f : 4.0f, Hidden::Shown});
  return out;
}

void SceneDrawing::add_ghost(LiveScene& scene) const {
  if (!m_document.ghost()) return;
  const Ghost& ghost = *m_document.ghost();
  const auto snapshot = m_document.snapshot();
  if (!ghost.ok && snapshot->drag) return;  // the dragged object is there
  for (const Ghost::Member& member : ghost.members) {
    const ObjectSnapshot* const object = snapshot->find(member.id);
    if (!object) continue;
    LiveObject live = live_object(*object->object, member.pose);
    live.opacity = 0.55f;
    live.tint = ghost.ok ? live_colour(m_theme.accent(), 0.45f) : live_colour(m_theme.lit(), 0.7f);
    live.moving = true;
    scene.objects.push_back(std::move(live));
  }
  if (ghost.ok) return;
  for (const Vec3& point : ghost.points)
    scene.overlay.points.push_back({point, live_colour(m_theme.refused()), 6, Hidden::Shown});
}

void SceneDrawing::add_active(LiveScene& scene, const View& view) const {
  const auto active = m_document.selection().active();
  const auto snapshot = m_document.snapshot();
  const ObjectSnapshot* const object = active ? snapshot->find(*active) : nullptr;
  if (!object || !(*object)->placed || !m_options.contacts || m_playback.is_on()) return;
  LiveOverlay& overlay = scene.overlay;
  if (!(*object)->fixed) {
    const Vec3 centre = (*object)->centre_of_mass();
    const Vec3 foot(centre.x(), centre.y(), std::min(foot_height(*snapshot), centre.z()));
    overlay.lines.push_back({centre, foot, kGravityLine, 1.5f, Hidden::Faint});
    overlay.points.push_back({centre, kGravityLine, 4, Hidden::Shown});
    overlay.points.push_back({centre, {1, 1, 1, 1}, 1.8f, Hidden::Shown});
  }
  if (!snapshot->drag) add_contacts(overlay, *object->object, view);
}

void SceneDrawing::add_contacts(LiveOverlay& overlay, const Object& object,
                                const View& view) const {
  const Aabb box = world_box(object);
  const double metres = view.metres_per_px(std::max(view.depth(box.centre()), 0.0));
  const double length = std::min(kNormalPx * metres, kNormalOfObject * box.diagonal());
  for (const ObjectContact& entry : object.contacts) {
    const Contact& contact = entry.contact;
    overlay.add_polygon(contact.hull, with_alpha(kContactRed, 0.30f), Hidden::Faint);
    if (contact.hull.size() > 1) overlay.add_loop(contact.hull, kContactRed, 1.8f, Hidden::Faint);
    // For many points, marks only the corners of the hull, and one normal for all.
    const bool many = contact.points.size() > kManyPoints;
    Vec3 middle = Vec3::Zero();
    for (const ContactPoint& point : contact.points) {
      middle += point.point / double(contact.points.size());
      overlay.points.push_back({point.point, kContactRed, many ? 1.5f : 3, Hidden::Faint});
      if (!many)
        overlay.lines.push_back({point.point, point.point + length * point.normal,
                                 with_alpha(kContactRed, 0.75f), 1.2f, Hidden::Faint});
    }
    if (many)
      overlay.lines.push_back(
          {middle, middle + length * contact.normal, kContactRed, 1.8f, Hidden::Faint});
  }
}

void SceneDrawing::add_drag(LiveScene& scene) const {
  const auto snapshot = m_document.snapshot();
  if (!snapshot->drag) return;
  const DragSnapshot& drag = *snapshot->drag;
  Aabb box;
  for (const ObjectId id : drag.moving)
    if (const ObjectSnapshot* const object = snapshot->find(id))
      box.extend(world_box(*object->object));
  if (!box.empty()) scene.overlay.add_box(box, kBox, 1, Hidden::Faint);
  for (const ContactPoint& point : drag.contacts)
    scene.overlay.points.push_back({point.point, kContactRed, 3, Hidden::Faint});
  if (drag.blocked && drag.end != OperationResult::End::Edge)
    scene.overlay.points.push_back({drag.blocked_at, live_colour(m_theme.refused()),
                                    drag.faces.empty() ? 7.0f : 4.0f, Hidden::Shown});
}

// Draws interfering faces, including those of a message.
void SceneDrawing::add_interference(LiveOverlay& overlay) const {
  if (m_playback.is_on()) return;
  const auto snapshot = m_document.snapshot();
  if (snapshot->invalid)
    for (const InvalidObject& object : *snapshot->invalid)
      if (!is_dragged(object.id)) add_crossing(overlay, object.faces);
  if (!snapshot->drag) return add_blocking(overlay, m_lit.faces);
  if (snapshot->drag->blocked)
    add_blocking(overlay, snapshot->drag->faces);
  else
    add_crossing(overlay, snapshot->drag->faces);
}

// Crossing faces may be large: geometry in front of them, and on them, stays visible.
void SceneDrawing::add_crossing(LiveOverlay& overlay, const InterferingFaces& faces) const {
  const LiveColour area = live_colour(m_theme.lit(), 0.4f), edge = live_colour(m_theme.lit(), 0.8f);
  for (const FacesOfObject& of : faces.objects)
    for (const Triangle& t : triangles_of(*m_document.snapshot(), of)) {
      overlay.triangles.push_back({t, area, Hidden::Cut});
      if (of.faces.size() <= kManyFaces) overlay.add_loop({t[0], t[1], t[2]}, edge, 1, Hidden::Cut);
    }
}

// Touching faces are hidden by their own objects: their edges are drawn on top.
void SceneDrawing::add_blocking(LiveOverlay& overlay, const InterferingFaces& faces) const {
  const LiveColour area = live_colour(m_theme.lit(), 0.75f), edge = live_colour(m_theme.lit());
  for (const FacesOfObject& of : faces.objects)
    for (const Triangle& t : triangles_of(*m_document.snapshot(), of)) {
      overlay.triangles.push_back({t, area, Hidden::Faint});
      if (of.faces.size() <= kManyFaces)
        overlay.add_loop({t[0], t[1], t[2]}, edge, 1.5f, Hidden::Shown);
    }
}

// An arrow for what topples, the way it goes.
void SceneDrawing::add_toppling(LiveOverlay& overlay, const View& view) const {
  const auto snapshot = m_document.snapshot();
  const auto verdict = m_document.verdict();
  if (!verdict || snapshot->drag || m_playback.is_on()) return;
  const LiveColour colour = live_colour(m_theme.refused());
  for (const ObjectStability& o : verdict->stability.objects) {
    const ObjectSnapshot* const object = o.topples ? snapshot->find(o.object) : nullptr;
    const auto arrow = object ? toppling_arrow(*object->object, o) : std::nullopt;
    if (!arrow) continue;
    const Vec3 way = arrow->to - arrow->from;
    const double metres = view.metres_per_px(std::max(view.depth(arrow->to), 0.0));
    const double head = std::min(kHeadOfArrow * way.norm(), kHeadPx * metres);
    const Vec3 side = head * way.unitOrthogonal(), back = head * 1.6 * way.normalized();
    const Vec3 other = way.normalized().cross(side);
    overlay.points.push_back({arrow->from, colour, 4, Hidden::Shown});
    overlay.lines.push_back({arrow->from, arrow->to, colour, 3, Hidden::Shown});
    for (const Vec3& barb : {side, Vec3(-side), other, Vec3(-other)})
      overlay.lines.push_back({arrow->to, arrow->to - back + barb, colour, 3, Hidden::Shown});
  }
}

// Pairs of faces of the z-list view, for as long as its motion is under the hand.
void SceneDrawing::add_zlists(LiveOverlay& overlay) const {
  const std::shared_ptr<const ZListView> view = m_document.zlists();
  const auto snapshot = m_document.snapshot();
  const bool in_hand = snapshot->drag || m_document.ghost();
  if (!view || !in_hand || view->committed != snapshot->committed) return;
  const auto add = [&](const std::vector<Triangle>& faces, const QColor& colour) {
    for (const Triangle& t : faces) {
      overlay.triangles.push_back({t, live_colour(colour, 0.6f), Hidden::Faint});
      overlay.add_loop({t[0], t[1], t[2]}, live_colour(colour), 1.2f, Hidden::Shown);
    }
  };
  add(view->fixed_faces, m_theme.fixed_face());
  add(view->moving_faces, m_theme.moving_face());
}

void SceneDrawing::add_tool(LiveOverlay& overlay, const View& view) const {
  for (const edit::Overlay::Line& line : m_toolbox.overlay(view).lines) {
    LiveColour colour = line.axis >= 0 && line.axis < 4 ? kAxes[line.axis] : kGravityLine;
    float width = 2.5f;
    if (line.role == Overlay::Role::HotHandle) colour = {1, 0.85f, 0.25f, 1}, width = 3.5f;
    if (line.role == Overlay::Role::HoverEdge) colour = {1, 0.65f, 0.1f, 1}, width = 4;
    if (line.role == Overlay::Role::Hint) width = 1.5f;
    const Hidden hidden = line.role == Overlay::Role::Hint ? Hidden::Faint : Hidden::Shown;
    if ((line.a - line.b).norm() > 0)
      overlay.lines.push_back({line.a, line.b, colour, width, hidden});
    else
      overlay.points.push_back({line.a, colour, 2 * width, hidden});
  }
}

}  // namespace trivet::edit
