// Mutated model files.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "core/model/model.h"
#include "support/mutated_gltf.h"
#include "support/stored_zip.h"

namespace trivet::test {

/// splitmix64: the same numbers everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : m_state(seed) {}
  std::uint64_t next() {
    std::uint64_t z = m_state += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
  }
  size_t below(size_t limit) { return limit ? next() % limit : 0; }

 private:
  std::uint64_t m_state;
};

struct Seed {
  std::string extension, bytes;
};

inline std::vector<Seed> read_corpus(const std::string& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_regular_file()) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<Seed> out;
  for (const std::filesystem::path& path : paths) {
    std::ifstream in(path, std::ios::binary);
    out.push_back({path.extension().string(), {std::istreambuf_iterator<char>(in), {}}});
  }
  return out;
}

// Replaces a number in text by an unexpected one.
inline void replace_number(std::string& bytes, Random& random) {
  static const char* const numbers[] = {
      "-1",    "0",   "1",           "2147483648", "4294967295",
      "1e39",  "nan", "1e-320",      "-0",         "99999999999999999999",
      "65536", "",    "3.4028236e38"};
  const size_t start = random.below(bytes.size());
  const auto is_digit = [](unsigned char c) { return c >= '0' && c <= '9'; };
  const auto begin = std::find_if(bytes.begin() + static_cast<long>(start), bytes.end(), is_digit);
  const auto end = std::find_if_not(begin, bytes.end(), is_digit);
  if (begin != bytes.end()) bytes.replace(begin, end, numbers[random.below(std::size(numbers))]);
}

// Lines of text, or the bytes between two line ends: what formats are made of.
inline std::pair<size_t, size_t> line_at(const std::string& bytes, size_t at) {
  const size_t before = bytes.rfind('\n', at), begin = before == bytes.npos ? 0 : before + 1;
  const size_t end = bytes.find('\n', std::max(begin, at));
  return {begin, end == bytes.npos ? bytes.size() : end + 1};
}

// Repeats, moves, joins or removes a line.
inline void mutate_line(std::string& bytes, Random& random) {
  const auto [begin, end] = line_at(bytes, random.below(bytes.size()));
  const std::string line = bytes.substr(begin, end - begin);
  const size_t kind = random.below(4);
  if (kind != 0) bytes.erase(begin, kind == 3 && !line.empty() ? 0 : end - begin);
  if (kind == 3 && end > begin) bytes.erase(end - 1, 1);
  if (kind < 2 && !bytes.empty())
    bytes.insert(line_at(bytes, random.below(bytes.size())).first, line);
}

inline void mutate_once(std::string& bytes, const std::vector<Seed>& corpus, Random& random) {
  if (bytes.empty()) return;
  const size_t at = random.below(bytes.size());
  const size_t count = std::min(bytes.size() - at, 1 + random.below(64));
  switch (random.below(11)) {
    case 0:
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8)));
      break;
    case 1:
      bytes[at] = static_cast<char>(random.next());
      break;
    case 2:  // a 32-bit number that may overflow
      for (size_t i = 0; i < 4 && at + i < bytes.size(); ++i)
        bytes[at + i] = static_cast<char>(random.below(2) ? 0xff : random.below(2) ? 0x7f : 0);
      break;
    case 3:
      bytes.erase(at, count);
      break;
    case 4:
      bytes.insert(at, bytes.substr(random.below(bytes.size()), count));
      break;
    case 5:
      bytes.resize(at);
      break;
    case 6: {
      const std::string& other = corpus[random.below(corpus.size())].bytes;
      if (!other.empty()) bytes.insert(at, other.substr(random.below(other.size()), count));
      break;
    }
    case 7:
    case 8:
      mutate_line(bytes, random);
      break;
    default:
      replace_number(bytes, random);
  }
}

inline std::string why_invalid(const Model& model) {
  const size_t num_faces = model.mesh.triangles.size();
  if (num_faces == 0) return "no triangle";
  for (const Vec3& p : model.mesh.vertices)
    if (!p.allFinite()) return "a non-finite vertex";
  for (const Index3& t : model.mesh.triangles)
    for (const Index v : t)
      if (v < 0 || static_cast<size_t>(v) >= model.mesh.vertices.size())
        return "an index out of range";
  if (model.materials.empty() || model.face_material.size() != num_faces) return "materials";
  return "";
}

// A 3MF of this model: the corpus has the XML, as a change within an archive fails its checksum.
inline std::string archive_of(const std::string& model) {
  testing::StoredZip zip;
  zip.add("3D/3dmodel.model", model);
  return zip.bytes();
}

/// Case `number` of a seed: the same bytes on every run.
inline std::string mutant(const std::vector<Seed>& corpus, std::uint64_t seed, size_t number) {
  Random random(seed * 1'000'003 + number);
  const Seed& original = corpus[number % corpus.size()];
  std::string bytes = original.bytes;
  if (bytes.rfind("glTF", 0) == 0 && random.below(2)) {
    bytes = mutated_gltf(bytes, random);
  } else {
    const size_t times = 1 + random.below(3);
    for (size_t i = 0; i < times; ++i) mutate_once(bytes, corpus, random);
  }
  if (original.extension == ".3mf") bytes = archive_of(bytes);
  if (original.extension == ".3mf" && random.below(4) == 0) mutate_once(bytes, corpus, random);
  return bytes;
}

/// Formats of Trivet's own readers, which must not crash, hang or want more memory than there is.
inline bool is_own(const std::string& extension) {
  return extension == ".obj" || extension == ".stl" || extension == ".ply" || extension == ".off" ||
         extension == ".3mf";
}

}  // namespace trivet::test
