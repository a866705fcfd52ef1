#include "outline.hpp"

#include <algorithm>
#include <cctype>

namespace discmc::command {
namespace {

bool is_lower_case(const std::string& word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char letter) {
    return std::islower(letter) != 0 || std::isdigit(letter) != 0 || letter == '-';
  });
}

// The value of an option is a file name unless CLI11 has another text for it.
std::string value_of(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return "";
  if (!option.get_option_text().empty()) return option.get_option_text();
  return option.get_type_name().rfind("TEXT", 0) == 0 ? "FILE" : "N";
}

std::vector<std::string> choices_of(const std::string& value) {
  std::vector<std::string> words = CLI::detail::split(value, '|');
  words.erase(std::remove_if(words.begin(), words.end(),
                             [](const std::string& word) { return !is_lower_case(word); }),
              words.end());
  return words;
}

// CLI11 puts a list in brackets.
std::string default_of(const CLI::Option& option) {
  const std::string value = option.get_default_str();
  return !value.empty() && value.front() == '[' ? value.substr(1, value.size() - 2) : value;
}

std::string description_of(const CLI::Option& option) {
  std::string text = option.get_description();
  if (!option.get_positional() && option.get_required()) text += " (required)";
  const std::string value = default_of(option);
  if (!value.empty()) text += " (default: " + value + ")";
  return text;
}

OptionOutline outline_of(const CLI::Option& option) {
  OptionOutline outline;
  if (option.get_positional()) {
    outline.names = {option.get_name(true)};
  } else {
    for (const std::string& name : option.get_snames()) outline.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) outline.names.push_back("--" + name);
  }
  outline.value = value_of(option);
  outline.choices = choices_of(outline.value);
  outline.description = description_of(option);
  outline.takes_file = outline.value == "FILE";
  outline.is_repeated = option.get_expected_max() == CLI::detail::expected_max_vector_size;
  return outline;
}

std::vector<const CLI::Option*> options_of(const CLI::App& app, const std::string& group) {
  return app.get_options([&group](const CLI::Option* option) {
    return option->nonpositional() && option->get_group() == group;
  });
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::string usage_of(const CommandOutline& outline, const CLI::App& app) {
  std::string usage = app.get_parent() != nullptr ? app.get_parent()->get_name() + " " : "";
  usage += app.get_name() + (commands_of(app).empty() ? "" : " COMMAND") + " [OPTIONS]";
  for (const CLI::Option* option : app.get_options()) {
    if (!option->nonpositional() || !option->get_required()) continue;
    const OptionOutline required = outline_of(*option);
    usage += " " + required.names.front() + " " + required.value;
  }
  for (const OptionOutline& argument : outline.arguments)
    usage += " " + argument.names.front() + (argument.is_repeated ? "..." : "");
  return usage;
}

// Returns the outline without subcommands.
CommandOutline command_of(const CLI::App& app) {
  CommandOutline outline;
  outline.name = app.get_name();
  outline.description = app.get_description();
  outline.footer = app.get_footer();
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional()) outline.arguments.push_back(outline_of(*option));
  for (const std::string& title : app.get_groups()) {
    GroupOutline group{title, {}};
    for (const CLI::Option* option : options_of(app, title))
      group.options.push_back(outline_of(*option));
    if (!title.empty() && !group.options.empty()) outline.groups.push_back(group);
  }
  outline.usage = usage_of(outline, app);
  return outline;
}

}  // namespace

CommandOutline outline_of(const CLI::App& app) {
  CommandOutline outline = command_of(app);
  for (const CLI::App* command : commands_of(app)) outline.commands.push_back(command_of(*command));
  return outline;
}

}  // namespace discmc::command
