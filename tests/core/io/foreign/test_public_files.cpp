// Files of others: written back without change they are equal byte for byte, and MuJoCo has the
// poses, masses and centres that are read. The files of cases/, and those of the folder
// TRIVET_FOREIGN_FILES if it is set; TRIVET_FOREIGN_COMPILED names what mujoco_poses.mjs wrote of
// it. docs/measurements/scenes-of-others.md has the figures of public repositories.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/error.h"
#include "core/io/foreign/foreign_testing.h"
#include "core/io/foreign/sdf.h"
#include "core/io/foreign/write_back.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;
using namespace trivet::test;
using nlohmann::json;

constexpr double kSamePose = 1e-9;   // metres, and of a matrix's entries
constexpr double kClosePose = 1e-6;  // meshes of floats move the frames of bodies
constexpr double kSameMass = 1e-6;

using Read = ForeignScene (*)(const std::string&, const ForeignOptions&, const MeshSource&);

Read reader_of(const fs::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".urdf") return read_urdf;
  if (extension == ".sdf" || extension == ".world") return read_sdf;
  return extension == ".xml" ? read_mjcf : nullptr;
}

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && reader_of(entry.path())) out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

const fs::path kCases = fs::path(TRIVET_SOURCE_DIR) / "tests/core/io/foreign/cases";

const char* folder_of_public_files() { return std::getenv("TRIVET_FOREIGN_FILES"); }

/// A file that is refused gives none, and has a message that names it.
std::optional<ForeignScene> scene_of(const fs::path& path, const fs::path& root) {
  ForeignOptions options;
  options.roots = {root.string()};
  try {
    return reader_of(path)(path.string(), options, no_mesh);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), Error::Kind::BadInput) << e.what();
  }
  return std::nullopt;
}

// --- bytes --------------------------------------------------------------------------------------

void expect_equal_bytes(const ForeignScene& scene, const std::map<size_t, Pose>& poses) {
  const std::vector<std::string> bytes = files_with_poses(scene, poses);
  ASSERT_EQ(bytes.size(), scene.files.size());
  for (size_t i = 0; i < bytes.size(); ++i)
    EXPECT_TRUE(bytes[i] == scene.files[i].bytes) << scene.files[i].path;
}

/// @return how many bodies have a place.
size_t expect_equal_bytes(const ForeignScene& scene) {
  std::map<size_t, Pose> same;
  for (size_t i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].place.kind != PosePlace::Kind::Nowhere) same[i] = scene.bodies[i].pose;
  expect_equal_bytes(scene, {});
  expect_equal_bytes(scene, same);
  return same.size();
}

struct Written {
  size_t num_read = 0, num_refused = 0, num_bodies = 0;
};

Written expect_equal_bytes_below(const fs::path& folder) {
  Written out;
  for (const fs::path& path : files_below(folder)) {
    SCOPED_TRACE(path.string());
    const auto scene = scene_of(path, folder);
    if (!scene) {
      ++out.num_refused;
      continue;
    }
    ++out.num_read;
    out.num_bodies += expect_equal_bytes(*scene);
  }
  return out;
}

TEST(ForeignFiles, OfTheCasesAreWrittenBackByteForByte) {
  const Written written = expect_equal_bytes_below(kCases);
  EXPECT_EQ(written.num_refused, 0u);
  EXPECT_GE(written.num_read, 6u);
  EXPECT_GE(written.num_bodies, 11u);
}

TEST(ForeignFiles, OfPublicRepositoriesAreWrittenBackByteForByte) {
  if (!folder_of_public_files()) GTEST_SKIP() << "TRIVET_FOREIGN_FILES is not set";
  const Written written = expect_equal_bytes_below(folder_of_public_files());
  std::cout << written.num_read << " files are read, " << written.num_refused << " refused; "
            << written.num_bodies << " bodies have a place\n";
  EXPECT_GT(written.num_read, 0u);
}

// --- poses and masses
// -----------------------------------------------------------------------------

double difference_from_compiled(const Pose& pose, const json& compiled) {
  const auto number = [&](size_t i) { return compiled[i].get<double>(); };
  const Pose want{Rotation{number(3), number(4), number(5), number(6)}.normalized(),
                  Vec3(number(0), number(1), number(2))};
  const Mat3 turned = pose.rotation.matrix() - want.rotation.matrix();
  return std::max((pose.translation - want.translation).norm(), turned.cwiseAbs().maxCoeff());
}

// A body's mass and centre are those of all that is welded to it.
bool has_the_mass(const ForeignBody& body, const json& compiled) {
  const double kilograms = compiled[7].get<double>();
  const Vec3 want(compiled[8].get<double>(), compiled[9].get<double>(), compiled[10].get<double>());
  const Vec3 centre =
      composed(body.pose, {{}, body.mass->centre.value_or(Vec3::Zero())}).translation;
  return std::abs(body.mass->kilograms - kilograms) <= kSameMass * kilograms &&
         (centre - want).norm() <= kSameMass;
}

struct Compared {
  size_t bodies = 0, masses = 0;
  std::string other_masses = {};
  double farthest = 0;
};

Compared compare(const ForeignScene& scene, const json& bodies) {
  Compared out;
  for (const ForeignBody& body : scene.bodies) {
    const auto compiled = bodies.find(body.name);
    if (compiled == bodies.end()) continue;  // a geom of the world, or without a name
    ++out.bodies;
    out.farthest = std::max(out.farthest, difference_from_compiled(body.pose, *compiled));
    if (body.fixed || !body.mass || !(body.mass->kilograms > 0)) continue;
    ++out.masses;
    if (!has_the_mass(body, *compiled))
      out.other_masses += " " + body.name + " " + std::to_string(body.mass->kilograms) + ", not " +
                          std::to_string((*compiled)[7].get<double>()) + " kg;";
  }
  return out;
}

// MuJoCo begins at zero, whatever the limits are; Trivet begins within them.
bool begins_at_a_limit(const ForeignScene& scene) {
  return std::any_of(scene.joints.begin(), scene.joints.end(), [](const ForeignJoint& joint) {
    return joint.value != 0 && (joint.value == joint.lower || joint.value == joint.upper);
  });
}

/// Files by how near the poses are. Those that say what is not read may differ.
struct Comparison {
  size_t compiled = 0, refused = 0, same = 0, close = 0, said = 0, wrong = 0;
  size_t bodies = 0, masses = 0, files_of_other_masses = 0;

  void note(const std::string& file, const ForeignScene& scene, const Compared& found) {
    bodies += found.bodies, masses += found.masses;
    files_of_other_masses += !found.other_masses.empty();
    if (!found.other_masses.empty())
      std::cout << file << ": other mass or centre:" << found.other_masses << "\n";
    if (found.farthest <= kSamePose) return void(++same);
    if (found.farthest <= kClosePose) return void(++close);
    const bool is_said = !scene.unread.empty() || !scene.notes.empty() || begins_at_a_limit(scene);
    ++(is_said ? said : wrong);
    std::cout << file << ": " << found.farthest << (is_said ? ", as it says\n" : "\n");
  }
};

TEST(ForeignFiles, OfPublicRepositoriesStandAsInMuJoCo) {
  const char* const lines = std::getenv("TRIVET_FOREIGN_COMPILED");
  if (!folder_of_public_files() || !lines)
    GTEST_SKIP() << "TRIVET_FOREIGN_FILES or TRIVET_FOREIGN_COMPILED is not set";
  const fs::path folder = folder_of_public_files();
  Comparison all;
  std::ifstream in(lines);
  for (std::string line; std::getline(in, line);) {
    const json compiled = json::parse(line);
    if (!compiled.contains("states")) continue;
    ++all.compiled;
    const std::string file = compiled["file"];
    const auto scene = scene_of(folder / file, folder);
    if (!scene) {
      std::cout << file << ": is refused\n";
      ++all.refused;
      continue;
    }
    const json& states = compiled["states"];
    all.note(file, *scene, compare(*scene, states[scene->key.empty() ? "reference" : "key"]));
  }
  std::cout << all.compiled << " files that MuJoCo compiles: " << all.same << " to 1e-9, "
            << all.close << " to 1e-6, " << all.said << " say what is not read, " << all.wrong
            << " differ, " << all.refused << " are refused; " << all.bodies << " bodies, "
            << all.masses << " masses, other ones in " << all.files_of_other_masses << " files\n";
  EXPECT_GT(all.compiled, 0u);
  EXPECT_GE(10 * (all.same + all.close), 9 * all.compiled);
  EXPECT_EQ(all.wrong, 0u);
}

}  // namespace
}  // namespace trivet
