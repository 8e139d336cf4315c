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

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/io/process/sandboxed_import.h"
#include "fuzz/mutants.h"

namespace {

namespace fs = std::filesystem;
using trivet::test::is_own;
using trivet::test::read_corpus;
using trivet::test::Seed;
using trivet::test::why_invalid;

constexpr double kSeconds = 5, kLateSeconds = 60;  // the machine may be busy
constexpr std::uintmax_t kMemoryBytes = std::uintmax_t{512} << 20;

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
    const Seed& seed = m_corpus[number % m_corpus.size()];
    const std::string bytes = trivet::test::mutant(m_corpus, m_seed, number);
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
