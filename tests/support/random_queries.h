// Random first-contact queries over meshes of every kind, each determined by a seed and a number.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/candidates/zlist_stage.h"
#include "support/random_shapes.h"

namespace trivet::test {

enum class MeshKind { Any, Needles, Degenerate, Grid, Tiny, Box, Sphere, Terrain };
inline constexpr int kNumMeshKinds = 8;
const char* to_string(MeshKind kind);

/// A body that can be moved again, as its pose is stored.
struct PosedShape {
  std::shared_ptr<const Shape> shape;
  Pose pose;
  double scale = 1;

  Body body() const { return {*shape, world_from_object(pose, UpAxis::Z, scale)}; }
};

/// Owns the data that a FirstContactQuery refers to.
struct RandomQuery {
  MeshKind kind_moving, kind_fixed;
  std::vector<PosedShape> moving, fixed;
  bool floor = false;
  Motion motion;
  Clearance clearance;
  bool starts_near = false;  // at the contact of another motion

  FirstContact fast() const;
  FirstContact brute_force() const;
  FirstContact with_stage(CandidateFinder& stage, CandidatePairs* proposal = nullptr) const;
  /// Moves everything to its pose at `time`.
  void advance(double time);
  std::string describe() const;  // full digits

  /// Result of f(FirstContactQuery).
  template <class F>
  auto ask(F f) const {
    std::vector<Body> a, b;
    for (const PosedShape& m : moving) a.push_back(m.body());
    for (const PosedShape& m : fixed) b.push_back(m.body());
    return f(FirstContactQuery{a, b, floor, motion, clearance});
  }
};

/// Several meshes of each kind, of size about 1, made once.
class MeshPool {
 public:
  MeshPool(unsigned seed, int num_each);
  const std::shared_ptr<const Shape>& pick(MeshKind kind, Random& random) const;

 private:
  std::array<std::vector<std::shared_ptr<const Shape>>, kNumMeshKinds> m_shapes;
};

/// Query number `index`: kinds in turn, every second motion a rotation, clearances 1e-3 to 1e-7,
/// every third start in contact, axes often through vertices and along edges, poses often aligned
/// with the axes on a coarse grid.
RandomQuery random_query(const MeshPool& pool, unsigned seed, int index);

/// Several bodies that move together, several fixed ones, above the floor.
RandomQuery random_group_query(const MeshPool& pool, unsigned seed, int index);

/// Bitwise equality, apart from statistics.
bool same_answer(const FirstContact& a, const FirstContact& b);
std::string describe(const FirstContact& contact);

}  // namespace trivet::test
