// Marks of a view over the objects: contacts, gravity line, projection volume, faces that
// interfere, arrows, the tool's handles.
#include <Eigen/Geometry>
#include <QColor>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/edit/window/scene_drawing.h"
#include "ops/placement/neighbourhood.h"

namespace trivet::edit {
namespace {

constexpr double kNormalPx = 26, kNormalOfObject = 0.15;  // length of normals: the shorter of both
constexpr double kHeadPx = 9, kHeadOfArrow = 0.3;         // of arrows: the shorter of both
constexpr size_t kManyPoints = 12;                        // of a contact
constexpr double kPatchOfObject = 0.04;                   // radius of the mark of a contact
constexpr int kPatchSides = 20, kHatchLines = 9;
constexpr size_t kManyFaces = 300;  // above, faces are lit without their edges
const LiveColour kContactColour{0.10f, 0.62f, 0.62f, 1};  // red is for what is wrong
const LiveColour kGravityLine{0.30f, 0.55f, 0.95f, 1};
const LiveColour kVolume{0.10f, 0.62f, 0.62f, 0.5f};  // thinner than hulls
const LiveColour kAxes[4] = {{0.86f, 0.27f, 0.27f, 1},
                             {0.35f, 0.68f, 0.25f, 1},
                             {0.25f, 0.45f, 0.90f, 1},
                             {0.75f, 0.75f, 0.75f, 1}};

LiveColour with_alpha(LiveColour colour, float alpha) {
  colour[3] = alpha;
  return colour;
}

/// Lower end of the gravity line: the floor, or the bottom of the scene.
double foot_height(const SceneSnapshot& scene) {
  if (scene.floor) return 0;
  const Aabb box = scene.box();
  return box.empty() ? 0 : box.lower.z();
}

/// Parallel lines over a convex polygon, at equal distances.
std::vector<std::array<Vec3, 2>> hatch(const std::vector<Vec3>& hull) {
  std::vector<std::array<Vec3, 2>> out;
  if (hull.size() < 3) return out;
  const Vec3 longest = hull[1] - hull[0];
  const Vec3 normal = longest.cross(hull[2] - hull[0]);
  if (!(normal.norm() > 0)) return out;
  const Vec3 across = (longest + normal.normalized().cross(longest)).normalized();
  const auto height = [&](const Vec3& p) { return across.dot(p - hull[0]); };
  double low = 0, high = 0;
  for (const Vec3& p : hull) low = std::min(low, height(p)), high = std::max(high, height(p));
  for (int k = 1; k < kHatchLines; ++k) {
    const double level = low + (high - low) * k / kHatchLines;
    std::vector<Vec3> ends;
    for (size_t i = 0; i < hull.size(); ++i) {
      const Vec3 &a = hull[i], &b = hull[(i + 1) % hull.size()];
      const double from = height(a) - level, to = height(b) - level;
      if ((from < 0) != (to < 0)) ends.push_back(a + from / (from - to) * (b - a));
    }
    if (ends.size() == 2) out.push_back({ends[0], ends[1]});
  }
  return out;
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

}  // namespace

void SceneDrawing::add_active(LiveOverlay& overlay, const View& view) const {
  const auto active = m_document.selection().active();
  const auto snapshot = m_document.snapshot();
  const ObjectSnapshot* const object = active ? snapshot->find(*active) : nullptr;
  if (!object || !(*object)->placed || !m_options.contacts || m_playback.is_on()) return;
  if (!(*object)->fixed) add_gravity_line(overlay, *snapshot, (*object)->centre_of_mass());
  if (!snapshot->drag)
    for (const ObjectContact& entry : (*object)->contacts)
      add_contact(overlay, *object->object, entry.contact, view);
}

void SceneDrawing::add_gravity_line(LiveOverlay& overlay, const SceneSnapshot& scene,
                                    const Vec3& centre) const {
  const Vec3 foot(centre.x(), centre.y(), std::min(foot_height(scene), centre.z()));
  overlay.lines.push_back({centre, foot, kGravityLine, 1.5f, Hidden::Faint});
  overlay.points.push_back({centre, kGravityLine, 4, Hidden::Shown});
  overlay.points.push_back({centre, {1, 1, 1, 1}, 1.8f, Hidden::Shown});
}

// The hull of the contact [Shinya 1995, Fig. 15b]: its outline, and a light hatch.
void SceneDrawing::add_hull(LiveOverlay& overlay, const Contact& contact) const {
  for (const auto& [a, b] : hatch(contact.hull))
    overlay.lines.push_back({a, b, with_alpha(kContactColour, 0.45f), 0.8f, Hidden::Faint});
  if (contact.hull.size() > 1) overlay.add_loop(contact.hull, kContactColour, 1.4f, Hidden::Faint);
  const float radius = contact.points.size() > kManyPoints ? 1.2f : 2.4f;
  for (const ContactPoint& point : contact.points)
    overlay.points.push_back({point.point, kContactColour, radius, Hidden::Faint});
}

// With normals; where there are many points, one for all.
void SceneDrawing::add_contact(LiveOverlay& overlay, const Object& object, const Contact& contact,
                               const View& view) const {
  const Aabb box = world_box(object);
  const double metres = view.metres_per_px(std::max(view.depth(box.centre()), 0.0));
  const double length = std::min(kNormalPx * metres, kNormalOfObject * box.diagonal());
  add_hull(overlay, contact);
  const bool many = contact.points.size() > kManyPoints;
  Vec3 middle = Vec3::Zero();
  for (const ContactPoint& point : contact.points) {
    middle += point.point / double(contact.points.size());
    if (!many)
      overlay.lines.push_back({point.point, point.point + length * point.normal,
                               with_alpha(kContactColour, 0.75f), 1.2f, Hidden::Faint});
  }
  if (many)
    overlay.lines.push_back(
        {middle, middle + length * contact.normal, kContactColour, 1.8f, Hidden::Faint});
}

void SceneDrawing::add_volume(LiveOverlay& overlay, const ProjectionVolume& volume) const {
  for (const auto& [a, b] : volume) overlay.lines.push_back({a, b, kVolume, 1.1f, Hidden::Faint});
}

void SceneDrawing::add_drag(LiveOverlay& overlay) const {
  const auto snapshot = m_document.snapshot();
  if (!snapshot->drag) return;
  const DragSnapshot& drag = *snapshot->drag;
  add_volume(overlay, drag.volume);
  for (const Contact& contact : drag.contacts) add_hull(overlay, contact);
  if (drag.blocked && drag.end != OperationResult::End::Edge)
    overlay.points.push_back({drag.blocked_at, live_colour(m_theme.warning()),
                              drag.faces.empty() ? 7.0f : 4.0f, Hidden::Shown});
}

// The same while it settles: volume and gravity line of what is on its way.
void SceneDrawing::add_playback(LiveOverlay& overlay) const {
  const std::vector<ObjectId> moving = m_playback.on_the_way();
  const std::optional<Motion> motion = m_playback.motion();
  const auto snapshot = m_document.snapshot();
  if (moving.empty() || !motion || !m_options.contacts) return;
  std::vector<Body> bodies;
  bodies.reserve(moving.size());
  for (const ObjectId id : moving)
    if (const ObjectSnapshot* const object = snapshot->find(id))
      bodies.push_back(body_of(*object->object, m_playback.pose_of(*object)));
  add_volume(overlay, projection_volume(bodies, *motion));
  const ObjectSnapshot* const first = snapshot->find(moving.front());
  if (!first) return;
  Object shown = *first->object;
  shown.pose = m_playback.pose_of(*first);
  add_gravity_line(overlay, *snapshot, shown.centre_of_mass());
}

// Draws interfering faces, including those of a message.
void SceneDrawing::add_interference(LiveOverlay& overlay) const {
  if (m_playback.is_on()) return;
  const auto snapshot = m_document.snapshot();
  if (snapshot->invalid)
    for (const InvalidObject& object : *snapshot->invalid)
      if (!is_dragged(object.id)) add_crossing(overlay, object.faces);
  if (!snapshot->drag) {
    if (!m_lit.points.empty()) add_patch(overlay, m_lit.faces, m_lit.points.front());
    return;
  }
  if (snapshot->drag->blocked)
    add_patch(overlay, snapshot->drag->faces, snapshot->drag->blocked_at);
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

// A mark where something stops a motion: a small disc on the first of the touching faces, which
// may be as large as a wall.
void SceneDrawing::add_patch(LiveOverlay& overlay, const InterferingFaces& faces,
                             const Vec3& at) const {
  for (const FacesOfObject& of : faces.objects)
    for (const Triangle& t : triangles_of(*m_document.snapshot(), of)) {
      const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
      const ObjectSnapshot* const object = m_document.snapshot()->find(of.id);
      if (!(normal.norm() > 0) || !object) continue;
      const double radius = kPatchOfObject * world_box(*object->object).diagonal();
      const Vec3 side = normal.normalized().unitOrthogonal();
      const Vec3 other = normal.normalized().cross(side);
      std::vector<Vec3> disc;
      for (int i = 0; i < kPatchSides; ++i) {
        const double angle = 2 * std::numbers::pi * i / kPatchSides;
        disc.push_back(at + radius * (std::cos(angle) * side + std::sin(angle) * other));
      }
      overlay.add_polygon(disc, live_colour(m_theme.warning(), 0.45f), Hidden::Shown);
      overlay.add_loop(disc, live_colour(m_theme.warning()), 1.5f, Hidden::Shown);
      return;
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
    if (line.role == Overlay::Role::Snap) colour = {1, 0.85f, 0.25f, 1}, width = 2.2f;
    if (line.role == Overlay::Role::Hint) width = 1.5f;
    const Hidden hidden = line.role == Overlay::Role::Hint ? Hidden::Faint : Hidden::Shown;
    if ((line.a - line.b).norm() > 0)
      overlay.lines.push_back({line.a, line.b, colour, width, hidden});
    else
      overlay.points.push_back({line.a, colour, 2 * width, hidden});
  }
}

}  // namespace trivet::edit
