#include "command_line.hpp"

namespace discmc::command {

std::vector<Command> add_commands(CLI::App& app) {
  return {add_extract(app), add_view(app), add_info(app), add_render(app),      add_compare(app),
          add_decode(app),  add_join(app), add_tune(app), add_completions(app), add_manual(app)};
}

}  // namespace discmc::command
