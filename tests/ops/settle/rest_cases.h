// Objects at rest among fixed bodies, and one more fixed body that touches them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ops/settle/settle.h"
#include "support/random_shapes.h"

namespace trivet::test {

/// Shapes of one kind, of any size; kept alive as long as the stock.
struct Stock {
  struct Item {
    std::string name;
    std::shared_ptr<const Shape> shape;
    UpAxis up = UpAxis::Z;
  };
  std::vector<Item> objects, supports;
};

/// Solids made by formulas.
Stock made_stock();
/// Models of the paper's scenes, as the demos lay them out.
Stock demo_stock();
/// Models of ../shared/data; empty without it.
Stock real_stock();

/// An object at rest, where settling or a plain fall left it.
struct RestCase {
  std::string name;
  std::shared_ptr<const Shape> shape;
  UpAxis up = UpAxis::Z;
  double scale = 1;
  Pose pose;
  std::vector<Body> fixed;
  std::vector<std::shared_ptr<const Shape>> shapes;  // of `fixed`
  bool floor = true;
  double clearance = 0;

  Body body() const { return {*shape, world_from_object(pose, up, scale)}; }
  double size() const { return scale * shape->box.diagonal(); }
  SettleProblem problem() const;
  std::vector<ContactPoint> contacts() const;
  /// The same with one more fixed body.
  RestCase with(const Body& neighbour) const;
};

/// Number `index` of a stock: supports, object and start at random; empty when it is not at rest.
std::optional<RestCase> rest_case(const Stock& stock, int index);

enum class Side { Above, Beside, Below };
const char* to_string(Side side);

/// A body moved straight towards the object until it is one clearance away; empty when it misses.
std::optional<Body> neighbour_of(const RestCase& rest, const Stock& stock, Side side,
                                 Random& random);

/// The stock's shape that the body is made of.
std::shared_ptr<const Shape> shape_in(const Stock& stock, const Body& body);

}  // namespace trivet::test
