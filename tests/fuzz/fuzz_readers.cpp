// Fuzzes Trivet's own readers with mutated model files, without a sandbox: many more than
// fuzz_import.
//
//   fuzz_readers CORPUS COUNT [SEED [KEEP]]
//
// Cycles through the files of CORPUS that are in formats of own readers, glTF and the scenes of
// other programs in CORPUS/scenes among them, COUNT times in all, in a process for each core. Fails
// if a process is killed, if a file takes longer than 10 s, if a model violates the guarantees of
// core/io/model.h, or if the error does not name the file. Such files are kept in KEEP.
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/io/foreign/mjcf/read_mjcf.h"
#include "core/io/foreign/sdf.h"
#include "core/io/foreign/urdf.h"
#include "core/io/foreign/usd/read_usda.h"
#include "core/io/read_model.h"
#include "fuzz/mutants.h"

namespace {

namespace fs = std::filesystem;
using trivet::test::Seed;

constexpr unsigned kSeconds = 10;
constexpr rlim_t kMemoryBytes = rlim_t{1} << 30;  // of addresses, with the program itself

using SceneReader = trivet::ForeignScene (*)(const std::string&, const trivet::ForeignOptions&,
                                             const trivet::MeshSource&);
/// Null: files of that extension are models.
SceneReader scene_reader(const std::string& extension) {
  if (extension == ".xml") return trivet::read_mjcf;
  if (extension == ".urdf") return trivet::read_urdf;
  if (extension == ".sdf") return trivet::read_sdf;
  return extension == ".usda" ? trivet::read_usda : nullptr;
}

/// Shared by all processes.
struct Counts {
  std::atomic<std::uint64_t> next = 0, read = 0, refused = 0, memory = 0, failures = 0;
  std::atomic<std::uint64_t> slowest_us = 0;
  std::atomic<std::uint64_t> current[256] = {};  // of each process
};

Counts* shared_counts() {
  void* const memory =
      mmap(nullptr, sizeof(Counts), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return memory == MAP_FAILED ? nullptr : new (memory) Counts;
}

class Worker {
 public:
  Worker(const std::vector<Seed>& corpus, std::uint64_t seed, std::uint64_t count, unsigned id,
         fs::path keep, Counts& counts)
      : m_corpus(corpus),
        m_seed(seed),
        m_count(count),
        m_id(id),
        m_keep(std::move(keep)),
        m_counts(counts),
        m_folder(fs::temp_directory_path() /
                 ("trivet_readers_" + std::to_string(getpid()) + "_" + std::to_string(id))) {
    fs::create_directories(m_folder);
    std::ofstream(m_folder / "of_mtl.obj")
        << "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n"
           "usemtl n o\nf 3/1 2/1 1/1\n";
    m_limits.max_triangles = 1'000'000;
    m_limits.max_file_bytes = std::uintmax_t{64} << 20;
  }
  ~Worker() { fs::remove_all(m_folder); }

  // Begins again behind a file that killed the process.
  void run() {
    while (m_counts.next < m_count) {
      const pid_t child = fork();
      if (child == 0) {
        const rlimit memory{kMemoryBytes, kMemoryBytes};
        setrlimit(RLIMIT_AS, &memory);
        for (std::uint64_t i; (i = m_counts.next++) < m_count;) one(i);
        _exit(0);
      }
      int status = 0;
      waitpid(child, &status, 0);
      if (WIFSIGNALED(status))
        fail(m_counts.current[m_id], "stopped with signal " + std::to_string(WTERMSIG(status)));
    }
  }

 private:
  void one(std::uint64_t number) {
    m_counts.current[m_id] = number;
    const std::string& extension = m_corpus[number % m_corpus.size()].extension;
    const fs::path mutant = m_folder / ("m" + extension);
    std::ofstream(mutant, std::ios::binary) << trivet::test::mutant(m_corpus, m_seed, number);
    const fs::path file = extension == ".mtl" ? m_folder / "of_mtl.obj" : mutant;
    const auto begin = std::chrono::steady_clock::now();
    alarm(kSeconds);
    read(number, file.string());
    alarm(0);
    const auto taken = std::chrono::steady_clock::now() - begin;
    const auto us = static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::microseconds>(taken).count());
    std::uint64_t slowest = m_counts.slowest_us;
    while (us > slowest && !m_counts.slowest_us.compare_exchange_weak(slowest, us)) {
    }
  }

  void read(std::uint64_t number, const std::string& file) {
    try {
      const std::string& extension = m_corpus[number % m_corpus.size()].extension;
      const auto model = [&](const std::string& path) {
        return trivet::read_model(path, m_limits);
      };
      if (const SceneReader scene = scene_reader(extension)) {
        scene(file, {}, model);
      } else {
        const std::string why = trivet::test::why_invalid(model(file));
        if (!why.empty()) return fail(number, "a model with " + why);
      }
      ++m_counts.read;
    } catch (const trivet::Error& e) {
      const std::string message = e.what();
      if (e.kind() != trivet::Error::Kind::BadInput || message.find(file) == message.npos)
        return fail(number, message);
      ++(message.find("memory") == message.npos ? m_counts.refused : m_counts.memory);
    } catch (const std::exception& e) {
      fail(number, e.what());
    }
  }

  void fail(std::uint64_t number, const std::string& why) {
    ++m_counts.failures;
    const std::string& extension = m_corpus[number % m_corpus.size()].extension;
    std::cout << "case " << number << extension << ": " << why << std::endl;
    if (m_keep.empty()) return;
    fs::create_directories(m_keep);
    std::ofstream(m_keep / ("case_" + std::to_string(number) + extension), std::ios::binary)
        << trivet::test::mutant(m_corpus, m_seed, number);
  }

  const std::vector<Seed>& m_corpus;
  const std::uint64_t m_seed, m_count;
  const unsigned m_id;
  const fs::path m_keep;
  Counts& m_counts;
  const fs::path m_folder;
  trivet::ImportLimits m_limits;
};

int fuzz(const std::vector<Seed>& corpus, std::uint64_t count, std::uint64_t seed,
         const fs::path& keep) {
  Counts* const counts = shared_counts();
  if (!counts) return 1;
  const unsigned num_workers = std::clamp(std::thread::hardware_concurrency(), 1u, 256u);
  std::vector<pid_t> workers;
  for (unsigned w = 0; w < num_workers; ++w) {
    const pid_t child = fork();
    if (child != 0) {
      workers.push_back(child);
      continue;
    }
    Worker(corpus, seed, count, w, keep, *counts).run();
    _exit(0);
  }
  bool whole = true;
  for (const pid_t worker : workers) {
    int status = 0;
    waitpid(worker, &status, 0);
    whole &= WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }
  rusage children{};
  getrusage(RUSAGE_CHILDREN, &children);
  std::cout << count << " mutated files of seed " << seed << ": " << counts->read << " read, "
            << counts->refused << " refused, " << counts->memory << " too large, slowest "
            << static_cast<double>(counts->slowest_us) * 1e-6 << " s, largest process "
            << children.ru_maxrss / 1024 << " MiB; " << counts->failures << " failures\n";
  return whole && counts->failures == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "fuzz_readers CORPUS COUNT [SEED [KEEP]]\n";
    return 2;
  }
  std::vector<Seed> corpus;
  for (const Seed& seed : trivet::test::read_corpus(argv[1]))
    if (trivet::test::is_own(seed.extension) || seed.extension == ".mtl" ||
        seed.extension == ".glb" || seed.extension == ".gltf")
      corpus.push_back(seed);
  if (const fs::path scenes = fs::path(argv[1]) / "scenes"; fs::is_directory(scenes))
    for (const Seed& seed : trivet::test::read_corpus(scenes.string()))
      if (scene_reader(seed.extension)) corpus.push_back(seed);
  if (corpus.empty()) {
    std::cout << "the corpus is empty\n";
    return 1;
  }
  return fuzz(corpus, std::strtoull(argv[2], nullptr, 10),
              argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1, argc > 4 ? argv[4] : "");
}
