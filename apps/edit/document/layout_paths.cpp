#include "apps/edit/document/layout_paths.h"

#include <filesystem>

#include "ops/files/layout/paths.h"
#include "ops/session/journal.h"

namespace trivet::edit {

namespace fs = std::filesystem;

Layout moved_layout(Layout layout, const std::string& folder) {
  const auto move = [&](std::string& path) {
    if (fs::path(path).is_relative())
      path = (fs::path(folder) / path).lexically_normal().generic_string();
  };
  for (LayoutObject& object : layout.objects) move(object.model);
  for (Operation& operation : layout.operations)
    if (auto* const append = std::get_if<AppendOperation>(&operation)) move(append->model);
  return layout;
}

std::string saved_file_of(const std::string& journal, const JournalContent& content) {
  std::string file = (fs::path(folder_of(journal)) / content.start.file).lexically_normal();
  if (fs::path(file).extension() != ".glb") file.clear();
  for (const JournalRecord& record : content.records)
    if (record.kind == JournalRecord::Kind::Saved) file = record.file;
  return file;
}

void remove_recovery_files(const std::string& journal) {
  std::error_code ignored;
  for (const std::string& file : {journal, start_copy_of(journal), journal + ".json"})
    fs::remove(file, ignored);
}

}  // namespace trivet::edit
