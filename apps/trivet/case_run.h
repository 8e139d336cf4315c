// A program in a process of its own: a command of this one run once more, or another.
#pragma once

#include <string>
#include <vector>

namespace trivet::apps {

struct CaseRun {
  int status = 0;             // of exit; 0 where a signal ended it
  int signal = 0;             // that ended it; 0: none
  bool out_of_time = false;   // it was stopped
  std::string output, error;  // the last kMostBytes of each stream
  static constexpr size_t kMostBytes = 1 << 20;
};

/// Runs this program in the current folder.
/// @param arguments  without the program's name.
/// @param seconds  of the wall, after which it is stopped.
/// @throws Error (Environment) if it cannot be started.
CaseRun run_case(const std::vector<std::string>& arguments, double seconds);

/// The same of another program. @param program  a path, or a name that is looked for in PATH.
CaseRun run_program(const std::string& program, const std::vector<std::string>& arguments,
                    double seconds);

}  // namespace trivet::apps
