// Identity of objects, and of what they touch.
#pragma once

#include <cassert>
#include <cstdint>

namespace trivet {

/// Names an object for ever: a slot that is used again has another generation.
struct ObjectId {
  std::uint32_t index = 0, generation = 0;
  friend bool operator==(const ObjectId&, const ObjectId&) = default;
};

/// Partner of a contact: the floor or another object.
class Support {
 public:
  constexpr Support() = default;  // the floor
  constexpr Support(ObjectId object) : m_object(object), m_is_floor(false) {}
  static constexpr Support floor() { return {}; }

  constexpr bool is_floor() const { return m_is_floor; }
  constexpr bool is_object() const { return !m_is_floor; }
  /// Asserts that it is no floor.
  constexpr ObjectId object() const {
    assert(!m_is_floor);
    return m_object;
  }
  friend bool operator==(const Support&, const Support&) = default;

 private:
  ObjectId m_object;
  bool m_is_floor = true;
};

}  // namespace trivet
