// Private. Patterns of the English sentences that come as text from elsewhere: errors of files and
// conflicts of arrangements. %1, %2, ... stand for parts.
#pragma once

#include <span>

namespace trivet::edit {

std::span<const char* const> joining_patterns();
std::span<const char* const> model_patterns();
std::span<const char* const> gltf_patterns();
std::span<const char* const> file_patterns();
std::span<const char* const> layout_patterns();
std::span<const char* const> arrangement_patterns();
std::span<const char* const> refusal_patterns();

}  // namespace trivet::edit
