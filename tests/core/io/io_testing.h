// Common part of the io tests: a folder per test, small models as text, and an independent reader.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/model/model.h"

namespace trivet::testing {

/// A fresh folder for the running test, removed afterwards.
class IoTest : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;
  /// Path of a file in the folder; write() also creates it.
  std::string path(const std::string& name) const { return (m_folder / name).string(); }
  std::string write(const std::string& name, const std::string& bytes) const;
  const std::filesystem::path& folder() const { return m_folder; }

 private:
  std::filesystem::path m_folder;
};

/// Drops root's privileges, which bypass file permissions. False if it cannot.
class OrdinaryUser {
 public:
  OrdinaryUser();
  ~OrdinaryUser();
  explicit operator bool() const { return m_ordinary; }

 private:
  bool m_was_root, m_ordinary;
};

std::string read_bytes(const std::string& path);

/// The message of the Error thrown by `call`, with its kind checked.
template <class Call>
std::string error_of(const Call& call, Error::Kind kind = Error::Kind::BadInput) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    return error.what();
  }
  return "no Error was thrown";
}

/// Expects that `text` holds all of `parts`.
void expect_parts(const std::string& text, const std::vector<std::string>& parts);

/// All triangles by an independent reader: assimp, Eigen's 4x4 products, row by row.
std::vector<Triangle> reference_triangles(const std::string& path);

/// Triangles below each named node of a scene file, float32, converted from y up to z up.
struct NamedTriangles {
  std::string name;
  std::vector<Triangle> triangles;
};
std::vector<NamedTriangles> reference_scene(const std::string& path);

/// Sorted, so that the order of primitives does not matter.
std::vector<Triangle> sorted(std::vector<Triangle> triangles);

/// Equal bit for bit, -0 equal to 0.
bool same_triangles(const std::vector<Triangle>& a, const std::vector<Triangle>& b);

/// A mesh as a list of triangles.
std::vector<Triangle> triangles_of(const Mesh& mesh);

/// ../shared/<name>, or empty if missing.
std::string shared_path(const std::string& name);

// A tetrahedron with its corners at 0 and on the axes, in several formats.
std::string tetrahedron_obj();
std::string tetrahedron_ply();
std::string tetrahedron_stl();
std::string tetrahedron_stl_binary();
std::string tetrahedron_dae(const std::string& up_axis, const std::string& unit);
std::string tetrahedron_fbx(int up_axis, double centimetres);
std::string tetrahedron_3ds();
/// Embedded buffer; `nodes` is the JSON array of nodes, with the given `roots`.
std::string tetrahedron_gltf(const std::string& nodes, const std::string& roots);
std::string tetrahedron_glb();

/// A model with one material and a tetrahedron's triangles moved by `offset`.
Model tetrahedron_model(const Vec3& offset = Vec3::Zero());

}  // namespace trivet::testing
