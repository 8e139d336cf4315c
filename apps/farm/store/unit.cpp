#include "apps/farm/store/unit.h"

#include <cstdio>
#include <filesystem>
#include <optional>

#include "apps/farm/store/publish.h"
#include "apps/farm/store/tar.h"

namespace trivet::farm {

namespace fs = std::filesystem;

const char* to_string(UnitFormat format) {
  switch (format) {
    case UnitFormat::Tar:
      return "tar";
    case UnitFormat::Dir:
      return "dir";
    case UnitFormat::Poses:
      return "poses";
    case UnitFormat::Bop:
      return "bop";
    case UnitFormat::Coco:
      return "coco";
  }
  return "";
}

bool is_folder(UnitFormat format) { return format == UnitFormat::Dir || is_data_set(format); }

std::string member_name(std::uint64_t k, const std::string& extension) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%09llu", static_cast<unsigned long long>(k));
  return digits + extension;
}

std::string unit_name(std::uint64_t unit, UnitFormat format) {
  char name[64];
  if (is_data_set(format)) {
    std::snprintf(name, sizeof name, "%s/%06llu",
                  format == UnitFormat::Bop ? "train_pbr" : "images",
                  static_cast<unsigned long long>(unit));
    return name;
  }
  std::snprintf(name, sizeof name, "%04llu/scenes-%06llu",
                static_cast<unsigned long long>(unit / 1000),
                static_cast<unsigned long long>(unit));
  return std::string(name) + (format == UnitFormat::Tar     ? ".tar"
                              : format == UnitFormat::Poses ? ".jsonl"
                                                            : "");
}

void Manifest::add(const Json& scene, const std::vector<Member>& members) {
  Json row = manifest_row(scene);
  if (!members.empty()) row["members"] = Json::object();
  for (const Member& member : members) row["members"][member.name] = sha256_hex(member.bytes);
  m_lines += json_line(row);
  ++m_num_scenes;
}

std::string manifest_end(std::uint64_t unit, const std::string& batch, std::uint64_t num_scenes,
                         const std::string& sha256) {
  Json end = {{"end", true}, {"unit", unit}, {"scenes", num_scenes}, {"sha256", sha256}};
  if (!batch.empty()) end["batch"] = batch;
  return json_line(end);
}

std::string Manifest::finished(std::uint64_t unit, const std::string& batch) const {
  return m_lines + manifest_end(unit, batch, m_num_scenes, sha256_hex(m_lines));
}

struct UnitWriter::Output {
  std::optional<PublishedFile> file;
  std::optional<TarWriter> tar;
  std::optional<PublishedFolder> folder;
  Sha256 lines;  // of UnitFormat::Poses
  std::uint64_t num_scenes = 0;
};

UnitWriter::UnitWriter(const std::string& out, std::uint64_t unit, UnitFormat format,
                       const std::string& batch)
    : m_unit(unit), m_format(format), m_batch(batch), m_output(std::make_unique<Output>()) {
  const std::string path = (fs::path(out) / unit_name(unit, format)).string();
  if (is_folder(format)) {
    make_folders(fs::path(path).parent_path().string());
    m_output->folder.emplace(path);
    return;
  }
  PublishedFile& file = m_output->file.emplace(path);
  if (format == UnitFormat::Tar)
    m_output->tar.emplace([&file](std::string_view bytes) { file.write(bytes); });
}

UnitWriter::~UnitWriter() = default;

void UnitWriter::add(const SceneMembers& scene) {
  const std::string line = json_line(scene.scene);
  if (m_format == UnitFormat::Poses) {
    m_output->file->write(line);
    m_output->lines.add(line);
    ++m_output->num_scenes;
    return;
  }
  std::vector<Member> members{{member_name(scene.scene.at("k"), ".json"), line}};
  members.insert(members.end(), scene.more.begin(), scene.more.end());
  for (const Member& member : members) {
    if (m_output->tar) m_output->tar->add(member.name, member.bytes);
    if (m_output->folder) m_output->folder->add(member.name, member.bytes);
  }
  m_manifest.add(scene.scene, members);
}

bool UnitWriter::publish() {
  if (m_format == UnitFormat::Poses) {
    m_output->file->write(
        manifest_end(m_unit, m_batch, m_output->num_scenes, hex(m_output->lines.digest())));
    return m_output->file->publish();
  }
  const std::string manifest = m_manifest.finished(m_unit, m_batch);
  if (m_output->folder) {
    m_output->folder->add("manifest.jsonl", manifest);
    return m_output->folder->publish();
  }
  m_output->tar->add("manifest.jsonl", manifest);
  m_output->tar->finish();
  return m_output->file->publish();
}

bool unit_exists(const std::string& out, std::uint64_t unit, UnitFormat format) {
  std::error_code ignored;
  return fs::exists(fs::path(out) / unit_name(unit, format), ignored);
}

}  // namespace trivet::farm
