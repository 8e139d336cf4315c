#include "core/io/tessellation.h"

#include <cctype>
#include <filesystem>

namespace trivet {

std::string cad_format(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".step" || extension == ".stp") return "STEP";
  if (extension == ".iges" || extension == ".igs") return "IGES";
  if (extension == ".brep" || extension == ".brp") return "BREP";
  return "";
}

}  // namespace trivet
