#include "stream_options.hpp"

namespace discmc::command {

void add_choice_options(CLI::App& app, StreamChoice& choice) {
  app.option_defaults()->group(stream_group);
  app.add_option("--stream-channel", choice.channel,
                 "number of the surface, if a stream or link has several (default: the first)")
      ->check(CLI::Range(0, int{StreamLabel::max_channel}))
      ->option_text("N");
  app.add_option("--scan", choice.scan,
                 "number of the scan, if a link has carried several (default: the first)")
      ->check(CLI::Range(0, 65535))
      ->option_text("N");
}

}  // namespace discmc::command
