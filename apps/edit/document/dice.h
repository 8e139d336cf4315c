// Random numbers and turns of what is put many times: the same on every machine.
#pragma once

#include <cstdint>
#include <random>

#include "core/motion/pose.h"

namespace trivet::edit {

/// Rotation given to objects before they are put.
enum class RandomTurn { None, Yaw, Any };

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : m_engine(seed) {}
  double uniform(double low, double high);
  std::uint64_t seed() { return m_engine() >> 11; }  // JSON keeps 53 bits
  Rotation rotation();
  Rotation turned(RandomTurn how, const Rotation& r);

 private:
  std::mt19937_64 m_engine;
};

}  // namespace trivet::edit
