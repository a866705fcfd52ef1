#include "outline.hpp"

namespace discmc::command {
namespace {

std::string joined(const std::vector<std::string>& words, const char* separator) {
  return CLI::detail::join(words, separator);
}

std::vector<std::string> names_of_commands(const CommandOutline& program) {
  std::vector<std::string> names;
  for (const CommandOutline& command : program.commands) names.push_back(command.name);
  return names;
}

std::vector<OptionOutline> options_of(const CommandOutline& command) {
  std::vector<OptionOutline> options;
  for (const GroupOutline& group : command.groups)
    options.insert(options.end(), group.options.begin(), group.options.end());
  return options;
}

std::vector<std::string> names_of_options(const CommandOutline& command) {
  std::vector<std::string> names;
  for (const OptionOutline& option : options_of(command))
    names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

// Shortens a description to the width of a menu.
std::string brief(const std::string& description) {
  return CLI::detail::trim_copy(description.substr(0, description.find_first_of(";(")));
}

// Quotes a word for the shell.
std::string quoted(const std::string& text) {
  return "'" + CLI::detail::find_and_replace(text, "'", "'\\''") + "'";
}

// ---- bash ----

// The completions of an option: its words, or the shell's own completions if it has none.
std::string bash_case(const std::vector<std::string>& patterns,
                      const std::vector<std::string>& words) {
  return patterns.empty()
             ? ""
             : "    " + joined(patterns, "|") + ") words='" + joined(words, " ") + "' ;;\n";
}

std::string bash_cases(const std::string& command, const CommandOutline& outline,
                       std::vector<std::string> words) {
  std::string text;
  std::vector<std::string> without_words;
  for (const OptionOutline& option : options_of(outline)) {
    if (option.value.empty()) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : option.names) patterns.push_back(command + "," + name);
    if (!option.choices.empty())
      text += bash_case(patterns, option.choices);
    else
      without_words.insert(without_words.end(), patterns.begin(), patterns.end());
  }
  text += bash_case(without_words, {});
  for (const OptionOutline& argument : outline.arguments)
    words.insert(words.end(), argument.choices.begin(), argument.choices.end());
  return text + "    " + command + ",*) words='" + joined(words, " ") + "' options='" +
         joined(names_of_options(outline), " ") + "' ;;\n";
}

// ---- zsh ----

// Escapes text within the specification of an argument.
std::string zsh_escaped(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '[' || letter == ']' || letter == ':' || letter == '\\') escaped += '\\';
    escaped += letter;
  }
  return escaped;
}

std::string zsh_value(const OptionOutline& option) {
  const std::string action = option.takes_file        ? "_files"
                             : option.choices.empty() ? " "
                                                      : "(" + joined(option.choices, " ") + ")";
  return ":" + zsh_escaped(option.value) + ":" + action;
}

std::string zsh_line(const std::string& specification) {
  return " \\\n        " + quoted(specification);
}

std::string zsh_arguments(const CommandOutline& command) {
  std::string text;
  for (const OptionOutline& option : options_of(command))
    for (const std::string& name : option.names)
      text += zsh_line((option.is_repeated ? "*" : "(" + joined(option.names, " ") + ")") + name +
                       "[" + zsh_escaped(brief(option.description)) + "]" +
                       (option.value.empty() ? "" : zsh_value(option)));
  for (const OptionOutline& argument : command.arguments)
    text += zsh_line((argument.is_repeated ? "*" : "1") + zsh_value(argument));
  return text;
}

// ---- fish ----

std::string fish_option(const OptionOutline& option) {
  std::string text;
  for (const std::string& name : option.names)
    text += name[1] == '-' ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (option.takes_file)
    text += " -r -F";
  else if (!option.value.empty())
    text += " -x";
  if (!option.choices.empty()) text += " -a " + quoted(joined(option.choices, " "));
  return text + " -d " + quoted(brief(option.description)) + "\n";
}

std::string fish_options(const std::string& start, const CommandOutline& command) {
  std::string text;
  for (const OptionOutline& option : options_of(command)) text += start + fish_option(option);
  for (const OptionOutline& argument : command.arguments)
    if (!argument.choices.empty())
      text += start + " -f -a " + quoted(joined(argument.choices, " ")) + "\n";
  return text;
}

}  // namespace

std::string bash_completions(const CommandOutline& program) {
  std::string text = "_" + program.name + R"(() {
  local word=$2 before=$3 command= words= options= i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case ${COMP_WORDS[i]} in
      )" + joined(names_of_commands(program), "|") +
                     R"()
        command=${COMP_WORDS[i]}
        break
        ;;
    esac
  done
  case $command,$before in
)";
  for (const CommandOutline& command : program.commands)
    text += bash_cases(command.name, command, {});
  text += bash_cases("", program, names_of_commands(program));
  return text + R"(  esac
  [[ $word == -* ]] && words=$options
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -o default -F _)" +
         program.name + " " + program.name + "\n";
}

std::string zsh_completions(const CommandOutline& program) {
  std::string commands;
  for (const CommandOutline& command : program.commands)
    commands += "      " + quoted(command.name + ":" + zsh_escaped(command.description)) + "\n";
  std::string text = "#compdef " + program.name + "\n_" + program.name + R"(() {
  local curcontext=$curcontext state line
  local -A opt_args
  local -a commands=(
)" + commands + R"(  )
  _arguments -C)" + zsh_arguments(program) +
                     R"( \
        '1: :->command' '*:: :->arguments'
  case $state in
    command) _describe command commands ;;
    arguments) case $words[1] in
)";
  for (const CommandOutline& command : program.commands)
    text += "      " + command.name + ") _arguments" + zsh_arguments(command) + " ;;\n";
  return text + "    esac ;;\n  esac\n}\n_" + program.name + " \"$@\"\n";
}

std::string fish_completions(const CommandOutline& program) {
  const std::string start = "complete -c " + program.name;
  std::string text;
  for (const CommandOutline& command : program.commands)
    text += start + " -n __fish_use_subcommand -f -a " + command.name + " -d " +
            quoted(command.description) + "\n";
  text += fish_options(start + " -n __fish_use_subcommand", program);
  for (const CommandOutline& command : program.commands)
    text += fish_options(start + " -n '__fish_seen_subcommand_from " + command.name + "'", command);
  return text;
}

}  // namespace discmc::command
