// Units of a batch: a number of scenes in one tar, folder or file, with a manifest at its end.
#pragma once

#include <cstdint>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "apps/farm/recipe/sha256.h"
#include "apps/farm/scene/scene_json.h"
#include "apps/farm/store/tar.h"

namespace trivet::farm {

/// A scene is JSON (scene_json.h), and perhaps more: members "NAME.json", "NAME.glb", NAME being k
/// with nine digits.
enum class UnitFormat {
  Tar,    // scenes-T.tar: members of all scenes, and last manifest.jsonl
  Dir,    // scenes-T/: the same as files
  Poses,  // scenes-T.jsonl: a line of JSON per scene, and an end
  Bop,    // train_pbr/T/: a folder, of one scene, with its files as BOP has them
  Coco,   // images/T/: the same, with images and annotations of COCO
};
const char* to_string(UnitFormat format);  // "tar", "dir", "poses", "bop", "coco"
bool is_folder(UnitFormat format);
/// A part of a data set: one scene, whose members have names of their own.
inline bool is_data_set(UnitFormat format) {
  return format == UnitFormat::Bop || format == UnitFormat::Coco;
}

struct Member {
  std::string name, bytes;
};
// NOLINTNEXTLINE(bugprone-exception-escape): moving a Json asserts, it throws nothing.
struct SceneMembers {
  Json scene;
  std::vector<Member> more;
};

std::string member_name(std::uint64_t k, const std::string& extension);
/// 0012/scenes-012345.tar: a thousand units to a folder. Of data sets train_pbr/012345.
std::string unit_name(std::uint64_t unit, UnitFormat format);

/// Last line of a manifest, or of a unit of poses.
/// @param batch  BatchRun::id(); empty: it names none.
/// @param sha256  of all lines before it.
std::string manifest_end(std::uint64_t unit, const std::string& batch, std::uint64_t num_scenes,
                         const std::string& sha256);

/// Lines of a manifest: a row per scene, with the SHA-256 of its members, and an end.
class Manifest {
 public:
  void add(const Json& scene, const std::vector<Member>& members);
  /// With its end, see manifest_end().
  std::string finished(std::uint64_t unit, const std::string& batch) const;

 private:
  std::string m_lines;
  std::uint64_t m_num_scenes = 0;
};

/// Writes a unit, scene after scene. Nothing is left of one that is not published, see publish.h.
class UnitWriter {
 public:
  /// @param batch  see manifest_end().
  /// @throws Error (Environment), as all functions here.
  UnitWriter(const std::string& out, std::uint64_t unit, UnitFormat format,
             const std::string& batch);
  ~UnitWriter();
  UnitWriter(const UnitWriter&) = delete;
  UnitWriter& operator=(const UnitWriter&) = delete;

  void add(const SceneMembers& scene);
  /// @return false if another process was first: this one is dropped.
  bool publish();

 private:
  struct Output;
  std::uint64_t m_unit;
  UnitFormat m_format;
  std::string m_batch;
  Manifest m_manifest;
  std::unique_ptr<Output> m_output;
};

bool unit_exists(const std::string& out, std::uint64_t unit, UnitFormat format);

/// Calls visit(row) for the scenes of a unit that is there: rows as of manifest_row().
/// @throws Error (BadInput) when there is no whole manifest, or it is that of another unit or
/// batch.
void visit_rows(const std::string& out, std::uint64_t number, UnitFormat format,
                const std::string& batch, const std::function<void(const Json& row)>& visit);

/// "" if all bytes of the unit are those that its scenes' JSON gives again in this batch: manifest,
/// container and the SHA-256 of every member; else what differs.
/// @param visit  called with each scene and all its members, its JSON first; may be empty.
using SceneVisitor = std::function<void(const Json& scene, const std::vector<Member>& members)>;
std::string check_unit(const std::string& out, std::uint64_t number, UnitFormat format,
                       const std::string& batch, const SceneVisitor& visit);

/// Reads scenes one by one; a unit is gone through once while they ascend.
class SceneReader {
 public:
  SceneReader(std::string out, UnitFormat format) : m_out(std::move(out)), m_format(format) {}

  /// Scene k of this unit. @throws Error (BadInput) when it is not there.
  Json read(std::uint64_t unit, std::uint64_t k);

 private:
  void open(std::uint64_t unit);
  bool find(std::uint64_t k, Json& scene);

  std::string m_out, m_path;
  UnitFormat m_format;
  bool m_goes_on = false;  // from scene m_last of m_unit
  std::uint64_t m_unit = 0, m_last = 0;
  std::unique_ptr<TarReader> m_tar;
  std::ifstream m_lines;
};

}  // namespace trivet::farm
