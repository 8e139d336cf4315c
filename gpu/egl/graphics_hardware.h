// Is there graphics hardware? Found without loading EGL or a driver, which takes long.
#pragma once

#include <string>
#include <vector>

namespace trivet {

/// A line for each device that the kernel shows: DRM render nodes and those of NVIDIA's own driver,
/// with PCI ids and the driver's name and version as far as they are known, such as
/// "renderD128 0x8086:0x46a6 i915". Empty: a renderer here can only run on the CPU.
/// @param root  the folder that is "/", for tests.   Cost: some ten microseconds a device.
std::vector<std::string> list_graphics_hardware(const std::string& root = "/");

/// The same in one line, for people and for keys; empty if there is none.
std::string graphics_hardware(const std::string& root = "/");

}  // namespace trivet
