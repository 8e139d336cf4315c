#include "ops/mend/wide_contacts.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace trivet {
namespace {

/// A body's motion; what stays has none.
struct Gone {
  Vec3 shift = Vec3::Zero(), turn = Vec3::Zero(), centre = Vec3::Zero();

  Gone(const std::vector<FreeBody>& bodies, const std::vector<SmallMotion>& gone, Index body) {
    if (body == BodyContact::kGround) return;
    shift = gone[body].head<3>();
    turn = gone[body].tail<3>() / (0.5 * bodies[body].size);
    centre = bodies[body].centre;
  }
  Vec3 at(const Vec3& point) const { return shift + turn.cross(point - centre); }
};

// The point belongs to the first body so far; its normal belongs to the other one's face.
double share_of_on(ContactFeatures features) {
  if (features == ContactFeatures::VertexFace) return 1;
  return features == ContactFeatures::FaceVertex ? 0 : 0.5;
}

}  // namespace

void WideContacts::join(double reach, std::vector<BodyContact>& found) {
  for (const BodyContact& t : m_known)
    if (t.contact.gap > reach) found.push_back(t);
  m_known = found;
}

void WideContacts::move(const std::vector<FreeBody>& bodies, const std::vector<SmallMotion>& gone) {
  for (BodyContact& t : m_known) {
    ContactPoint& c = t.contact;
    const Gone on(bodies, gone, t.on), from(bodies, gone, t.from);
    const double share = share_of_on(c.features);
    const Vec3 turn = (1 - share) * on.turn + share * from.turn;
    c.gap = std::max(0.0, c.gap + c.normal.dot(on.at(c.point) - from.at(c.point)));
    c.point += share * on.at(c.point) + (1 - share) * from.at(c.point);
    c.normal = (c.normal + turn.cross(c.normal)).normalized();
  }
}

}  // namespace trivet
