#include "usage_error.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <regex>
#include <string_view>
#include <system_error>
#include <vector>

#include "outline.hpp"

namespace discmc::command {
namespace {

// Counts letters that are inserted, removed, replaced, or swapped with the next.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> distance(a.size() + 1,
                                                 std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        distance[i][j] = i + j;
        continue;
      }
      distance[i][j] = std::min({distance[i - 1][j] + 1, distance[i][j - 1] + 1,
                                 distance[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + 1);
    }
  return distance[a.size()][b.size()];
}

// Returns the most likely intended name, or an empty string if none is near.
std::string nearest(const std::string& name, const std::vector<std::string>& names) {
  std::string best;
  std::size_t min_distance = std::max<std::size_t>(1, name.size() / 3) + 1;
  for (const std::string& candidate : names) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance >= min_distance) continue;
    min_distance = distance;
    best = candidate;
  }
  return best;
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!command->get_group().empty()) names.push_back(command->get_name());
  return names;
}

// Returns the long names, without dashes.
std::vector<std::string> names_of_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
  return names;
}

bool is_option(const std::string& argument) {
  return argument.size() > 1 && argument[0] == '-';
}

// Returns the first unknown option, else the first surplus argument, else an empty string.
std::string first_unknown(const CLI::App& app) {
  std::vector<std::string> unknown = app.remaining();
  unknown.erase(std::remove(unknown.begin(), unknown.end(), "--"), unknown.end());
  if (unknown.empty()) return "";
  const auto option = std::find_if(unknown.begin(), unknown.end(), is_option);
  return option != unknown.end() ? *option : unknown.front();
}

// The name of an option in other programs, and its names here. The first that a command has counts.
struct Synonym {
  const char* name;
  std::vector<const char*> options;
};
const Synonym synonyms[] = {
    {"threshold", {"iso"}},
    {"isovalue", {"iso"}},
    {"iso-value", {"iso"}},
    {"isolevel", {"iso"}},
    {"level", {"iso"}},
    {"smooth", {"shade smooth", "normals surface"}},
    {"smoothing", {"smooth auto", "shade smooth", "normals surface"}},
};

std::string meant(const std::string& name, const std::vector<std::string>& options) {
  for (const Synonym& synonym : synonyms) {
    if (synonym.name != name) continue;
    for (const std::string_view option : synonym.options) {
      const std::string_view first_word = option.substr(0, option.find(' '));
      if (std::find(options.begin(), options.end(), first_word) != options.end())
        return std::string(option);
    }
  }
  return nearest(name, options);
}

std::string unknown_option(const std::string& argument, const CLI::App& app) {
  const std::string option = argument.substr(0, argument.find('='));
  const std::string name = option.substr(std::min(option.size(), option.find_first_not_of('-')));
  const std::string near = meant(name, names_of_options(app));
  const std::string remedy = !near.empty() ? "did you mean --" + near + "?"
                             : app.get_parent() == nullptr
                                 ? "give options of a command after its name"
                                 : "leave it out";
  return "'" + option + "' is not an option of " + app.get_name() + "; " + remedy;
}

// Returns the commands to suggest if a file but no command was given.
std::string lines_for_file(const std::string& file) {
  const bool is_plain = file.find_first_of(" '\"$&;()<>|*?[]\\!") == std::string::npos;
  const std::string name = is_plain ? file : "FILE";
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension == ".dmc")
    return "discmc decode " + name + " -o surface.stl, or discmc info " + name;
  for (const char* mesh : {".stl", ".ply", ".obj", ".glb", ".3mf", ".vtp"})
    if (extension == mesh) return "discmc compare " + name + ", and the surface to compare with";
  return "discmc extract " + name + " --iso auto -o surface.stl, or discmc info " + name;
}

bool is_file(const std::string& argument) {
  std::error_code ignored;
  return argument.find_first_of("./") != std::string::npos ||
         std::filesystem::exists(argument, ignored);
}

std::string unknown_command(const std::string& argument, const CLI::App& app) {
  const std::vector<std::string> commands = names_of_commands(app);
  const std::string near = nearest(argument, commands);
  if (near.empty() && is_file(argument))
    return "'" + argument + "' is not a command; write " + lines_for_file(argument);
  return "'" + argument + "' is not a command; " +
         (near.empty() ? "give one of " + CLI::detail::join(commands, ", ")
                       : "did you mean " + near + "?");
}

// A surplus file is often meant as the output.
std::string surplus_message(const std::string& argument, const CLI::App& app) {
  const CLI::Option* output = app.get_option_no_throw("--output");
  const std::string extension = std::filesystem::path(argument).extension().string();
  const bool is_volume = extension == ".gz" || extension == ".nii" || extension == ".nrrd" ||
                         extension == ".mha" || extension == ".dcm" || extension == ".png";
  std::string remedy = "leave it out";
  if (is_volume)
    remedy = "give several volumes as one pattern in quotes, as in 'FOLDER/*" + extension + "'";
  else if (output != nullptr && output->count() == 0)
    remedy = "name the output with -o " + argument;
  return "'" + argument + "' is an unexpected argument; " + remedy;
}

// Returns an empty string if all arguments are known.
std::string unknown_argument(const CLI::App& app, const CLI::Error& error) {
  const std::string argument = first_unknown(app);
  if (argument.empty()) return "";
  const bool is_command_missing = app.get_parent() == nullptr && app.get_subcommands().empty();
  const std::string first = app.remaining().front();
  if (is_command_missing && !is_option(first)) return unknown_command(first, app);
  if (is_option(argument)) return unknown_option(argument, app);
  if (app.get_parent() == nullptr) return unknown_command(argument, app);
  // Other errors come before a surplus argument. Often an option lacks its value and has consumed
  // the next argument.
  if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::ExtrasError)) return "";
  return surplus_message(argument, app);
}

// Returns the option whose value is missing, surplus or of the wrong kind; else null.
const CLI::Option* mistaken_option(const CLI::App& command, const CLI::Error& error) {
  if (error.get_name() != "ArgumentMismatch" && error.get_name() != "ConversionError")
    return nullptr;
  const std::string what = error.what();
  const std::size_t start = std::min(what.size(), what.find("--"));
  return command.get_option_no_throw(what.substr(start, what.find_first_of(": ", start) - start));
}

// Rewrites CLI11's own messages as fault, value and remedy.
std::string plain_message(const std::string& what) {
  static const std::regex member(R"((\S+): (.*) not in \{(.*)\})");
  static const std::pair<std::regex, const char*> rules[] = {
      {std::regex(R"((\S+): Value (.*) not in range \[?(\S+) (?:to|-) ([^\]]+)\]?)"),
       "$1: invalid value '$2'; expected $3 to $4"},
      {std::regex(R"((\S+) excludes (\S+))"), "$1 cannot be combined with $2; leave one out"},
      {std::regex(R"((\S+) requires (\S+))"), "$1 needs $2; add $2"}};
  std::smatch found;
  if (std::regex_match(what, found, member))
    return found.str(1) + ": invalid value '" + found.str(2) + "'; expected " +
           CLI::detail::find_and_replace(found.str(3), ",", "|");
  for (const auto& [pattern, text] : rules)
    if (std::regex_match(what, found, pattern)) return found.format(text);
  return what;
}

// Example: "B is missing; write discmc compare [OPTIONS] A B".
std::string missing_argument(const CLI::App& command, const CLI::Error& error) {
  const std::string what = error.what();
  return what.substr(0, what.find(' ')) + " is missing; write " + outline_of(command).usage;
}

// If an option has several numbers, the message gives the range of each.
std::string wrong_item(const CLI::App& command, const CLI::Error& error) {
  const std::string what = error.what();
  const CLI::Option* option = command.get_option_no_throw(what.substr(0, what.find(':')));
  const bool has_several = option != nullptr && option->get_items_expected_min() > 1;
  const std::string text = plain_message(what);
  return has_several ? std::regex_replace(text, std::regex("; expected "),
                                          "; expected " + option->get_option_text() + ", each ")
                     : text;
}

std::string wrong_value(const CLI::App& command, const CLI::Error& error) {
  const CLI::Option* option = mistaken_option(command, error);
  if (option == nullptr || option->get_option_text().empty()) return wrong_item(command, error);
  if (option->get_items_expected_max() == 1 && option->results().size() > 1)
    return option->get_name() + " is given more than once; give it once";
  const std::string values = CLI::detail::join(option->results(), ",");
  return option->get_name() +
         (values.empty() ? ": the value is missing" : ": invalid value '" + values + "'") +
         "; expected " + option->get_option_text();
}

}  // namespace

std::string usage_error(const CLI::App* app, const CLI::Error& error) {
  const std::vector<CLI::App*> commands = app->get_subcommands();
  std::string what = unknown_argument(*app, error);
  std::string help = app->get_name();
  if (commands.empty()) {
    if (what.empty())
      what = "no command is given; give one of " + CLI::detail::join(names_of_commands(*app), ", ");
  } else {
    const CLI::App& command = *commands.front();
    if (what.empty()) what = unknown_argument(command, error);
    if (what.empty() && error.get_name() == "RequiredError")
      what = missing_argument(command, error);
    if (what.empty()) what = wrong_value(command, error);
    help += " " + command.get_name();
  }
  return app->get_name() + ": " + what + "\nSee " + help + " --help.\n";
}

}  // namespace discmc::command
