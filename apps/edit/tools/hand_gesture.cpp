#include "apps/edit/tools/hand_gesture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/edit/tools/hand_ghost.h"
#include "apps/edit/tools/placing.h"

namespace trivet::edit {
namespace {

constexpr double kLevel = 0.95;       // z of the normal of a surface to slide on
constexpr double kSameHeight = 0.02;  // of the object's size: surfaces of one level
constexpr double kBesideRoom = 0.01;  // of its size, from a wall
constexpr double kFarBack = 0.3;      // of its size, behind the mouse

}  // namespace

HandGesture::HandGesture(Document& document, const ToolOptions& options)
    : m_document(document), m_options(options), m_turn(document, [this] { update(); }) {
  m_snapshot = QObject::connect(&document, &Document::snapshot_changed, [this] {
    if (is_on() && m_slides) show_rest_of_slide();
  });
  m_ended = QObject::connect(&document, &Document::drag_ended, [this] { m_pushes = false; });
}

HandGesture::~HandGesture() {
  QObject::disconnect(m_snapshot);
  QObject::disconnect(m_ended);
}

const ObjectSnapshot* HandGesture::object() const {
  return m_object ? m_document.snapshot()->find(*m_object) : nullptr;
}

void HandGesture::begin(const View& view, const Vec2& grabbed_px) {
  const SceneSnapshot& scene = *m_document.snapshot();
  m_object = m_document.selection().active();
  if (!object()) return m_object.reset();
  m_start = object()->object;
  m_turn.take(m_object);
  m_moving = with_loads(scene, *m_object);
  for (const ObjectId hidden : m_document.looks().hidden()) m_moving.push_back(hidden);
  m_foot = place_of(*m_start).point;
  m_size = world_box(*m_start).diagonal();
  m_several = m_document.selection().objects.size() > 1;
  m_foot_offset = view.project(m_foot).value_or(grabbed_px) - grabbed_px;
  m_last_px = grabbed_px;
  m_px = view.metres_per_px(view.depth(m_foot));
  m_at = {std::nullopt, m_foot, Vec3::UnitZ(), 0, 0};
  m_lift = 0;
  m_in_front.reset();
  m_beside.reset();
  const auto there = pick(scene, view.seen_ray(foot_px(grabbed_px)), m_moving);
  if (there && there->object && !is_level_support(*there)) m_in_front = there->object;
  auto push = operation_of<PushOperation>(*m_start, m_document, m_options);
  set_push_options(m_options, *m_start, push);
  m_document.begin_drag(push);
  m_pushes = true;
}

// The ray passes through the object that hid the foot at first, until the foot is clear of it.
std::optional<Picked> HandGesture::under_foot(const PointerEvent& event) {
  const SceneSnapshot& scene = *m_document.snapshot();
  const Ray ray = event.view.seen_ray(foot_px(event.px));
  auto at = pick(scene, ray, m_moving);
  if (!m_in_front) return at;
  if (!at || at->object != m_in_front) {
    m_in_front.reset();
    return at;
  }
  std::vector<ObjectId> except = m_moving;
  except.push_back(*m_in_front);
  return pick(scene, ray, except);
}

bool HandGesture::is_level_support(const Picked& at) const {
  if (at.normal.z() < kLevel || std::abs(at.point.z() - m_foot.z()) > kSameHeight * m_size)
    return false;
  const Support with = at.object ? Support(*at.object) : Support::floor();
  return std::any_of(
      m_start->contacts.begin(), m_start->contacts.end(),
      [&](const ObjectContact& entry) { return entry.with == with && holds_up(entry); });
}

// The surface beside a wall, where the object has room: the floor of a box or a bowl, or what the
// thing stands on.
std::optional<Picked> HandGesture::beside(const Picked& wall) const {
  const Vec3 away(wall.normal.x(), wall.normal.y(), 0);
  if (!(away.norm() > 0.1)) return std::nullopt;
  const Vec3 way = away.normalized();
  const double reach = way.cwiseAbs().dot(world_box(*m_start).half_extent()) + kBesideRoom * m_size;
  auto below = pick(*m_document.snapshot(), {wall.point + reach * way, -Vec3::UnitZ()}, m_moving);
  if (!below || is_wall(*below)) return std::nullopt;
  return below;
}

void HandGesture::follow(const PointerEvent& event, const std::optional<Picked>& at) {
  if (event.modifiers.shift) {
    m_lift = std::max(0.0, m_lift + m_px * (m_last_px.y() - event.px.y()));
  } else {
    const auto level = on_plane(event.view.ray(foot_px(event.px)), m_foot, Vec3::UnitZ());
    m_beside = at && is_wall(*at) ? beside(*at) : std::nullopt;
    if (at && !is_wall(*at))
      m_at = *at;
    else if (m_beside && !is_level_support(*m_beside))
      m_at = *std::exchange(m_beside, std::nullopt);
    else if (level)
      m_at = {std::nullopt, *level, -Vec3::UnitZ(), 0, 0};
    for (int k = 0; k < 2; ++k) m_at.point[k] = rounded(m_at.point[k], m_px / kGoalsPerPx);
  }
  m_last_px = event.px;
  update();
}

bool HandGesture::hangs_far_back() const {
  const auto& drag = m_document.snapshot()->drag;
  const ObjectSnapshot* const now = object();
  if (!drag || !drag->blocked || !now) return false;
  const Vec3 here = m_foot + (*now)->pose.translation - m_start->pose.translation;
  return (put_at().point - here).head<2>().norm() > kFarBack * m_size;
}

// The place where the object is put if it does not slide: beside a wall, not behind it.
const Picked& HandGesture::put_at() const { return m_beside ? *m_beside : m_at; }

bool HandGesture::slides() const {
  if (!m_pushes || !m_document.is_dragging()) return false;
  if (m_several) return true;
  if (m_turn.is_turned() || m_lift > 0) return false;
  if (is_wall(m_at)) return !m_beside || !hangs_far_back();
  return is_level_support(m_at) && !hangs_far_back();
}

void HandGesture::update() {
  if (!is_on()) return;
  m_slides = slides();
  if (!m_slides) return m_document.request_ghost_in_hand(choices());
  const Vec3 goal = m_start->pose.translation + m_at.point - m_foot;
  m_document.drag_to(Vec3(goal.x(), goal.y(), 0));
}

// The place where the object comes to rest if it is let go as it slides now.
void HandGesture::show_rest_of_slide() {
  if (!slides()) return update();
  const ObjectSnapshot* const now = object();
  if (!now || m_several) return;
  PutOperation put = put_in_hand();
  put.start = (*now)->pose;
  m_document.request_ghost(put);
}

PutOperation HandGesture::put_in_hand() const {
  auto put = operation_of<PutOperation>(*m_start, m_document, m_options);
  put.tries = kTriesInHand;
  return put;
}

std::vector<Operation> HandGesture::choices() const {
  Object turned = *m_start;
  turned.pose.rotation = m_turn.of(m_start->pose.rotation);
  return put_choices(*m_document.snapshot(), turned, m_moving, put_at(), put_in_hand(),
                     m_options.drop_height, m_lift);
}

// The place where the hand took it up, to a pixel.
bool HandGesture::is_back() const {
  const auto& drag = m_document.snapshot()->drag;
  return (m_at.point - m_foot).head<2>().norm() < m_px && !(drag && drag->blocked);
}

void HandGesture::release() {
  if (!is_on()) return;
  if (!let_go()) m_document.cancel_drag();
  end();
}

// False: it is back where it was taken up, or no place was shown.
bool HandGesture::let_go() {
  if (m_slides && is_back()) return false;
  if (m_slides && falls_from_edge()) {
    m_document.perform_first({m_document.ghost()->operation});
    return true;
  }
  if (m_slides || hangs_back_from_all()) {
    m_document.end_drag();
    return true;
  }
  return put_as_shown(m_document, *m_object, *m_start, choices());
}

// Beyond the edge at which a PUSH stops: let go there, it falls as its ghost shows.
bool HandGesture::falls_from_edge() const {
  const auto& drag = m_document.snapshot()->drag;
  const std::optional<Ghost>& ghost = m_document.ghost();
  return drag && drag->blocked && drag->end == OperationResult::End::Edge &&
         m_document.is_ghost_current() && ghost->ok && ghost->object == m_object;
}

// It can be put nowhere that the mouse has pointed to: it stays where it slid.
bool HandGesture::hangs_back_from_all() const {
  const std::optional<Ghost>& ghost = m_document.ghost();
  return m_pushes && m_document.is_dragging() && m_document.is_ghost_current() && !ghost->ok;
}

void HandGesture::cancel() {
  m_document.cancel_drag();
  end();
}

void HandGesture::end() {
  m_object.reset();
  m_turn.take(std::nullopt);
  m_pushes = m_slides = false;
  m_document.clear_ghost();
}

}  // namespace trivet::edit
