// Numbers of MuJoCo's joints (qpos) as arrays in NumPy's format.
#pragma once

#include <string>
#include <vector>

namespace trivet {

/// True for names of such files: .npy.
bool is_qpos_array(const std::string& path);

/// @param count  numbers that the model has. @throws Error (BadInput): no array of one row of so
///   many float64 or float32 numbers, or one that is not finite.
std::vector<double> read_qpos_array(const std::string& path, size_t count);

/// One dimension, float64, little-endian; version 1.0 of the format.
std::string qpos_array(const std::vector<double>& numbers);

}  // namespace trivet
