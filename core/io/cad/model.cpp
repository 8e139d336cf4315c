#include "core/io/cad/model.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <mutex>
#include <new>

#include "core/base/error.h"
#include "core/io/cad/parts.h"
#include "core/io/format/model_format.h"
#include "core/io/process/preflight.h"

namespace trivet {
namespace {

/// Open CASCADE's readers keep state in globals, and print to standard output.
std::mutex& cad_mutex() {
  static std::mutex mutex;
  static const bool quiet = [] {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    return true;
  }();
  (void)quiet;
  return mutex;
}

}  // namespace

Model read_cad_model(const std::string& path, const ImportLimits& limits,
                     const Tessellation& tessellation) {
  const std::lock_guard lock(cad_mutex());
  check_file(path, limits);
  check_is_model(path, head_of(path));
  const auto fail = [&](const Sentence& reason) {
    throw Error(Error::Kind::BadInput, "%1: %2", path, reason);
  };
  Model model;
  model.path = path;
  model.metres_per_unit = 1;
  model.tessellation = tessellation;
  try {
    const CadParts parts = read_cad_parts(path);
    model.format = parts.format;
    model.materials = parts.materials;
    model.num_nodes = static_cast<int>(parts.parts.size());
    polygonise(parts, limits, model);
  } catch (const Standard_Failure& e) {
    fail(say("cannot be read: %1", e.GetMessageString()));
  } catch (const std::bad_alloc&) {
    fail("runs out of memory; the chord is too small or the file is broken");
  }
  return model;
}

}  // namespace trivet
