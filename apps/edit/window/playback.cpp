#include "apps/edit/window/playback.h"

#include <QApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>

#include "apps/edit/document/drag_motion.h"
#include "core/motion/compose.h"
#include "core/motion/pose_interpolation.h"

namespace trivet::edit {
namespace {

constexpr int kTickMs = 16;
constexpr double kStraightMs = 320;  // duration of an unknown path
// Duration of a known path per length in object sizes, with minimum and maximum.
constexpr double kMsPerSize = 350, kShortestMs = 240, kLongestMs = 1400;
constexpr double kAhead = 0.01;  // of the path: the motion is told from the poses at its ends
constexpr double kApart = 0.01;  // of the object's size: larger differences are not rounding

bool is_on_way(const SceneSnapshot& scene, ObjectId id) {
  return scene.way &&
         std::find(scene.way->moved.begin(), scene.way->moved.end(), id) != scene.way->moved.end();
}

// Objects that move together settle one by one, so they need not end as one rigid body.
bool comes_apart(const SceneSnapshot& before, const SceneSnapshot& now,
                 const ObjectSnapshot& object) {
  const SettledWay& way = *now.way;
  const ObjectSnapshot* const first = before.find(way.moved.front());
  const ObjectSnapshot* const old = before.find(object.id);
  if (!first || !old || !is_same_pose((*first)->pose, way.poses.front())) return false;
  const Pose start = carried_pose(way.poses.front(), way.poses.back(), object->pose);
  return (start.translation - (*old)->pose.translation).norm() > kApart * way.size;
}

double milliseconds_of(const SettledWay& way) {
  return std::clamp(kMsPerSize * way.length() / way.size, kShortestMs, kLongestMs);
}

}  // namespace

Playback::Playback(QObject* parent) : QObject(parent) {
  m_tick.setInterval(kTickMs);
  connect(&m_tick, &QTimer::timeout, this, &Playback::move_on);
}

Playback::~Playback() { end(); }

void Playback::play(const SceneSnapshot& before, std::shared_ptr<const SceneSnapshot> now) {
  end();
  for (const ObjectSnapshot& object : now->objects) {
    const ObjectSnapshot* const old = before.find(object.id);
    if (!old || old->revision == object.revision || !(*old)->placed || !object->placed) continue;
    const bool goes_along = is_on_way(*now, object.id) && !comes_apart(before, *now, object);
    if (goes_along || is_same_pose((*old)->pose, object->pose)) continue;
    m_straight[object.id.index] = (*old)->pose;
  }
  if (!now->way && m_straight.empty()) return;
  m_milliseconds = now->way ? milliseconds_of(*now->way) : kStraightMs;
  m_now = std::move(now);
  m_since.start();
  m_tick.start();
  qApp->installEventFilter(this);
}

void Playback::end() {
  if (!is_on()) return;
  qApp->removeEventFilter(this);
  m_tick.stop();
  m_straight.clear();
  m_now.reset();
}

double Playback::progress() const {
  const double t = std::min(double(m_since.elapsed()) / m_milliseconds, 1.0);
  return t * t * (3 - 2 * t);
}

void Playback::move_on() {
  if (progress() >= 1) end();
  Q_EMIT changed();
}

bool Playback::moves(ObjectId id) const {
  return is_on() && (is_on_way(*m_now, id) || m_straight.count(id.index) > 0);
}

std::vector<ObjectId> Playback::on_the_way() const {
  return is_on() && m_now->way ? m_now->way->moved : std::vector<ObjectId>();
}

std::optional<Motion> Playback::motion() const {
  if (!is_on() || !m_now->way) return std::nullopt;
  const SettledWay& way = *m_now->way;
  const double here = std::min(progress(), 1 - kAhead);
  return motion_between(pose_on(way, here), pose_on(way, here + kAhead), way.size);
}

Pose Playback::pose_of(const ObjectSnapshot& object) const {
  if (!moves(object.id)) return object->pose;
  if (const auto straight = m_straight.find(object.id.index); straight != m_straight.end())
    return interpolate_straight(straight->second, object->pose, progress());
  const SettledWay& way = *m_now->way;
  const Pose first = pose_on(way, progress());
  return object.id == way.moved.front() ? first
                                        : carried_pose(first, way.poses.back(), object->pose);
}

bool Playback::eventFilter(QObject*, QEvent* event) {
  const bool is_key = event->type() == QEvent::KeyPress;
  const bool is_click = event->type() == QEvent::MouseButtonPress &&
                        static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton;
  if (!is_key && !is_click) return false;
  end();
  Q_EMIT changed();
  return is_key && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
}

}  // namespace trivet::edit
