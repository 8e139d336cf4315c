// Parts of files that assimp 5.2 leaves out without a word.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/sentence.h"

namespace trivet {

/// Notes that count what the reader of this format passes over: texts, prototypes and levels of
/// detail of X3D, splines and curved solids of Collada and references to nothing, NURBS of FBX.
/// @param text  the file, as UTF-8 if it is text.
void note_left_out(const std::string& format, std::string_view text, std::vector<Sentence>& notes);

}  // namespace trivet
