#include "input_kind.hpp"

#include "mesh_options.hpp"
#include "option_checks.hpp"
#include "volume_options.hpp"
#include "volumes/format_list.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {
namespace {

bool is_for_volumes(const CLI::Option& option) {
  return option.get_group() == volume_group || option.get_group() == surface_group;
}

bool is_for_streams(const CLI::Option& option) {
  return option.get_group() == stream_group;
}

const CLI::Option* given_option(const CLI::App& app, bool (*is_meant)(const CLI::Option&)) {
  for (const CLI::Option* option : app.get_options())
    if (option->count() > 0 && is_meant(*option)) return option;
  return nullptr;
}

}  // namespace

std::optional<bool> is_volume_input(const CLI::App& app, const std::string& input) {
  if (is_stream_name(input)) return false;
  if (is_volume_name(input) || given_option(app, is_for_volumes) != nullptr) return true;
  if (given_option(app, is_for_streams) != nullptr) return false;
  return std::nullopt;
}

void check_mesh_input(const CLI::App& app, const std::string& input) {
  const CLI::Option* option = given_option(app, [](const CLI::Option& each) {
    return is_for_volumes(each) || is_for_streams(each) || each.get_group() == mesh_group;
  });
  if (option != nullptr)
    refuse(option->get_name(),
           "applies to volumes and streams, and " + input + " is a mesh; leave it out");
}

void check_kind(const CLI::App& app, const std::string& input, bool is_volume) {
  const CLI::Option* option = given_option(app, is_volume ? is_for_streams : is_for_volumes);
  if (option != nullptr)
    refuse(option->get_name(), (is_volume ? "applies to streams, and " + input + " is a volume"
                                          : "applies to volumes, and " + input + " is a stream") +
                                   "; leave it out");
}

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
