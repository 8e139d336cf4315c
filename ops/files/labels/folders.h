// File names of data sets. Private.
#pragma once

#include <cstdint>
#include <string>

namespace trivet {

/// 000017
std::string number_text(std::int64_t number);

/// Limit of a file that describes a set.
inline constexpr std::uintmax_t kMaxSetBytes = std::uintmax_t{1} << 30;

}  // namespace trivet
