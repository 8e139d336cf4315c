// File names of data sets. Private.
#pragma once

#include <string>

namespace trivet {

/// 000017
std::string number_text(int number);

}  // namespace trivet
