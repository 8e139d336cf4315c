// Places judged exactly, one at a time, and from a place that fits to the nearest that does.
#pragma once

#include "ops/free_places/place_setting.h"

namespace trivet {

class ExactPlaces {
 public:
  /// @param carried  the object and its loads.
  ExactPlaces(const Scene& scene, ObjectId object, std::span<const ObjectId> carried,
              const PlaceRequest& request, double clearance);

  /// True if the object, its centre of mass over `at`, falls onto the support before it meets
  /// anything else, with the centre over the support, and keeps its distance where it stops.
  bool fits(const Vec2& at) const;
  /// Error of the distances of places, metres.
  double tolerance() const { return m_tolerance; }
  Pose start(const Vec2& at) const { return m_setting.start(m_rotation, at); }
  Vec2 centre_at(const Pose& start) const {
    return start.translation.head<2>() + m_setting.centre.head<2>();
  }
  /// The nearest to request.near that is found from the fitting places of the height maps, sorted:
  /// each is followed towards the point and along obstacles. nullopt: none fits exactly.
  std::optional<Vec2> nearest(const Places& places) const;

 private:
  struct Found;
  bool over_support(const Vec2& at) const;
  void shrink(Found& found, double step) const;
  void descend(Found& found, double spacing) const;
  std::optional<Found> nearer(const Vec2& at, const Found& best, double spacing) const;
  bool fits_on_way(const Found& found, double aside, double radius) const;

  PlaceSetting m_setting;
  Rotation m_rotation;
  Vec2 m_near;
  double m_keep, m_tolerance;
  double m_lowest;  // z below which there is nothing to fall on
};

}  // namespace trivet
