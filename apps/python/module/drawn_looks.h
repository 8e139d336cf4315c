// Textures and materials of a scene's models, decoded once for all its pictures.
#pragma once

#include <map>
#include <memory>
#include <mutex>

#include "ops/files/labels/labelled_scene.h"

namespace trivet::python {

/// Looks of the models that a scene had when it was drawn last. Thread-safe.
class DrawnLooks {
 public:
  /// Gives the meshes the looks that are known, and keeps those of the others. Models that the
  /// scene no longer has are forgotten.
  void share(LabelledScene& scene, const Scene& of);

 private:
  struct Known {
    std::shared_ptr<const Model> model;  // alive as long as its look
    decltype(PictureMesh::look) look;
  };
  std::mutex m_mutex;
  std::map<const Model*, Known> m_known;
};

}  // namespace trivet::python
