// Scenes compared bit by bit.
#pragma once

#include <string>

#include "core/scene/scene.h"

namespace trivet::test {

/// Every field of every object, ids, links and contacts; the first difference, or nothing.
std::string difference(const Scene& a, const Scene& b);

}  // namespace trivet::test
