#include "core/io/io_testing.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <unistd.h>

#include <Eigen/LU>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <fstream>
#include <iterator>
#include <tuple>

// assimp 5.2 leaks on files that it rejects; AddressSanitizer should report only our own leaks.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libassimp"; }

namespace trivet::testing {

namespace fs = std::filesystem;

void IoTest::SetUp() {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  m_folder = fs::path(::testing::TempDir()) /
             ("trivet_io_" + std::to_string(getpid()) + "_" + info->name());
  fs::remove_all(m_folder);
  fs::create_directories(m_folder);
}

void IoTest::TearDown() {
  fs::permissions(m_folder, fs::perms::owner_all);  // a test may have removed the permissions
  fs::remove_all(m_folder);
}

std::string IoTest::write(const std::string& name, const std::string& bytes) const {
  std::ofstream(path(name), std::ios::binary) << bytes;
  return path(name);
}

OrdinaryUser::OrdinaryUser() : m_was_root(geteuid() == 0), m_ordinary(true) {
  constexpr uid_t kNobody = 65534;
  if (m_was_root) m_ordinary = seteuid(kNobody) == 0;
}

OrdinaryUser::~OrdinaryUser() {
  if (m_was_root && m_ordinary && seteuid(0) != 0) ADD_FAILURE() << "cannot become root again";
}

std::string read_bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void expect_parts(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

namespace {

Eigen::Matrix4d matrix_of(const aiNode& node) {
  Eigen::Matrix4d out;
  for (unsigned r = 0; r < 4; ++r)
    for (unsigned c = 0; c < 4; ++c) out(r, c) = node.mTransformation[r][c];
  return out;
}

Vec3 applied(const Eigen::Matrix4d& m, const aiVector3D& v) {
  const double x = v.x, y = v.y, z = v.z;
  const auto row = [&](int r) { return m(r, 0) * x + m(r, 1) * y + m(r, 2) * z + m(r, 3); };
  return {row(0), row(1), row(2)};
}

void add_triangles(const aiScene& scene, const aiNode& node, const Eigen::Matrix4d& parent,
                   std::vector<Triangle>& out) {
  const Eigen::Matrix4d matrix = parent * matrix_of(node);
  const bool mirrored = matrix.topLeftCorner<3, 3>().determinant() < 0;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices == 3)
        out.push_back({applied(matrix, mesh.mVertices[face.mIndices[0]]),
                       applied(matrix, mesh.mVertices[face.mIndices[mirrored ? 2 : 1]]),
                       applied(matrix, mesh.mVertices[face.mIndices[mirrored ? 1 : 2]])});
    }
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i)
    add_triangles(scene, *node.mChildren[i], matrix, out);
}

std::array<double, 9> numbers(const Triangle& t) {
  std::array<double, 9> out;
  for (int i = 0; i < 9; ++i) out[i] = t[i / 3][i % 3];
  return out;
}

}  // namespace

std::vector<Triangle> reference_triangles(const std::string& path) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate);
  std::vector<Triangle> out;
  EXPECT_TRUE(scene) << path << ": " << importer.GetErrorString();
  if (scene) add_triangles(*scene, *scene->mRootNode, Eigen::Matrix4d::Identity(), out);
  return out;
}

std::vector<NamedTriangles> reference_scene(const std::string& path) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate);
  EXPECT_TRUE(scene) << path << ": " << importer.GetErrorString();
  if (!scene) return {};
  const aiNode& root = *scene->mRootNode;
  std::vector<NamedTriangles> out;
  const auto add = [&](const aiNode& node, const Eigen::Matrix4d& parent,
                       const auto& self) -> void {
    // Objects of a wide scene are below nodes of places.
    if (std::string(node.mName.C_Str()) == "place") {
      for (unsigned i = 0; i < node.mNumChildren; ++i)
        self(*node.mChildren[i], parent * matrix_of(node), self);
      return;
    }
    out.push_back({node.mName.C_Str(), {}});
    add_triangles(*scene, node, parent, out.back().triangles);
    for (Triangle& t : out.back().triangles)
      for (Vec3& p : t) {
        const Eigen::Vector3f f = p.cast<float>();
        p = Vec3(f.x(), -f.z(), f.y());
      }
  };
  // With a single node in the scene, assimp makes it the root.
  const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
  if (root.mNumChildren == 0 || std::string(root.mName.C_Str()) == "place") {
    add(root, identity, add);
    return out;
  }
  for (unsigned i = 0; i < root.mNumChildren; ++i)
    add(*root.mChildren[i], matrix_of(root) * identity, add);
  return out;
}

std::vector<Triangle> sorted(std::vector<Triangle> triangles) {
  std::sort(triangles.begin(), triangles.end(),
            [](const Triangle& a, const Triangle& b) { return numbers(a) < numbers(b); });
  return triangles;
}

bool same_triangles(const std::vector<Triangle>& a, const std::vector<Triangle>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Triangle& s, const Triangle& t) { return numbers(s) == numbers(t); });
}

std::vector<Triangle> triangles_of(const Mesh& mesh) {
  std::vector<Triangle> out;
  for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f)
    out.push_back(mesh.triangle(f));
  return out;
}

std::string shared_path(const std::string& name) {
  const fs::path path = fs::path(TRIVET_SHARED_DIR) / name;
  return fs::exists(path) ? path.string() : "";
}

}  // namespace trivet::testing
