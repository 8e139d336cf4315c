// Invariants of a snapshot after every commit.
#pragma once

#include <string>

#include "apps/edit/document/snapshot.h"

namespace trivet::edit::test {

/// Hash of poses, states, contacts, names; equal bits give equal hashes.
std::uint64_t fingerprint(const SceneSnapshot& scene);
/// Describes a violation: interpenetration, or an unrest that is not reported. Empty: valid.
std::string wrong_with(const SceneSnapshot& scene);

}  // namespace trivet::edit::test
