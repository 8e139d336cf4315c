// Bitwise comparison of scenes.
#pragma once

#include <string>

#include "core/scene/scene.h"

namespace trivet::test {

/// Compares every field of every object, ids, contacts; returns the first difference, or "".
std::string difference(const Scene& a, const Scene& b);
/// The same of a scene that was read from a file: objects are found by their names, and models and
/// shapes are other copies.
std::string difference_in_file(const Scene& a, const Scene& b);

}  // namespace trivet::test
