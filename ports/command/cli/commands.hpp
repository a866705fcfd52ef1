// The commands. Each runs with its arguments and returns the exit code of the program. On failure
// they throw std::exception with the message for the user.
#pragma once

#include "arguments.hpp"

namespace discmc::command {

int run_extract(const ExtractArguments& arguments);
int run_decode(const StreamArguments& arguments);
int run_join(const JoinArguments& arguments);
int run_info(const InfoArguments& arguments);
int run_render(const RenderArguments& arguments);
int run_compare(const CompareArguments& arguments);
int run_view(const ViewArguments& arguments);
int run_tune(const TuneArguments& arguments);

constexpr int exit_ok = 0;
constexpr int exit_failure = 1;
constexpr int exit_usage = 2;
constexpr int exit_incomplete = 3;

}  // namespace discmc::command
