// The files that assimp may open for a model. Private: it shows assimp.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <string>
#include <vector>

#include "core/io/model_folder.h"

namespace trivet {

/// Opens for reading the model itself and regular files in its folder and below; all others are not
/// there. What it opens is noted (note_opened()).
class FolderIoSystem : public Assimp::DefaultIOSystem {
 public:
  explicit FolderIoSystem(const std::string& model) : m_model(model), m_folder(model) {}

  bool Exists(const char* file) const override;
  Assimp::IOStream* Open(const char* file, const char* mode) override;
  bool DeleteFile(const std::string&) override { return false; }
  bool CreateDirectory(const std::string&) override { return false; }

  /// The names that were asked for and lie outside, each once.
  const std::vector<std::string>& outside() const { return m_outside; }

 private:
  bool may_open(const std::string& file) const;

  const std::string m_model;
  const ModelFolder m_folder;
  mutable std::vector<std::string> m_outside;  // Exists() is const
};

}  // namespace trivet
