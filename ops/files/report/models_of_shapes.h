// Models for objects that programs made of a shape alone.
#pragma once

#include <optional>
#include <string>

#include "core/scene/scene.h"

namespace trivet {

/// A scene whose objects all have a model: the one given, or, where objects lack theirs, a copy in
/// which those of one shape share a model of its mesh. Refers to the scene given.
class WholeModels {
 public:
  explicit WholeModels(const Scene& scene);
  const Scene& scene() const { return m_copy ? *m_copy : m_given; }

 private:
  const Scene& m_given;
  std::optional<Scene> m_copy;
};

/// Path of the object's model as it was given; empty: of no file.
inline std::string model_path(const Object& object) {
  return object.model ? object.model->path : std::string();
}

}  // namespace trivet
