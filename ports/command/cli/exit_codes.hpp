// The exit codes of the program; `discmc --help` lists them, too.
#ifndef DISCMC_COMMAND_CLI_EXIT_CODES_HPP
#define DISCMC_COMMAND_CLI_EXIT_CODES_HPP

namespace discmc::command {

constexpr int exit_ok = 0;
constexpr int exit_failure = 1;
constexpr int exit_usage = 2;
constexpr int exit_incomplete = 3;

}  // namespace discmc::command

#endif
