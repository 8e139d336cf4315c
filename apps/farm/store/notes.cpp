#include "apps/farm/store/notes.h"

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "apps/farm/scene/scene_json.h"
#include "core/io/process/local_sockets.h"
#include "ops/files/json/text.h"

namespace trivet::farm {
namespace {

constexpr size_t kMostLineBytes = 4000;  // of a line

std::string notes_path(const std::string& out) {
  return (std::filesystem::path(out) / "notes.jsonl").string();
}

}  // namespace

bool add_note(const std::string& out, const BatchNote& note) {
  const std::string text = note.text.substr(0, kMostLineBytes / 2);
  const std::string line = json_line({{"scene", note.scene}, {"note", text}});
  const Descriptor file(
      open(notes_path(out).c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
  // One call: lines of several processes stay whole.
  return file.number() >= 0 &&
         write(file.number(), line.data(), line.size()) == static_cast<ssize_t>(line.size());
}

std::vector<BatchNote> read_notes(const std::string& out, size_t most) {
  std::vector<BatchNote> notes;
  std::ifstream file(notes_path(out));
  std::string line(kMostLineBytes, '\0');
  while (notes.size() < most &&
         file.getline(line.data(), static_cast<std::streamsize>(kMostLineBytes))) {
    const nlohmann::json json = nlohmann::json::parse(line.c_str(), nullptr, false);
    if (json.is_object() && json.contains("scene") && json["scene"].is_number_unsigned() &&
        json.contains("note") && json["note"].is_string())
      notes.push_back({json["scene"], json["note"]});
  }
  return notes;
}

}  // namespace trivet::farm
