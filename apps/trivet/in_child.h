// Work in a process of its own, as what it opens must not be inherited by others.
#pragma once

#include <functional>
#include <string>

namespace trivet::apps {

/// Calls work() in a child of this process, which has one thread, and gives its text.
/// @param what  is tried there, for the message when the child dies: "OpenGL's driver".
/// @throws Error as work() does; (Environment) when the child dies.
std::string in_child(const std::string& what, const std::function<std::string()>& work);

}  // namespace trivet::apps
