// Planes that separated faces in the first contacts before. Private to first contact and its
// callers that ask many times.
#pragma once

#include "core/base/types.h"

namespace trivet {

/// While one lives, first_contact() remembers on this thread the normals of planes between faces,
/// and tries them first when it meets the faces again: of a body that moves on and on, most still
/// separate them. Nothing but time and the number of decided pairs depends on it, and these only on
/// the queries since it was made. Of several the first one that lives remembers, for all.
class SeparatingPlanes {
 public:
  SeparatingPlanes();
  ~SeparatingPlanes();
  SeparatingPlanes(const SeparatingPlanes&) = delete;
  SeparatingPlanes& operator=(const SeparatingPlanes&) = delete;

  /// @return unit normal from the fixed to the moving face; null: not known. Valid until the next
  ///   call.
  static const Vec3* find(Index face_moving, Index face_fixed);
  static void remember(Index face_moving, Index face_fixed, const Vec3& normal);

 private:
  bool m_is_first;
};

}  // namespace trivet
