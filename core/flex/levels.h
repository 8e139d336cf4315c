// Coarser and finer bodies of one problem, and what they are made of.
#pragma once

#include "core/flex/drape.h"

namespace trivet::flex {

/// As many levels as help, such that every pinned vertex is on the coarsest.
int num_levels(const DrapeProblem& problem, const DrapeOptions& options);

/// Every second vertex of a sheet or cable.
DrapeProblem coarser(const DrapeProblem& fine);

/// Positions of the vertices of the next finer level: those of the coarser one and the middles of
/// its edges.
Points refined(const DrapeProblem& coarse, const Points& x);

/// Coarser levels have wider layers, weaker membranes, so that flaps turn far in a step, and do not
/// bend more sharply than their cells can: neighbouring faces would fold flat on each other.
/// @param above  0: the finest level.
struct LevelSettings {
  FlexMaterial material;
  double layer;
  double tolerance;
};
LevelSettings level_settings(const DrapeProblem& level, const DrapeOptions& options, int above,
                             int levels);

}  // namespace trivet::flex
