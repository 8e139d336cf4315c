// Formats with curved surfaces.
#pragma once

#include <string>

namespace trivet {

/// STEP, IGES or BREP by its extension (.step .stp .iges .igs .brep .brp, in any case), else "".
std::string cad_format(const std::string& path);

}  // namespace trivet
