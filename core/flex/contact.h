// Contact of a flexible body: all pairs within a layer around it, and their energy.
#pragma once

#include "core/flex/near_list.h"
#include "core/flex/total.h"

namespace trivet::flex {

/// Edges that are nearly parallel lose their contact smoothly, as their closest points jump; the
/// pairs of their ends have it [Li 2020, 4.3]. A function of c = |edge a x edge b|^2.
struct Mollifier {
  double value = 1, first = 0, second = 0;  // and derivatives by c
};

struct ContactPair {
  NearPair pair;
  PairPoints points;
  Mollifier mollifier;
  double offset = 0;     // distance at which the surfaces meet: half a thickness, or a whole one
  double gap = 0;        // from there on, > 0
  double layer = 0;      // m beyond the offset in which it acts
  double stiffness = 0;  // N/m: weight of the pair's area

  /// Newtons by which it pushes the first side along direction().
  double force() const;
};

struct ContactOptions {
  double layer = 5e-4;    // m beyond the surface in which contact acts
  double pressure = 500;  // weights per area at half the layer: cups' rims need so many
};

/// Finds pairs, by a list of those that are near.
class Contact {
 public:
  Contact(Surroundings& surroundings, const ContactOptions& options);

  double layer() const { return m_options.layer; }
  double distance_outside() const { return m_surroundings.body().material.thickness / 2; }
  /// Distance at which the two meet: the thickness, or less for what began nearer.
  double offset(const NearPair& pair) const;

  /// All pairs that may come into the layer while each vertex stays in its box; null: too many.
  const std::vector<NearPair>* near(const Points& x, std::span<const Aabb> boxes) {
    return m_list.within(x, boxes);
  }
  /// Pairs of the body with itself that are nearer than its thickness keep half of their distance
  /// from now on, and push each other apart until they are beyond it.
  void keep_distances_of(const Points& x);
  bool keeps_any() const { return !m_kept.empty(); }
  /// Each of those pairs keeps what it has gained. @return true if any did; contacts are to be
  /// found again then.
  bool raise_kept(const Points& x);
  /// All pairs in the layer. @return false if any is at its offset or nearer, or there
  /// are too many.
  bool find(const Points& x, std::vector<ContactPair>& out);
  /// Energy; adds to the derivatives that are asked for.
  /// @param total  its exact or positive second derivative.
  static double energy(const std::vector<ContactPair>& pairs, const Total& total);

 private:
  double area(const NearPair& pair) const;
  double full_offset(const NearPair& pair) const;
  Mollifier mollifier(const ContactPair& pair) const;
  bool add_pair(const Points& x, const NearPair& near, std::vector<ContactPair>& out) const;

  Surroundings& m_surroundings;
  ContactOptions m_options;
  double m_stiffness;  // N/m per area
  NearList m_list;
  struct Kept {
    NearPair pair;
    double distance;
  };
  std::vector<Kept> m_kept;  // sorted
};

}  // namespace trivet::flex
