// Python's Shape.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/index/shape.h"
#include "core/model/model.h"

namespace trivet::python {

struct PythonShape {
  std::shared_ptr<const Shape> shape;
  std::shared_ptr<const Model> model;  // its look; null: of arrays, grey
  std::vector<Index> vertex_map;       // from given vertices to those of the mesh; of arrays only
  std::string name;                    // of its file
};

}  // namespace trivet::python
