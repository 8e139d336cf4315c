// Sandboxed import of untrusted files: in a separate process, within limits.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/io/process/protection.h"
#include "core/io/read_model.h"
#include "core/model/model.h"

namespace trivet {

class ImporterServer;

/// While it lives, what this thread imports shares importers: each file is still read by a process
/// of its own, within its limits, but forked from one that has been started, as starting it takes
/// longer than reading a small model. Of several the innermost counts.
class SharedImporters {
 public:
  SharedImporters();
  ~SharedImporters();
  SharedImporters(const SharedImporters&) = delete;
  SharedImporters& operator=(const SharedImporters&) = delete;

 private:
  friend Model read_model_sandboxed(const std::string& path, const ImportLimits& limits,
                                    const Tessellation& tessellation,
                                    const std::atomic<bool>* cancel);
  // One that is idle, or a new one.
  std::unique_ptr<ImporterServer> take(const std::string& importer);

  SharedImporters* m_outer;
  std::vector<std::unique_ptr<ImporterServer>> m_idle;
};

/// Like read_model(), but run by the program limits.importer: a file on which the import library
/// crashes, hangs or exhausts memory gives an Error, and this process survives. The result is
/// validated like a file. STEP, IGES and BREP are read by the same program's name with suffix
/// "-cad", if the build had Open CASCADE. Thread-safe.
///
/// @param cancel  once another thread sets it, the program is killed. Null: never.
/// @throws Error: BadInput as read_model(), for a crash or an exceeded limit, and if cancelled;
///   Environment if the program is missing or cannot be started.
Model read_model_sandboxed(const std::string& path, const ImportLimits& limits,
                           const Tessellation& tessellation = {},
                           const std::atomic<bool>* cancel = nullptr);

/// read_model_sandboxed() if limits.importer names a program, else read_model(), which cannot be
/// cancelled.
Model import_model(const std::string& path, const ImportLimits& limits,
                   const Tessellation& tessellation = {},
                   const std::atomic<bool>* cancel = nullptr);

/// Protection of the importers of this process: what all had that it has started for models so far.
/// @return nullopt: there was none. Thread-safe.
std::optional<Protection> import_protection();

/// Starts an importer that reads nothing.
/// @return what confines it. nullopt: it does not say.   @throws Error (Environment)
std::optional<Protection> protection_of(const std::string& importer);

/// Path in the environment variable TRIVET_IMPORTER, else trivet-import beside the running program
/// or in its parent folder; empty: not found.
std::string find_importer();

/// Child side: says first of all what confines it. @return false: nobody listens.
bool answer_protection(const Protection& protection, int descriptor);

/// Child side: writes the model that `read` returns, or its error, to a descriptor.
/// @param path  of the file, for messages.
/// @return the exit status.
int serve_import(const std::function<Model()>& read, const std::string& path,
                 const ImportLimits& limits, int descriptor);

}  // namespace trivet
