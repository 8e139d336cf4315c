// Groups of things that are placed at once, and their order.
#pragma once

#include <vector>

#include "ops/arrange/world.h"

namespace trivet {

/// A thing, or those of a pattern.
struct Item {
  std::vector<size_t> things;
  const Pattern* pattern = nullptr;
  double area = 0;    // of a thing's outline
  double weight = 1;  // of taking it out again
};

/// Supports before what they carry, then what relations refer to before what refers to it, patterns
/// before single things, then the largest first. Of a cycle of references what is met first stays
/// first.
std::vector<Item> ordered_items(const World& world);

/// Index of the item of an object; -1: it is no thing.
int item_of(const World& world, const std::vector<Item>& items, const std::string& object);

}  // namespace trivet
