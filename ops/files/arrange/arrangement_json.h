// Private. What is to be arranged, as layouts and problem files say it.
#pragma once

#include <string>
#include <vector>

#include "ops/arrange/arrangement.h"
#include "ops/files/arrange/problem_names.h"

namespace trivet {

enum class ArrangementPlace {
  InSection,    // "arrange" of a problem file
  InOperation,  // with "op"
};

/// @param names  of the objects. @param otherwise  things where it names none.
/// @throws Error (BadInput) with the place, the value and what is accepted.
Arrangement read_arrangement(const JsonPlace& place, ArrangementPlace kind, ProblemNames names,
                             const std::vector<std::string>& otherwise);

/// "x", "-x", "y" or "-y".
Vec3 read_front(const JsonPlace& place);
/// [{"name", "box": [lower, upper]}] of an object.
void read_zones(const JsonPlace& place, const std::string& object, std::vector<Zone>& out);
/// Numbers of levels by names.
std::map<std::string, int> read_surfaces(const JsonPlace& place);

}  // namespace trivet
