#include "apps/edit/document/scene_verdict.h"

#include <Eigen/Geometry>
#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "apps/edit/document/margins.h"
#include "core/base/quoted.h"
#include "ops/files/report/verdict.h"

namespace trivet::edit {
namespace {

constexpr double kArrowOfObject = 0.5;  // length, of its size
constexpr size_t kMostNames = 3;

std::string said(const QString& text) { return text.toStdString(); }

std::string names_of_what_topples(const SceneSnapshot& scene, const Stability& stability) {
  std::string out;
  size_t count = 0;
  for (const ObjectStability& o : stability.objects) {
    const ObjectSnapshot* const object = o.topples ? scene.find(o.object) : nullptr;
    if (!object) continue;
    if (++count > kMostNames) continue;
    out += (out.empty() ? "" : ", ") + quoted((*object)->name);
  }
  if (count > kMostNames)
    out += said(QCoreApplication::translate("verdict", " and %1 more").arg(count - kMostNames));
  return out;
}

// The direction stays as it is.
std::string way_in_words(const std::string& way) {
  for (const char* const known :
       {QT_TRANSLATE_NOOP("verdict", "tips towards"),
        QT_TRANSLATE_NOOP("verdict", "slides towards"),
        QT_TRANSLATE_NOOP("verdict", "turns about the vertical"),
        QT_TRANSLATE_NOOP("verdict", "moves"), QT_TRANSLATE_NOOP("verdict", "sinks")})
    if (way.rfind(known, 0) == 0)
      return said(QCoreApplication::translate("verdict", known)) + way.substr(std::strlen(known));
  return way;
}

}  // namespace

const ObjectStability* SceneVerdict::find(ObjectId id) const {
  const auto it = std::find_if(stability.objects.begin(), stability.objects.end(),
                               [&](const ObjectStability& o) { return o.object == id; });
  return it == stability.objects.end() ? nullptr : &*it;
}

std::optional<TopplingArrow> toppling_arrow(const Object& object, const ObjectStability& verdict) {
  if (!verdict.topples) return std::nullopt;
  const double size = object.scale * object.shape->box.diagonal();
  const Vec3 centre = object.centre_of_mass();
  // Corners of the box: where the motion of the body is fastest.
  const Affine world = object.world_from_object();
  Vec3 from = centre, fastest = verdict.motion.velocity;
  const Vec3 &low = object.shape->box.lower, &high = object.shape->box.upper;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner = world.apply(
        Vec3(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z()));
    const Vec3 velocity = verdict.motion.velocity + verdict.motion.spin.cross(corner - centre);
    if (velocity.norm() > 1.01 * fastest.norm()) from = corner, fastest = velocity;
  }
  if (!(fastest.norm() > 0)) return std::nullopt;
  return TopplingArrow{from, from + kArrowOfObject * size * fastest.normalized()};
}

std::string whole_text(const SceneSnapshot& scene, const SceneVerdict& verdict) {
  const Stability& s = verdict.stability;
  switch (s.status) {
    case Stability::Status::Unstable:
      return said(QCoreApplication::translate("verdict", "not supported: ")) +
             names_of_what_topples(scene, s);
    case Stability::Status::Unknown:
      return said(QCoreApplication::translate("verdict", "not known to stand: ")) + s.why_unknown;
    case Stability::Status::Marginal:
    case Stability::Status::Stable:
      break;
  }
  return said(is_barely(scene, verdict) ? QCoreApplication::translate("verdict", "barely stable")
                                        : QCoreApplication::translate("verdict", "stable"));
}

std::string object_text(const Object& object, const ObjectStability& verdict) {
  if (verdict.topples) return way_in_words(way_text(object, verdict.motion));
  return said(is_barely(object, verdict) ? QCoreApplication::translate("verdict", "barely stable")
                                         : QCoreApplication::translate("verdict", "stable"));
}

}  // namespace trivet::edit
