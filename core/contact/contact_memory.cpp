#include "core/contact/contact_memory.h"

#include <algorithm>
#include <cstring>

namespace trivet {
namespace {

constexpr size_t kMostBytes = 24'000'000;  // about

thread_local ContactMemory* first_living = nullptr;

double* append(const Affine& m, double* to) {
  to = std::copy_n(m.linear.data(), 9, to);
  return std::copy_n(m.translation.data(), 3, to);
}

}  // namespace

ContactMemory::ContactMemory() {
  if (!first_living) first_living = this;
}

ContactMemory::~ContactMemory() {
  if (first_living == this) first_living = nullptr;
}

ContactMemory* ContactMemory::current() { return first_living; }

size_t ContactMemory::Hash::operator()(const Question& question) const {
  // Poses tell questions apart well enough; shapes are left to the comparison.
  std::uint64_t sum = 0;
  for (const double x : question.numbers) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    sum = (sum ^ bits) * 0x9e3779b97f4a7c15u;
    sum ^= sum >> 32;
  }
  return static_cast<size_t>(sum);
}

const std::vector<ContactPoint>& ContactMemory::points(const Body& a, const Body& b,
                                                       double tolerance, double slack,
                                                       const Find& find) {
  // Poses, tolerance and slack are compared exactly: a remembered answer equals a new one.
  Question question{a.shape, b.shape, {a.shape->id, b.shape->id}, {}};
  double* const end =
      append(b.world_from_object, append(a.world_from_object, question.numbers.data()));
  end[0] = tolerance;
  end[1] = slack;
  const auto known = m_known.find(question);
  if (known != m_known.end()) return known->second;
  // Forgetting all at once bounds the memory without any order of age.
  if (m_bytes >= kMostBytes) m_known.clear(), m_bytes = 0;
  std::vector<ContactPoint>& points = m_known[question] = find();
  m_bytes +=
      sizeof(Question) + sizeof(std::vector<ContactPoint>) + points.size() * sizeof(ContactPoint);
  return points;
}

}  // namespace trivet
