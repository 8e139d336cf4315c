// The files that assimp may open for a model. Private: it shows assimp.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/io/model_folder.h"

namespace trivet {

/// Opens for reading the model itself and regular files in its folder and below; all others are not
/// there. What it opens is noted (note_opened()).
class FolderIoSystem : public Assimp::DefaultIOSystem {
 public:
  /// @param alias  another name under which the model itself is opened.
  /// @param text  what stands for the model's bytes, if given.
  FolderIoSystem(const std::string& model, std::string alias, std::optional<std::string> text)
      : m_model(model), m_alias(std::move(alias)), m_text(std::move(text)), m_folder(model) {}

  bool Exists(const char* file) const override;
  Assimp::IOStream* Open(const char* file, const char* mode) override;
  bool DeleteFile(const std::string&) override { return false; }
  bool CreateDirectory(const std::string&) override { return false; }

  /// The names that were asked for and lie outside, each once.
  const std::vector<std::string>& outside() const { return m_outside; }

 private:
  bool may_open(const std::string& file) const;
  bool is_model(const std::string& file) const { return file == m_model || file == m_alias; }

  const std::string m_model, m_alias;
  const std::optional<std::string> m_text;
  const ModelFolder m_folder;
  mutable std::vector<std::string> m_outside;  // Exists() is const
};

}  // namespace trivet
