// Contact points of pairs that were asked for before, at the same poses.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "core/contact/body.h"
#include "core/contact/contact.h"

namespace trivet {

/// While one lives, contact_points() remembers its answers on this thread: whoever lets a heap come
/// to rest asks for the same pairs again and again. They are functions of shapes and poses, so that
/// nothing but time depends on it. Shapes without an id have to live as long. Of several the
/// first one that lives remembers, for all.
class ContactMemory {
 public:
  ContactMemory();
  ~ContactMemory();
  ContactMemory(const ContactMemory&) = delete;
  ContactMemory& operator=(const ContactMemory&) = delete;

  /// The first one that lives on this thread, or null.
  static ContactMemory* current();

  using Find = std::function<std::vector<ContactPoint>()>;
  /// The result of `find` for these bodies, of before or of now.
  const std::vector<ContactPoint>& points(const Body& a, const Body& b, double tolerance,
                                          double slack, const Find& find);
  size_t num_remembered() const { return m_known.size(); }

 private:
  /// All that the points follow from.
  struct Question {
    const Shape *a, *b;
    std::array<std::uint64_t, 2> ids;  // another shape may come to be where one was
    std::array<double, 26> numbers;    // two poses, tolerance, slack

    bool operator==(const Question&) const = default;
  };
  struct Hash {
    size_t operator()(const Question& question) const;
  };

  std::unordered_map<Question, std::vector<ContactPoint>, Hash> m_known;
  size_t m_bytes = 0;
};

}  // namespace trivet
