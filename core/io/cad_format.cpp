#include "core/io/cad_format.h"

#include "core/base/extension.h"

namespace trivet {

std::string cad_format(const std::string& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".step" || extension == ".stp") return "STEP";
  if (extension == ".iges" || extension == ".igs") return "IGES";
  if (extension == ".brep" || extension == ".brp") return "BREP";
  return "";
}

}  // namespace trivet
