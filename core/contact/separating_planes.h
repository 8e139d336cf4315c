// Planes that separated faces in earlier queries.
#pragma once

#include <memory>

#include "core/base/types.h"

namespace trivet {

/// Normals of planes between faces, which first_contact() tries first when the faces meet again: of
/// a body that moves on and on, most still separate them. For FirstContactQuery::planes, in queries
/// of one thread after the other. Which pairs are decided and how long that takes depends on them;
/// the answer does not, as a plane counts only where it proves a pair free (that a pair which it
/// frees would have stalled was never seen).
class SeparatingPlanes {
 public:
  SeparatingPlanes();
  ~SeparatingPlanes();
  SeparatingPlanes(const SeparatingPlanes&) = delete;
  SeparatingPlanes& operator=(const SeparatingPlanes&) = delete;

 private:
  friend class PairTraversal;
  struct Table;

  /// @return unit normal from the fixed to the moving face; null: not known. Valid until the next
  ///   call.
  const Vec3* find(Index face_moving, Index face_fixed) const;
  void remember(Index face_moving, Index face_fixed, const Vec3& normal);

  std::unique_ptr<Table> m_table;
};

}  // namespace trivet
