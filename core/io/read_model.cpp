#include "core/io/read_model.h"

#include <new>
#include <optional>

#include "core/base/bad_input.h"
#include "core/base/error.h"
#include "core/base/extension.h"
#include "core/base/printable.h"
#include "core/io/assimp/read_model.h"
#include "core/io/cad_format.h"
#include "core/io/format/model_format.h"
#include "core/io/format/other_formats.h"
#include "core/io/gltf/model.h"
#include "core/io/obj/read_obj.h"
#include "core/io/off/read_off.h"
#include "core/io/opened_files.h"
#include "core/io/ply/read_ply.h"
#include "core/io/process/preflight.h"
#include "core/io/stl/read_stl.h"
#include "core/io/text/file_bytes.h"
#include "core/io/text/utf8_text.h"
#include "core/io/textures/surface_look.h"
#include "core/io/threemf/read_3mf.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const std::string& path, const ImportLimits& limits) {
  auto bytes = file_bytes(path, limits.max_file_bytes);
  if (!bytes) bad_file(path, "cannot be read");
  return *std::move(bytes);
}

FileSurface surface_of(ModelFormat format, const std::string& path, std::uintmax_t size,
                       const std::string& head, const ImportLimits& limits) {
  std::string bytes = bytes_of(path, limits);
  const bool binary =
      format == ModelFormat::ThreeMf || (format == ModelFormat::Stl && is_binary_stl(head, size));
  if (!binary) bytes = utf8_text(std::move(bytes));
  switch (format) {
    case ModelFormat::Obj:
      return read_obj(path, bytes, limits);
    case ModelFormat::Stl:
      return read_stl(path, bytes);
    case ModelFormat::Ply:
      return read_ply(path, bytes);
    case ModelFormat::Off:
      return read_off(path, bytes);
    default:
      return read_3mf(path, bytes, limits);
  }
}

Model model_of_any(const std::string& path, const ImportLimits& limits) {
  const std::string head = head_of(path), text = utf8_text(head), extension = lower_extension(path);
  check_is_model(path, head);
  const std::uintmax_t size = fs::file_size(path);
  const ModelFormat format = model_format(text, size, extension);
  if (format == ModelFormat::Gltf)
    if (auto model = read_gltf_model(path, limits)) return *std::move(model);
  // glTF 1 is left to assimp.
  if (format == ModelFormat::Gltf || format == ModelFormat::Other)
    return read_assimp_model(path, {other_extension(text, size, extension), text, text != head},
                             limits);
  return model_of_surface(surface_of(format, path, size, head, limits), limits);
}

}  // namespace

Model read_model(const std::string& path, const ImportLimits& limits) {
  check_file(path, limits);
  note_opened(path, {});
  if (const std::string format = cad_format(path); !format.empty())
    bad_file(path, "%1 files are read only by the program trivet-import-cad, never in this process",
             format);
  try {
    Model model = model_of_any(path, limits);
    // Here, as this is the process that may crash: renderers decode the same bytes again.
    for (Sentence& note : undrawn_textures(model)) model.notes.push_back(std::move(note));
    return model;
  } catch (const Error& e) {
    if (std::string(e.what()).rfind(path, 0) == 0) throw;
    bad_file(path, e.sentence());
  } catch (const std::bad_alloc&) {
    bad_file(path, "runs out of memory; the file is broken or too large");
  } catch (const std::exception& e) {
    bad_file(path, "cannot be read as a model: %1", printable(e.what()));
  }
}

}  // namespace trivet
