#include "gpu/zlist/measured_shapes.h"

#include <cmath>
#include <numbers>

namespace trivet {
namespace {

/// @param vertex  of a row and a column.
template <class Vertex>
std::shared_ptr<const Shape> grid(int rows, int columns, const Vertex& vertex) {
  std::vector<Triangle> faces;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      faces.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return make_shape(weld(faces));
}

}  // namespace

std::shared_ptr<const Shape> bumpy_sphere(int rows) {
  const int columns = rows + rows / 3;
  return grid(rows, columns, [&](int i, int j) {
    const double polar = std::numbers::pi * i / rows,
                 turn = 2 * std::numbers::pi * (j % columns) / columns;
    const double radius = 1 + 0.05 * std::sin(5 * polar) * std::cos(7 * turn);
    return Vec3(radius * std::sin(polar) * std::cos(turn),
                radius * std::sin(polar) * std::sin(turn), radius * std::cos(polar));
  });
}

std::shared_ptr<const Shape> flat_square(int rows) {
  return grid(rows, rows,
              [&](int i, int j) { return Vec3(2.0 * i / rows - 1, 2.0 * j / rows - 1, 0); });
}

}  // namespace trivet
