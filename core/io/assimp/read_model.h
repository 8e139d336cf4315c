// Formats that assimp reads.
#pragma once

#include <string>
#include <string_view>

#include "core/io/read_model.h"

namespace trivet {

/// A file as it is handed to assimp.
struct AssimpFile {
  std::string extension;       // by which it chooses its reader: not always that of the name
  std::string_view head;       // its first bytes, text as UTF-8
  bool is_other_text = false;  // text with a byte order mark or in UTF-16, handed over as UTF-8
};

/// FBX, Collada, 3DS and what else assimp knows. @throws Error (BadInput), std::bad_alloc.
Model read_assimp_model(const std::string& path, const AssimpFile& file,
                        const ImportLimits& limits);

}  // namespace trivet
