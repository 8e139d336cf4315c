// Models: geometry and appearance, from files or from arrays.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "trivet/geometry.h"

TRIVET_BEGIN

struct ModelLimits {
  double max_seconds = 120;
  std::int64_t max_triangles = 50'000'000;
  double chord = 0;  // metres: largest deviation of polygonised STEP, IGES and BREP; 0: 1/1000 of
                     // the model's size
};

/// Content of a file, or of memory. Copies share it. Thread-safe.
class TRIVET_API Model {
 public:
  /// A model of one grey material. @throws Error as Shape.
  explicit Model(const Mesh& mesh);

  [[nodiscard]] const Shape& shape() const { return m_shape; }
  [[nodiscard]] const std::string& path() const;                // as given; empty: made from arrays
  [[nodiscard]] bool y_up() const;                              // as its format says; else z is up
  [[nodiscard]] std::optional<double> metres_per_unit() const;  // as the file says
  [[nodiscard]] const std::vector<std::string>& notes() const;  // what was noticed and left out

  struct Internal;
  [[nodiscard]] const Internal& internal() const { return *m_internal; }
  explicit Model(std::shared_ptr<const Internal> internal);

 private:
  std::shared_ptr<const Internal> m_internal;
  Shape m_shape;
};

/// Reads a model file: OBJ, glTF, PLY, STL, FBX, STEP and more. Files are untrusted: they are read
/// by the program trivet-import, with limits, wherever it is found: by the environment variable
/// TRIVET_IMPORTER, or beside the running program; else in this process.
/// @throws Error (BadInput) for a file that cannot be read; the message names it and the reason.
[[nodiscard]] TRIVET_API Model load_model(const std::string& path, const ModelLimits& limits = {});

TRIVET_END
