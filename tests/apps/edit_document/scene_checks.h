// What must hold of a snapshot after every commit.
#pragma once

#include <string>

#include "apps/edit/document/snapshot.h"

namespace trivet::edit::test {

/// As a number: poses, states, links, names; the same bits give the same.
std::uint64_t fingerprint(const SceneSnapshot& scene);
/// What is wrong: interpenetration, unrest that nobody tells of. Empty: nothing.
std::string wrong_with(const SceneSnapshot& scene);

}  // namespace trivet::edit::test
