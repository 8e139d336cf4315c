#include "ops/files/report/verdict.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "core/base/quoted.h"
#include "core/scene/friction.h"

namespace trivet {
namespace {

constexpr double kSinks = 0.99;  // of a velocity: its part downwards

std::string towards(std::initializer_list<double> direction) {
  std::string out;
  for (const double part : direction) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", part == 0 ? 0.0 : part);
    out += (out.empty() ? "(" : ", ") + std::string(text);
  }
  return "towards " + out + ")";
}

std::string friction_text(const Stability& stability) {
  std::ostringstream out;
  if (stability.friction)
    out << "friction " << *stability.friction;
  else
    out << "the materials' friction";
  return out.str();
}

}  // namespace

std::string way_text(const Object& object, const VirtualMotion& motion) {
  const double size = object.scale * object.shape->box.diagonal();
  const double turning = motion.spin.norm() * size / 2, going = motion.velocity.norm();
  // Where a point straight above the centre goes.
  const Vec2 top(motion.spin.y(), -motion.spin.x());
  if (turning > going && top.norm() > motion.spin.norm() / 8) {
    const Vec2 d = top.normalized();
    return "tips " + towards({d.x(), d.y()});
  }
  if (turning > going) return "turns about the vertical";
  if (!(going > 0)) return "moves";
  const Vec3 d = motion.velocity / going;
  return -d.z() > kSinks ? "sinks" : "slides " + towards({d.x(), d.y(), d.z()});
}

double least_pair_friction(const Scene& scene, ObjectId object) {
  double least = kInfinity;
  for (const ObjectContact& entry : scene.at(object).contacts)
    least = std::min(least, friction_between(scene, object, entry.with));
  return least;
}

std::string start_text(const StartTried& tried) {
  char text[120];
  std::snprintf(text, sizeof text, "from start %d, %.2g mm away and turned by %.4g degrees",
                tried.number, 1000 * tried.shifted, tried.turned_deg);
  return text;
}

std::string gave_way_text(const std::vector<GaveWay>& objects) {
  std::string out;
  for (const GaveWay& object : objects) {
    char text[80];
    std::snprintf(text, sizeof text, " by %.2g mm and %.2g degrees", 1000 * object.moved,
                  object.turned_deg);
    out += (out.empty() ? "" : ", ") + quoted(object.name) + text;
  }
  return out;
}

std::string verdict_text(const Scene& scene, const Stability& stability) {
  std::ostringstream out;
  out << "stability: " << to_string(stability.status) << " at " << friction_text(stability);
  if (stability.stable() && stability.margin < kInfinity)
    out << ", margin " << stability.margin << " m";
  if (stability.status == Stability::Status::Unknown) out << ": " << stability.why_unknown;
  out << "\n";
  for (const ObjectStability& o : stability.objects) {
    const Object& object = scene.at(o.object);
    if (o.topples)
      out << "  " << quoted(object.name) << " would topple: " << way_text(object, o.motion) << "\n";
    else if (o.marginal)
      out << "  " << quoted(object.name) << " stands, but only just: margin " << o.margin
          << " m, alone it needs friction " << object.least_friction << "\n";
  }
  return out.str();
}

}  // namespace trivet
