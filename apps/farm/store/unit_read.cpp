#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "apps/farm/store/damage.h"
#include "apps/farm/store/tar.h"
#include "apps/farm/store/unit.h"
#include "core/base/bad_input.h"
#include "core/io/json.h"

namespace trivet::farm {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifest = "manifest.jsonl";

std::string file_bytes(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  if (!in || !(out << in.rdbuf())) bad_file(path.string(), "cannot be read");
  return out.str();
}

// "000000017.json"
bool is_scene_name(const std::string& name) {
  constexpr size_t kDigits = 9;
  const size_t point = name.find('.');
  return point != std::string::npos && point >= kDigits && name.substr(point) == ".json" &&
         name.find_first_not_of("0123456789") == point;
}

std::vector<std::string> files_below(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_directory()) names.push_back(fs::relative(entry.path(), folder).generic_string());
  std::erase(names, kManifest);
  return names;
}

// Members of a folder in the order in which a tar has them.
void visit_folder(const fs::path& folder, bool one_scene, const TarVisitor& visit) {
  std::vector<std::string> names = files_below(folder);
  const auto key = [&](const std::string& name) {
    return std::make_pair(one_scene ? "" : name.substr(0, name.find('.')),
                          (is_scene_name(name) ? "0" : "1") + name);
  };
  std::sort(names.begin(), names.end(),
            [&](const std::string& a, const std::string& b) { return key(a) < key(b); });
  names.emplace_back(kManifest);
  for (const std::string& name : names) visit(name, [&] { return file_bytes(folder / name); });
}

void visit_members(const fs::path& path, UnitFormat format, const TarVisitor& visit) {
  if (format == UnitFormat::Tar) return visit_tar(path.string(), visit);
  visit_folder(path, is_data_set(format), visit);
}

Json parsed(const std::string& line, const std::string& where) {
  std::optional<Json> json = json_if_valid<Json>(line);
  if (!json || !json->is_object()) bad_file(where, "is damaged: a line is no JSON object");
  return std::move(*json);
}

/// Splits lines that all end with a line feed.
std::vector<std::string> lines_of(const std::string& text, const std::string& where) {
  std::vector<std::string> out;
  size_t from = 0;
  for (size_t to; (to = text.find('\n', from)) != std::string::npos; from = to + 1)
    out.push_back(text.substr(from, to + 1 - from));
  if (from != text.size() || out.empty()) bad_file(where, "is damaged: it ends early");
  return out;
}

/// The unit that a file is expected to be.
struct UnitName {
  fs::path path;
  std::uint64_t number;
  const std::string& batch;
};

void check_end(const Json& end, size_t num_rows, const UnitName& unit) {
  const std::string where = unit.path.string();
  if (end.value("scenes", size_t{0}) != num_rows || !end.contains("end"))
    bad_file(where, "is damaged: the end of its manifest is missing");
  if (end.value("batch", "") != unit.batch)
    bad_file(where, "is a unit of another batch than run.json says");
  if (end.value("unit", ~std::uint64_t{0}) != unit.number)
    bad_file(where, "is another unit of the batch");
}

/// Lines without the end, which has to fit.
std::vector<Json> rows_of(const std::string& text, const UnitName& unit) {
  const std::string where = unit.path.string();
  std::vector<std::string> lines = lines_of(text, where);
  const Json end = parsed(lines.back(), where);
  lines.pop_back();
  try {
    check_end(end, lines.size(), unit);
  } catch (const nlohmann::json::exception&) {
    bad_file(where, "is damaged: the end of its manifest is no such line");
  }
  std::vector<Json> out;
  out.reserve(lines.size());
  for (const std::string& line : lines) out.push_back(parsed(line, where));
  return out;
}

/// Makes the unit again from what is in it, and compares.
class Checker {
 public:
  explicit Checker(UnitFormat format)
      : m_tar([this](std::string_view bytes) { m_again.add(bytes); }), m_format(format) {}

  void add(const std::string& name, std::string bytes, const SceneVisitor& visit) {
    if (m_format == UnitFormat::Tar) m_tar.add(name, bytes);
    if (name == kManifest) {
      end_scene(visit);
      m_manifest = std::move(bytes);
      return;
    }
    if (is_scene_name(name)) {
      end_scene(visit);
      m_scene = parsed(bytes, name);
    }
    m_members.push_back({name, std::move(bytes)});
  }

  std::string finding(const UnitName& unit) {
    const std::string path = unit.path.string();
    if (m_manifest != m_expected.finished(unit.number, unit.batch)) {
      rows_of(m_manifest, unit);  // throws where it is of another unit or batch
      return path + ": the manifest is not that of the scenes";
    }
    if (m_format != UnitFormat::Tar) return "";
    m_tar.finish();
    return hex(m_again.digest()) == sha256_hex(file_bytes(unit.path))
               ? ""
               : path + ": the tar has other bytes than its members give";
  }

 private:
  void end_scene(const SceneVisitor& visit) {
    if (m_members.empty()) return;
    m_expected.add(m_scene, m_members);
    if (visit) visit(m_scene, m_members);
    m_members.clear();
  }

  Sha256 m_again;
  TarWriter m_tar;
  UnitFormat m_format;
  Manifest m_expected;
  Json m_scene;
  std::vector<Member> m_members;
  std::string m_manifest;
};

std::string check_poses(const UnitName& unit, const SceneVisitor& visit) {
  const std::string text = file_bytes(unit.path);
  const std::vector<Json> scenes = rows_of(text, unit);
  const std::string end = lines_of(text, unit.path.string()).back();
  const std::string_view rows = std::string_view(text).substr(0, text.size() - end.size());
  if (end != manifest_end(unit.number, unit.batch, scenes.size(), sha256_hex(rows)))
    return unit.path.string() + ": has other bytes than its end says";
  if (visit)
    for (const Json& scene : scenes) visit(scene, {{"", json_line(scene)}});
  return "";
}

}  // namespace

namespace {

void visit_rows(const UnitName& unit, UnitFormat format,
                const std::function<void(const Json& row)>& visit) {
  if (format == UnitFormat::Poses) {
    for (const Json& scene : rows_of(file_bytes(unit.path), unit)) visit(manifest_row(scene));
    return;
  }
  std::string manifest;
  if (is_folder(format))
    manifest = file_bytes(unit.path / kManifest);
  else
    visit_tar(unit.path.string(), [&](const std::string& name, const auto& read) {
      if (name == kManifest) manifest = read();
    });
  for (const Json& row : rows_of(manifest, unit)) visit(row);
}

}  // namespace

void visit_rows(const std::string& out, std::uint64_t number, UnitFormat format,
                const std::string& batch, const std::function<void(const Json& row)>& visit) {
  const UnitName unit{fs::path(out) / unit_name(number, format), number, batch};
  read_undamaged(unit.path.string(), [&] { visit_rows(unit, format, visit); });
}

std::string check_unit(const std::string& out, std::uint64_t number, UnitFormat format,
                       const std::string& batch, const SceneVisitor& visit) {
  const UnitName unit{fs::path(out) / unit_name(number, format), number, batch};
  try {
    if (format == UnitFormat::Poses) return check_poses(unit, visit);
    Checker checker(format);
    visit_members(unit.path, format, [&](const std::string& name, const auto& read) {
      checker.add(name, read(), visit);
    });
    return checker.finding(unit);
  } catch (const nlohmann::json::exception&) {
    return unit.path.string() + ": a scene is damaged";
  } catch (const Error& e) {
    return e.what();
  }
}

void SceneReader::open(std::uint64_t unit) {
  m_unit = unit;
  m_path = (fs::path(m_out) / unit_name(unit, m_format)).string();
  if (m_format == UnitFormat::Tar) m_tar = std::make_unique<TarReader>(m_path);
  if (m_format == UnitFormat::Poses) m_lines = std::ifstream(m_path, std::ios::binary);
}

bool SceneReader::find(std::uint64_t k, Json& scene) {
  const std::string wanted = member_name(k, ".json");
  if (is_folder(m_format)) {
    const fs::path file = fs::path(m_path) / wanted;
    if (!fs::exists(file)) return false;
    scene = parsed(file_bytes(file), file.string());
    return true;
  }
  if (m_format == UnitFormat::Tar) {
    while (const auto name = m_tar->next())
      if (*name == wanted) {
        scene = parsed(m_tar->bytes(), wanted);
        return true;
      }
    return false;
  }
  for (std::string line; std::getline(m_lines, line);) {
    scene = parsed(line, m_path);
    if (scene.value("k", ~std::uint64_t{0}) == k) return true;
  }
  return false;
}

Json SceneReader::read(std::uint64_t unit, std::uint64_t k) {
  if (!m_goes_on || unit != m_unit || k <= m_last) open(unit);
  m_goes_on = false;  // after an error from the beginning
  Json scene;
  if (!read_undamaged(m_path, [&] { return find(k, scene); }))
    bad_file(m_path, "has no scene %1", k);
  m_goes_on = true;
  m_last = k;
  return scene;
}

}  // namespace trivet::farm
