#include "core/io/process/sandboxed_import.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>
#include <sstream>

#include "core/base/bad_input.h"
#include "core/base/extension.h"
#include "core/io/cad_format.h"
#include "core/io/model_bytes.h"
#include "core/io/model_folder.h"
#include "core/io/opened_files.h"
#include "core/io/process/importer_process.h"
#include "core/io/process/preflight.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;
using Clock = std::chrono::steady_clock;

constexpr double kBaseSeconds = 60, kSecondsPerByte = 1e-6;
constexpr std::uintmax_t kBaseMemory = std::uintmax_t{1} << 30, kMemoryPerByte = 64;
constexpr int kPipeBytes = 1 << 20;
constexpr double kCancelSeconds = 0.05;  // until it is noticed

ImportLimits with_defaults(ImportLimits limits, const std::string& path) {
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(path, error);
  const std::uintmax_t size = error ? 0 : bytes;
  if (!(limits.max_seconds > 0))
    limits.max_seconds = kBaseSeconds + kSecondsPerByte * static_cast<double>(size);
  if (limits.max_memory_bytes == 0) limits.max_memory_bytes = kBaseMemory + kMemoryPerByte * size;
  return limits;
}

/// Importer program for this file. @throws Error (Environment) if its format has none.
std::string importer_of(const std::string& path, const ImportLimits& limits) {
  const std::string format = cad_format(path);
  if (format.empty()) return limits.importer;
  std::string importer = limits.importer + "-cad";
  if (access(importer.c_str(), X_OK) == 0) return importer;
  throw Error(
      Error::Kind::Environment,
      "%1: %2 files need %3, which is missing: this build of Trivet lacks Open CASCADE; accepted: "
      "a build with it (Debian: libocct-data-exchange-dev libocct-ocaf-dev; TRIVET_OCCT)",
      path, format, importer);
}

/// Reads all output up to the deadline. @throws Error (BadInput) at the deadline, if the output
/// exceeds the limit, and if cancelled.
std::string received(int descriptor, const std::string& path, const ImportLimits& limits,
                     const std::atomic<bool>* cancel) {
  const auto deadline = Clock::now() + std::chrono::duration<double>(limits.max_seconds);
  std::string out;
  std::array<char, 1 << 16> block;
  while (true) {
    if (cancel && *cancel) bad_file(path, "reading it was cancelled");
    const double left = std::chrono::duration<double>(deadline - Clock::now()).count();
    if (left <= 0)
      bad_file(path, "reading it took longer than the limit of %1 s",
               static_cast<long>(std::ceil(limits.max_seconds)));
    pollfd waiting{descriptor, POLLIN, 0};
    const double wait = std::min(left, cancel ? kCancelSeconds : 1e3);
    const int ready = poll(&waiting, 1, static_cast<int>(wait * 1e3 + 1));
    if (ready < 0 && errno != EINTR) fail_environment(say("%1: cannot be awaited", path), errno);
    if (ready <= 0) continue;
    const ssize_t count = read(descriptor, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_environment(say("%1: cannot be received", path), errno);
    if (count == 0) return out;
    out.append(block.data(), static_cast<size_t>(count));
    if (out.size() > limits.max_memory_bytes) bad_file(path, "output exceeds the memory limit");
  }
}

void check_end(int status, const std::string& importer, const std::string& path,
               const ImportLimits& limits) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
    throw Error(Error::Kind::Environment, "%1: cannot be started", importer);
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGXCPU)
    bad_file(path, "reading it took longer than the limit of %1 s",
             static_cast<long>(std::ceil(limits.max_seconds)));
  const std::string extension = lower_extension(path);
  bad_file(
      path,
      "the reader for %1 stopped with %2: a fault of the reader, or it needs more memory than "
      "the limit of %3 MiB",
      extension.empty() ? Sentence("this file") : say("%1 files", extension),
      signal ? Sentence(std::string(strsignal(signal))) : say("status %1", WEXITSTATUS(status)),
      limits.max_memory_bytes >> 20);
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<size_t>(count));
  }
  return true;
}

// Begins an answer; what confines the importer follows, a byte.
constexpr std::string_view kAnswerMagic = "TRIVET-IMPORTER-1\n";

// The parts of all importers so far; no bits: none was started.
std::atomic<unsigned> g_protection = 0;
constexpr unsigned kStarted = 0x100;

void remember(std::uint8_t bits) {
  unsigned before = g_protection;
  while (!g_protection.compare_exchange_weak(
      before, before & kStarted ? before & (kStarted | bits) : kStarted | bits)) {
  }
}

// Takes it from the beginning of an answer.
std::uint8_t take_protection(std::string_view& answer) {
  if (!answer.starts_with(kAnswerMagic) || answer.size() == kAnswerMagic.size())
    throw Error(Error::Kind::BadInput, "the importer's answer is incomplete");
  const auto bits = static_cast<std::uint8_t>(answer[kAnswerMagic.size()]);
  answer.remove_prefix(kAnswerMagic.size() + 1);
  return bits;
}

// Names of the files that an importer opened come before the model: each name with its end, an
// empty one.
std::string bytes_of_names(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += name + '\0';
  return out + '\0';
}

// Takes them; those that a model cannot have opened are left out, as the importer is not trusted.
std::vector<std::string> take_names(std::string_view& answer, const std::string& model) {
  const ModelFolder folder(model);
  std::vector<std::string> out;
  while (true) {
    const size_t end = answer.find('\0');
    if (end == answer.npos)
      throw Error(Error::Kind::BadInput, "the importer's answer is incomplete");
    const std::string name(answer.substr(0, end));
    answer.remove_prefix(end + 1);
    if (name.empty()) return out;
    if (folder.has(name)) out.push_back(name);
  }
}

// Importers of this thread; null: each file has an importer of its own.
thread_local SharedImporters* t_shared = nullptr;

struct Pipe {
  Descriptor input, output;
};

Pipe make_pipe(const std::string& path) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) fail_environment(say("%1: cannot create a pipe", path), errno);
  fcntl(ends[0], F_SETPIPE_SZ, kPipeBytes);  // or as it is
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// The importer's answer, and in `status` how it ended.
std::string answer_of(const std::string& importer, const ImportRequest& request,
                      ImporterServer* server, const std::atomic<bool>* cancel, int& status) {
  Pipe pipe = make_pipe(request.path);
  std::optional<ImporterProcess> own;
  if (server)
    server->ask(request, pipe.output.number());
  else
    own.emplace(importer, request.texts(), pipe.output.number());
  pipe.output.reset();
  std::string bytes = received(pipe.input.number(), request.path, request.limits, cancel);
  status = server ? server->status() : own->wait();
  return bytes;
}

}  // namespace

SharedImporters::SharedImporters() : m_outer(t_shared) { t_shared = this; }

SharedImporters::~SharedImporters() { t_shared = m_outer; }

std::unique_ptr<ImporterServer> SharedImporters::take(const std::string& importer) {
  for (auto it = m_idle.begin(); it != m_idle.end(); ++it) {
    if ((*it)->program() != importer) continue;
    std::unique_ptr<ImporterServer> out = std::move(*it);
    m_idle.erase(it);
    return out;
  }
  return std::make_unique<ImporterServer>(importer);
}

Model read_model_sandboxed(const std::string& path, const ImportLimits& given,
                           const Tessellation& tessellation, const std::atomic<bool>* cancel) {
  check_file(path, given);  // checks that need no other process
  const std::string importer = importer_of(path, given);
  const ImportLimits limits = with_defaults(given, path);
  // An exception ends the importer, with what it is doing.
  std::unique_ptr<ImporterServer> shared = t_shared ? t_shared->take(importer) : nullptr;
  int status = 0;
  const std::string bytes =
      answer_of(importer, {path, limits, tessellation}, shared.get(), cancel, status);
  check_end(status, importer, path, limits);
  if (shared) t_shared->m_idle.push_back(std::move(shared));
  try {
    std::string_view answer = bytes;
    const std::uint8_t protection = take_protection(answer);
    note_opened(path, take_names(answer, path));
    Model model = model_from_bytes(answer, path, limits);
    remember(protection);
    if (model.polygonised) model.tessellation = tessellation;
    return model;
  } catch (const Error& e) {
    const std::string message = e.what();
    if (message.rfind(path, 0) == 0 || e.kind() != Error::Kind::BadInput) throw;
    bad_file(path, e.sentence());
  }
}

namespace {

// Told where scenes apply it; metres need no word.
void note_unit(Model& model, bool is_given) {
  const double metres = model.metres_per_unit.value_or(1);
  if (metres == 1) return;
  std::ostringstream note;
  note << "the unit is " << metres << " m, " << (is_given ? "as given" : "says the file")
       << "; scenes apply it where no scale is given";
  model.notes.push_back(note.str());
}

}  // namespace

Model import_model(const std::string& path, const ImportLimits& limits,
                   const Tessellation& tessellation, const std::atomic<bool>* cancel) {
  Model model = limits.importer.empty() ? read_model(path, limits)
                                        : read_model_sandboxed(path, limits, tessellation, cancel);
  const bool is_given = limits.metres_per_unit > 0, is_cad = !cad_format(path).empty();
  if (is_given && !is_cad) model.metres_per_unit = limits.metres_per_unit;
  if (is_given && is_cad)
    model.notes.push_back("the unit that was given is left out: curved models come in metres");
  note_unit(model, is_given);
  return model;
}

std::optional<Protection> import_protection() {
  const unsigned bits = g_protection;
  if (!(bits & kStarted)) return std::nullopt;
  return protection_of_bits(static_cast<std::uint8_t>(bits));
}

std::optional<Protection> protection_of(const std::string& importer) {
  constexpr double kSeconds = 10;
  Pipe pipe = make_pipe(importer);
  const ImporterProcess process(importer, {kAskProtection}, pipe.output.number());
  pipe.output.reset();
  ImportLimits limits;
  limits.max_seconds = kSeconds;
  limits.max_memory_bytes = kAnswerMagic.size() + 1;
  const std::string bytes = received(pipe.input.number(), importer, limits, nullptr);
  std::string_view answer = bytes;
  if (bytes.empty()) return std::nullopt;
  return protection_of_bits(take_protection(answer));
}

std::string find_importer() {
  if (const char* named = std::getenv("TRIVET_IMPORTER")) return named;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return "";
  for (const fs::path& folder : {program.parent_path(), program.parent_path().parent_path()})
    if (const fs::path importer = folder / "trivet-import"; access(importer.c_str(), X_OK) == 0)
      return importer.string();
  return "";
}

bool answer_protection(const Protection& protection, int descriptor) {
  std::string answer(kAnswerMagic);
  answer += static_cast<char>(bits_of(protection));
  return write_all(descriptor, answer);
}

int serve_import(const std::function<Model()>& read, const std::string& path,
                 const ImportLimits& limits, int descriptor) {
  const auto answer = [&](const std::string& bytes) {
    const std::string names = bytes_of_names(files_opened_for(path).value_or(Names{}));
    return write_all(descriptor, names) && write_all(descriptor, bytes) ? 0 : 1;
  };
  try {
    return answer(bytes_of_model(read()));
  } catch (const Error& e) {
    return answer(bytes_of_error(e.kind(), e.sentence()));
  } catch (const std::bad_alloc&) {
    return answer(
        bytes_of_error(Error::Kind::BadInput, say("%1: needs more memory than the limit of %2 MiB",
                                                  path, limits.max_memory_bytes >> 20)));
  }
}

}  // namespace trivet
