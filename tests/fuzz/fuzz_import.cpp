// Fuzzes the sandboxed import with mutated model files.
//
//   fuzz_import IMPORTER CORPUS COUNT [SEED [KEEP]]
//
// Cycles through the files of the folder CORPUS, mutates and imports each, COUNT times in all, on
// all cores. Case i of a seed is the same file on every run. Fails if the outcome is neither a
// model nor an Error, if a model violates the guarantees of core/io/model.h, or if an import
// greatly exceeds its time or memory limit. Files on which the importer's process crashed or hung,
// which sandboxing allows, are counted, and kept in the folder KEEP.
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/io/process/sandboxed_import.h"
#include "support/mutated_gltf.h"
#include "support/stored_zip.h"

namespace {

namespace fs = std::filesystem;

constexpr double kSeconds = 5, kLateSeconds = 60;  // the machine may be busy
constexpr std::uintmax_t kMemoryBytes = std::uintmax_t{512} << 20;

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

std::vector<Seed> read_corpus(const std::string& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file()) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<Seed> out;
  for (const fs::path& path : paths) {
    std::ifstream in(path, std::ios::binary);
    out.push_back({path.extension().string(), {std::istreambuf_iterator<char>(in), {}}});
  }
  return out;
}

// Replaces a number in text by an unexpected one.
void replace_number(std::string& bytes, Random& random) {
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
std::pair<size_t, size_t> line_at(const std::string& bytes, size_t at) {
  const size_t before = bytes.rfind('\n', at), begin = before == bytes.npos ? 0 : before + 1;
  const size_t end = bytes.find('\n', std::max(begin, at));
  return {begin, end == bytes.npos ? bytes.size() : end + 1};
}

// Repeats, moves, joins or removes a line.
void mutate_line(std::string& bytes, Random& random) {
  const auto [begin, end] = line_at(bytes, random.below(bytes.size()));
  const std::string line = bytes.substr(begin, end - begin);
  const size_t kind = random.below(4);
  if (kind != 0) bytes.erase(begin, kind == 3 && !line.empty() ? 0 : end - begin);
  if (kind == 3 && end > begin) bytes.erase(end - 1, 1);
  if (kind < 2 && !bytes.empty())
    bytes.insert(line_at(bytes, random.below(bytes.size())).first, line);
}

void mutate_once(std::string& bytes, const std::vector<Seed>& corpus, Random& random) {
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

std::string why_invalid(const trivet::Model& model) {
  const size_t num_faces = model.mesh.triangles.size();
  if (num_faces == 0) return "no triangle";
  for (const trivet::Vec3& p : model.mesh.vertices)
    if (!p.allFinite()) return "a non-finite vertex";
  for (const trivet::Index3& t : model.mesh.triangles)
    for (const trivet::Index v : t)
      if (v < 0 || static_cast<size_t>(v) >= model.mesh.vertices.size())
        return "an index out of range";
  if (model.materials.empty() || model.face_material.size() != num_faces) return "materials";
  return "";
}

// A 3MF of this model: the corpus has the XML, as a change within an archive fails its checksum.
std::string archive_of(const std::string& model) {
  trivet::testing::StoredZip zip;
  zip.add("3D/3dmodel.model", model);
  return zip.bytes();
}

// Formats of Trivet's own readers, which must not crash, hang or want more memory than there is.
bool is_own(const std::string& extension) {
  return extension == ".obj" || extension == ".stl" || extension == ".ply" || extension == ".3mf";
}

class Fuzzer {
 public:
  Fuzzer(const std::string& importer, const std::string& corpus, std::uint64_t seed,
         std::string keep)
      : m_corpus(read_corpus(corpus)), m_seed(seed), m_keep(std::move(keep)) {
    m_limits.importer = importer;
    m_limits.max_seconds = kSeconds;
    m_limits.max_memory_bytes = kMemoryBytes;
    m_limits.max_triangles = 1'000'000;
  }

  bool run(size_t count) {
    if (m_corpus.empty()) {
      std::cout << "the corpus is empty\n";
      return false;
    }
    std::atomic<size_t> next = 0;
    const auto work = [&](unsigned worker) {
      for (size_t i; (i = next++) < count;) one(i, worker);
    };
    std::vector<std::jthread> workers;
    for (unsigned w = 0; w < std::max(1u, std::thread::hardware_concurrency()); ++w)
      workers.emplace_back(work, w);
    workers.clear();
    std::cout << count << " mutated files of seed " << m_seed << ":";
    for (const auto& [outcome, number] : m_outcomes)
      std::cout << " " << number << " " << outcome << ",";
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    std::cout << " slowest " << m_slowest << " s, largest process " << children.ru_maxrss / 1024
              << " MiB; " << m_failures << " failures\n";
    const bool too_large =
        static_cast<std::uintmax_t>(children.ru_maxrss) * 1024 > 2 * kMemoryBytes;
    return m_failures == 0 && !too_large;
  }

 private:
  void one(size_t number, unsigned worker) {
    Random random(m_seed * 1'000'003 + number);
    const Seed& seed = m_corpus[number % m_corpus.size()];
    std::string bytes = seed.bytes;
    if (bytes.rfind("glTF", 0) == 0 && random.below(2)) {
      bytes = trivet::test::mutated_gltf(bytes, random);
    } else {
      const size_t times = 1 + random.below(3);
      for (size_t i = 0; i < times; ++i) mutate_once(bytes, m_corpus, random);
    }
    if (seed.extension == ".3mf") bytes = archive_of(bytes);
    if (seed.extension == ".3mf" && random.below(4) == 0) mutate_once(bytes, m_corpus, random);
    const fs::path file =
        fs::temp_directory_path() /
        ("trivet_fuzz_" + std::to_string(getpid()) + "_" + std::to_string(worker) + seed.extension);
    std::ofstream(file, std::ios::binary) << bytes;
    const auto begin = std::chrono::steady_clock::now();
    std::string outcome = imported(file.string());
    if (is_own(seed.extension) && outcome != "read" && outcome != "refused" &&
        !outcome.starts_with("FAILED"))
      outcome = "FAILED: " + outcome + " of " + seed.extension;
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    fs::remove(file);
    note(number, seed.extension, bytes, outcome, seconds);
  }

  std::string imported(const std::string& file) const {
    try {
      const std::string why = why_invalid(trivet::import_model(file, m_limits));
      return why.empty() ? "read" : "FAILED: a model with " + why;
    } catch (const trivet::Error& e) {
      const std::string message = e.what();
      if (e.kind() != trivet::Error::Kind::BadInput) return "FAILED: environment: " + message;
      if (message.find(file) == std::string::npos)
        return "FAILED: does not name the file: " + message;
      if (message.find(" stopped with ") != std::string::npos) return "crashed the importer";
      if (message.find("longer than the limit") != std::string::npos) return "hung the importer";
      if (message.find("memory") != std::string::npos) return "wanted too much memory";
      return "refused";
    } catch (const std::exception& e) {
      return std::string("FAILED: ") + e.what();
    }
  }

  void note(size_t number, const std::string& extension, const std::string& bytes,
            std::string outcome, double seconds) {
    const std::lock_guard lock(m_mutex);
    if (seconds > kLateSeconds) outcome = "FAILED: took " + std::to_string(seconds) + " s";
    m_slowest = std::max(m_slowest, seconds);
    const bool failed = outcome.rfind("FAILED", 0) == 0;
    m_failures += failed;
    if (failed) std::cout << "case " << number << extension << ": " << outcome << "\n";
    ++m_outcomes[failed ? "failed" : outcome];
    const bool unusual = outcome != "read" && outcome != "refused";
    if (!unusual || m_keep.empty()) return;
    fs::create_directories(m_keep);
    std::ofstream(fs::path(m_keep) / ("case_" + std::to_string(number) + extension),
                  std::ios::binary)
        << bytes;
  }

  const std::vector<Seed> m_corpus;
  const std::uint64_t m_seed;
  const std::string m_keep;
  trivet::ImportLimits m_limits;
  std::mutex m_mutex;
  std::map<std::string, size_t> m_outcomes;
  size_t m_failures = 0;
  double m_slowest = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::cerr << "fuzz_import IMPORTER CORPUS COUNT [SEED [KEEP]]\n";
    return 2;
  }
  const std::uint64_t seed = argc > 4 ? std::strtoull(argv[4], nullptr, 10) : 1;
  Fuzzer fuzzer(argv[1], argv[2], seed, argc > 5 ? argv[5] : "");
  return fuzzer.run(std::strtoull(argv[3], nullptr, 10)) ? 0 : 1;
}
