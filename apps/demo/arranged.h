// Demos that are arranged by relations: `trivet arrange` finds the places.
#pragma once

#include <string>
#include <vector>

#include "apps/demo/demo.h"

namespace trivet {

struct ArrangedDemo {
  std::string name;
  std::vector<DemoModel> models;
  std::string problem;  // a file for `trivet arrange`, the models beside it
  std::string recipe;   // the same for `trivet batch`, each scene by a seed of its own
  DemoView view;
};

/// "table-for-six", "tight-table", "bookcase", "market", "office3" and "workshop".
std::vector<std::string> arranged_demo_names();

/// @throws Error (BadInput) naming the demos there are.
ArrangedDemo make_arranged_demo(const std::string& name);

}  // namespace trivet
