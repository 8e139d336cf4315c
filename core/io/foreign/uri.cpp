#include "core/io/foreign/uri.h"

#include <filesystem>

#include "core/base/bad_input.h"
#include "core/io/text/words.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

// FILE below a folder NAME that is above the file that names it, or beside one that is.
std::string in_package(const std::string& name, const fs::path& folder) {
  const std::string package = name.substr(0, name.find('/'));
  std::error_code error;
  for (fs::path at = folder; at.has_relative_path(); at = at.parent_path()) {
    if (fs::exists(at / name, error)) return (at / name).string();
    if (at.filename() == package) return (at.parent_path() / name).string();
  }
  return (folder / name).string();
}

std::string path_of(const std::string& uri, const fs::path& folder) {
  for (const char* scheme : {"package://", "model://"})
    if (uri.starts_with(scheme)) return in_package(uri.substr(std::string(scheme).size()), folder);
  if (uri.starts_with("file://")) return uri.substr(7);
  if (uri.find("://") != std::string::npos)
    bad_input("\"%1\" is not fetched; accepted: files on this machine", uri);
  return (folder / with_slashes(uri)).lexically_normal().string();
}

}  // namespace

std::string path_of_uri(const std::string& uri, const std::string& named_by,
                        const SceneRoots& roots) {
  const std::string path = path_of(uri, fs::absolute(named_by).parent_path());
  roots.check(path, named_by);
  return path;
}

Mesh mesh_in_metres(const Model& model) {
  Mesh mesh = model.mesh;
  if (model.format != "collada" || !model.up_from_format) return mesh;
  const Affine up = world_from_object(Pose{}, model.up, model.metres_per_unit.value_or(1));
  for (Vec3& v : mesh.vertices) v = up.apply(v);
  return mesh;
}

void scale(const Vec3& factors, Mesh& mesh) {
  for (Vec3& v : mesh.vertices) v = v.cwiseProduct(factors);
  if (factors.prod() < 0)
    for (Index3& t : mesh.triangles) std::swap(t[1], t[2]);
}

}  // namespace trivet
