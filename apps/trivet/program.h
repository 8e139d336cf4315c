// Command line: parses it, runs the verb, turns errors into messages and exit statuses.
#pragma once

namespace trivet::apps {

/// @return the exit status: 0 done; 1 an operation was refused or a check failed; 2 wrong usage or
///   bad input; 3 the environment.
int run_program(int argc, char** argv);

}  // namespace trivet::apps
