// A random order that a seed gives. Private.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace trivet {

/// Reproducible on every machine, unlike std::shuffle [Steele 2014, splitmix64].
class Shuffler {
 public:
  explicit Shuffler(std::uint64_t seed) : m_state(seed) {}
  template <class T>
  void shuffle(std::vector<T>& values) {
    for (size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[next() % i]);
  }

 private:
  std::uint64_t next() {
    std::uint64_t z = (m_state += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  std::uint64_t m_state;
};

}  // namespace trivet
