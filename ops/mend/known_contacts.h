// Contacts within a wide reach, carried along while the bodies move. Private.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "ops/mend/small_motions.h"

namespace trivet {

/// The search of contacts takes ten times as long within 24 mm as within 6 mm. What was found once
/// is still there after small motions, nearly: gaps, points and normals move along with the
/// features. Only what has come near is searched for, and counts instead; a pair that cannot have
/// come near is not searched at all.
class KnownContacts {
 public:
  /// @param reach  metres, of the widest gaps. @param clearance  metres.
  KnownContacts(double reach, double clearance) : m_reach(reach), m_clearance(clearance) {}

  /// All contacts of these bodies, each once, sorted by `on`, as they are placed in the scene.
  /// @param near  metres: closer ones are as they are, the others as they were carried along; of
  ///   pairs that were searched before, no farther than 3 mm.
  std::vector<BodyContact> find(const Scene& scene, const std::vector<FreeBody>& bodies,
                                double near);

  /// False: these two were found so far apart that they do not meet at these poses.
  bool may_meet(ObjectId a, const Pose& pose_a, ObjectId b, const Pose& pose_b) const;

 private:
  /// A body where it was.
  struct Was {
    FreeBody body = {};
    Pose pose = {};

    SmallMotion motion_to(const Pose& now) const;
    double way_to(const Pose& now) const;  // metres, of a point at half its size
  };
  struct Pair {
    Was on, with;  // of the floor, the second means nothing
    std::vector<BodyContact> touches;
    double least = 0;  // metres: there was no closer gap
    bool is_known = false;
  };
  using Key = std::pair<std::uint32_t, std::uint32_t>;

  class Search;

  static std::uint32_t key_of(const Support& s);

  double m_reach, m_clearance;
  std::map<Key, Pair> m_pairs;
};

}  // namespace trivet
