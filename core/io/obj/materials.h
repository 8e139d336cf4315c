// Materials of an OBJ file: the .mtl files that it names.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/sentence.h"
#include "core/io/model_folder.h"
#include "core/io/read_model.h"
#include "core/io/surface/file_material.h"

namespace trivet {

class ObjMaterials {
 public:
  /// @param notes  receives what is left out.
  ObjMaterials(const std::string& model, const ImportLimits& limits, std::vector<Sentence>& notes)
      : m_model(model), m_folder(model), m_limits(limits), m_notes(notes) {}

  /// Reads what stands behind mtllib: a file whose name may have blanks, else several.
  void read_libraries(std::string_view names);
  /// Null: no .mtl file has it.
  const FileMaterial* find(const std::string& name) const;

 private:
  bool read_library(const std::string& name);
  void note_textures() const;
  void note_missing(const std::string& name);

  const std::string m_model;
  const ModelFolder m_folder;
  const ImportLimits& m_limits;
  std::vector<Sentence>& m_notes;
  std::map<std::string, FileMaterial> m_materials;
  std::map<std::string, bool> m_read;  // files, by name
};

/// Materials of a .mtl file by name; the first of equal ones counts. Lines of unknown kinds are
/// left out, with a note that names them.
/// @param folder  of the file, relative to the model's.
void read_mtl(std::string_view text, const std::string& folder,
              std::map<std::string, FileMaterial>& materials, std::vector<Sentence>& notes);

/// Adds a note that is not there yet.
void note_once(std::vector<Sentence>& notes, const Sentence& note);

}  // namespace trivet
