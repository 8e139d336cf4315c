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

/// A body that does not move.
struct FixedBody {
  std::shared_ptr<const Shape> shape;
  UpAxis up = UpAxis::Z;
  double scale = 1;
  Pose pose;

  Body body() const { return {*shape, world_from_object(pose, up, scale)}; }
};

/// An object at rest, where settling or a plain fall left it.
struct RestCase {
  std::string name;
  std::shared_ptr<const Shape> shape;
  UpAxis up = UpAxis::Z;
  double scale = 1;
  Pose pose;
  double clearance = 0;
  SettleOptions options;
  std::shared_ptr<Scene> scene = std::make_shared<Scene>();  // of the fixed bodies

  Body body() const { return {*shape, world_from_object(pose, up, scale)}; }
  double size() const { return scale * shape->box.diagonal(); }
  Neighbourhood others() const { return {*scene, std::span<const ObjectId>()}; }
  /// @param others  this case's, alive as long as the problem.
  SettleProblem problem(const Neighbourhood& others) const;
  void add(const FixedBody& body);
  std::vector<ContactPoint> contacts() const;
  /// The same with one more fixed body.
  RestCase with(const FixedBody& neighbour) const;
};

/// Number `index` of a stock: supports, object and start at random; empty when it is not at rest.
std::optional<RestCase> rest_case(const Stock& stock, int index, const SettleOptions& options);

enum class Side { Above, Beside, Below };
const char* to_string(Side side);

/// A body moved straight towards the object until it is one clearance away; empty when it misses.
std::optional<FixedBody> neighbour_of(const RestCase& rest, const Stock& stock, Side side,
                                      Random& random);

}  // namespace trivet::test
