#include "core/io/obj/materials.h"

#include <algorithm>
#include <filesystem>

#include "core/base/printable.h"
#include "core/io/format/model_format.h"
#include "core/io/opened_files.h"
#include "core/io/text/file_bytes.h"
#include "core/io/text/utf8_text.h"
#include "core/io/text/words.h"
#include "core/io/textures/texture_adder.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

std::string_view without_quotes(std::string_view name) {
  const bool quoted = name.size() >= 2 && name.front() == '"' && name.back() == '"';
  return quoted ? name.substr(1, name.size() - 2) : name;
}

}  // namespace

void note_once(std::vector<Sentence>& notes, const Sentence& note) {
  const std::string text = in_english(note);
  const auto says_it = [&](const Sentence& other) { return in_english(other) == text; };
  if (std::none_of(notes.begin(), notes.end(), says_it)) notes.push_back(note);
}

void ObjMaterials::read_libraries(std::string_view names) {
  names = without_quotes(trimmed(names));
  if (names.empty() || read_library(with_slashes(names))) return;
  std::string_view rest = names;
  const bool one = next_word(rest).size() == names.size();
  if (one) return note_missing(with_slashes(names));
  rest = names;
  std::vector<std::string> missing;
  bool any = false;
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
    const std::string name = with_slashes(word);
    if (read_library(name))
      any = true;
    else
      missing.push_back(name);
  }
  // Words of one name with blanks are told as such.
  if (!any) return note_missing(with_slashes(names));
  for (const std::string& name : missing) note_missing(name);
}

// Textures belong to the model even where no face shows them.
void ObjMaterials::note_textures() const {
  for (const auto& [name, material] : m_materials) {
    std::vector<FileTexture> named = material.unread;
    for (const auto& texture : {material.base_colour, material.normal, material.emissive})
      if (texture) named.push_back(*texture);
    for (const FileTexture& texture : named)
      for (const fs::path& place :
           texture_places(m_model, with_slashes(texture.name), texture.folder))
        if (m_folder.has(place)) note_opened(m_model, {place.string()});
  }
}

// At the stated path, else beside the model.
bool ObjMaterials::read_library(const std::string& name) {
  const auto [entry, is_new] = m_read.try_emplace(name, false);
  if (!is_new) return entry->second;
  const fs::path folder = fs::path(m_model).parent_path();
  for (const fs::path& relative : {fs::path(name), fs::path(name).filename()}) {
    const fs::path file = folder / relative;
    if (!m_folder.has(file)) continue;
    note_opened(m_model, {file.string()});
    const auto bytes = file_bytes(file, m_limits.max_file_bytes);
    if (!bytes) continue;
    if (const auto what = placeholder(*bytes)) {
      note_once(m_notes,
                say("left out: the material file \"%1\", which %2", printable(name, 100), *what));
      return entry->second = true;
    }
    const fs::path place = relative.is_absolute() ? file.lexically_relative(folder) : relative;
    read_mtl(utf8_text(*bytes), place.parent_path().string(), m_materials, m_notes);
    note_textures();
    return entry->second = true;
  }
  return false;
}

void ObjMaterials::note_missing(const std::string& name) {
  const bool inside = m_folder.holds(fs::path(m_model).parent_path() / name);
  note_once(m_notes, inside ? say("left out: the material file \"%1\", which is missing",
                                  printable(name, 100))
                            : say("left out: it %1", outside_folder(name)));
}

const FileMaterial* ObjMaterials::find(const std::string& name) const {
  const auto found = m_materials.find(name);
  return found == m_materials.end() ? nullptr : &found->second;
}

}  // namespace trivet
