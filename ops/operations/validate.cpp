#include "ops/operations/validate.h"

#include <array>
#include <cmath>
#include <sstream>

#include "core/scene/materials.h"
#include "ops/free_places/place_region.h"

namespace trivet {
namespace {

using Found = std::optional<InvalidArgument>;

constexpr double kUnitTolerance = 1e-9;  // of a quaternion's squared length

template <class Values>
std::string shown(const Values& values) {
  std::ostringstream out;
  const char* separator = "[";
  for (const double value : values) out << separator << value, separator = ", ";
  out << "]";
  return out.str();
}

Found refuse_number(const char* key, double value, double lower, double upper) {
  if (value >= lower && value <= upper) return std::nullopt;
  return InvalidArgument{key, in_english(figure(value)),
                         say("a number from %1 to %2", figure(lower), figure(upper))};
}

template <class Vec>
Found refuse_components(const char* key, const Vec& v, const Accepts& accepts) {
  if ((v.array() >= accepts.lower && v.array() <= accepts.upper).all()) return std::nullopt;
  return InvalidArgument{
      key, shown(v),
      say("%1 numbers from %2 to %3", v.size(), figure(accepts.lower), figure(accepts.upper))};
}

template <class Vec>
Found refuse_vector(const char* key, const Vec& v, const Accepts& accepts) {
  if (auto found = refuse_components(key, v, accepts)) return found;
  // Directions shorter than this lose their digits when they are made unit.
  if (accepts.sort != Sort::Direction || v.cwiseAbs().maxCoeff() >= kMinDirectionComponent)
    return std::nullopt;
  return InvalidArgument{key, shown(v), "a direction whose length is not zero"};
}

Found refuse_rotation(const char* key, const Rotation& q) {
  const double squared = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  if (std::abs(squared - 1) <= kUnitTolerance) return std::nullopt;
  return InvalidArgument{key, shown(std::array{q.w, q.x, q.y, q.z}),
                         "a quaternion [w, x, y, z] of length 1"};
}

Found refuse_material(const PhysicsMaterial& m) {
  if (auto found = refuse_number("friction", m.friction, kMinFriction, kMaxFriction)) return found;
  if (auto found = refuse_number("density", m.density, kMinDensity, kMaxDensity)) return found;
  if (auto found = refuse_number("restitution", m.restitution, 0, kMaxRestitution)) return found;
  if (m.name.empty() || is_preset(m)) return std::nullopt;
  return InvalidArgument{"material", "\"" + m.name + "\"",
                         "no name, or a preset's with its numbers"};
}

/// Checks one value of a field; names are left to the scene.
struct Check {
  const Field& field;

  Found operator()(const double* v) const { return number(*v); }
  Found operator()(const int* v) const { return number(*v); }
  Found operator()(const std::uint64_t* v) const { return number(static_cast<double>(*v)); }
  Found operator()(const Rotation* v) const { return refuse_rotation(field.key, *v); }
  Found operator()(const PhysicsMaterial* v) const { return refuse_material(*v); }
  Found operator()(const Vec2* v) const { return vector(*v); }
  Found operator()(const Vec3* v) const { return vector(*v); }
  template <class T>
  Found operator()(const std::optional<T>* v) const {
    if constexpr (!std::is_same_v<T, std::string>)
      if (*v) return (*this)(&**v);
    return std::nullopt;
  }
  template <class Vec>
  Found operator()(const std::vector<Vec>* v) const {
    if constexpr (!std::is_same_v<Vec, std::string>) {
      for (const Vec& one : *v)
        if (auto found = vector(one)) return found;
      if constexpr (std::is_same_v<Vec, Vec2>)
        if (field.accepts.sort == Sort::Region && !v->empty() && !is_convex_region(*v))
          return InvalidArgument{field.key, std::to_string(v->size()) + " corners", kConvexRegion};
    }
    return std::nullopt;
  }
  Found operator()(const bool*) const { return std::nullopt; }
  Found operator()(const std::string*) const { return std::nullopt; }
  Found operator()(const WordSlot&) const { return std::nullopt; }

 private:
  Found number(double v) const {
    if (field.accepts.none == v) return std::nullopt;
    return refuse_number(field.key, v, field.accepts.lower, field.accepts.upper);
  }
  template <class Vec>
  Found vector(const Vec& v) const {
    return refuse_vector(field.key, v, field.accepts);
  }
};

}  // namespace

Found find_invalid_argument(const Operation& operation) {
  const OperationTable& table = table_of(operation);
  void* const data = const_cast<void*>(data_of(operation));  // slots are only read here
  const size_t form = table.form_of(data);
  // Fields of other forms are not looked at.
  for (const Field& field : table.fields) {
    if (!field.is_in(form)) continue;
    if (auto found = std::visit(Check{field}, field.slot(data))) return found;
  }
  return table.rule ? table.rule(data) : std::nullopt;
}

std::optional<Refusal> validate(const Operation& operation) {
  const auto found = find_invalid_argument(operation);
  if (!found) return std::nullopt;
  Refusal why{Refusal::Cause::InvalidArgument};
  why.detail = say("%1: %2", std::string(op_name(operation)), in_words(*found));
  return why;
}

}  // namespace trivet
