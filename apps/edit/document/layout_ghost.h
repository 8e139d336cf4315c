// An arrangement that was found on a copy of the scene and is not done yet, or why there is none.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "apps/edit/document/ghost.h"

namespace trivet::edit {

struct LayoutGhost {
  bool ok = false;
  std::string problem;  // section "arrange" that gives it, about objects of this scene
  std::uint64_t seed = 0;
  std::uint64_t committed = 0;         // SceneSnapshot::committed that it is of
  std::string text;                    // how it went
  std::vector<Ghost::Member> members;  // where the things come to rest
  // Parts of a conflict:
  std::vector<std::string> objects;  // that it is between, the thing first
  std::set<size_t> entries;          // of Wishes, that it is between
  std::optional<size_t> cheapest;    // of these, the one to drop
  double milliseconds = 0;
};

}  // namespace trivet::edit
