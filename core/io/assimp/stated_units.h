// Units that files state and assimp leaves out.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace trivet {

/// Metres per unit by the first bytes of an AMF, X3D or DXF file, or as its format has it without a
/// word: millimetres of AMF, metres of X3D. nullopt: other formats, and DXF without a unit.
/// @param format  as in Model. @param head  text as UTF-8.
std::optional<double> stated_unit(const std::string& format, std::string_view head);

}  // namespace trivet
