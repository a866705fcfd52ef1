#include "outline.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace discmc::command {
namespace {

// Escapes a line of text for troff.
std::string escaped(const std::string& text) {
  std::string line;
  if (!text.empty() && (text[0] == '.' || text[0] == '\'')) line = "\\&";
  for (const char letter : text)
    if (letter == '\\')
      line += "\\e";
    else if (letter == '-')
      line += "\\-";
    else
      line += letter;
  return line;
}

std::string bold(const std::string& text) {
  return "\\fB" + escaped(text) + "\\fR";
}

// A value: placeholders are in italics, literal words in bold.
std::string value_of(const OptionOutline& option) {
  std::string value;
  for (const std::string& word : CLI::detail::split(option.value, '|')) {
    const bool is_choice =
        std::find(option.choices.begin(), option.choices.end(), word) != option.choices.end();
    value +=
        (value.empty() ? "" : "|") + (is_choice ? bold(word) : "\\fI" + escaped(word) + "\\fR");
  }
  return value;
}

std::string described(const std::string& term, const std::string& text) {
  return ".TP\n" + term + "\n" + escaped(text) + "\n";
}

std::string described(const OptionOutline& option) {
  std::string names;
  for (const std::string& name : option.names) names += (names.empty() ? "" : ", ") + bold(name);
  return described(option.value.empty() ? names : names + " " + value_of(option),
                   option.description);
}

std::string entries(const std::vector<OptionOutline>& options) {
  std::string text;
  for (const OptionOutline& option : options) text += described(option);
  return text;
}

// Marks lines that troff must not fill.
std::string unfilled(const std::string& text) {
  std::string page = ".nf\n";
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) page += escaped(line) + '\n';
  return page + ".fi\n";
}

std::string section_of(const CommandOutline& command) {
  std::string text = ".SS " + escaped(command.usage) + "\n" + escaped(command.description) + ".\n";
  for (const OptionOutline& argument : command.arguments)
    text += described("\\fI" + escaped(argument.names.front()) + "\\fR", argument.description);
  for (const GroupOutline& group : command.groups)
    text += ".PP\n\\fI" + escaped(group.title) + "\\fR\n" + entries(group.options);
  return command.footer.empty() ? text : text + ".PP\n" + unfilled(command.footer);
}

std::string upper_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return text;
}

}  // namespace

std::string manual(const CommandOutline& program, const std::string& version) {
  std::string page = ".TH " + upper_case(program.name) + " 1 \"\" \"" + program.name + " " +
                     version + "\" \"User Commands\"\n.nh\n.ad l\n";
  page += ".SH NAME\n" + program.name + " \\- " + escaped(program.description) + "\n";
  page += ".SH SYNOPSIS\n";
  std::string usages;
  for (const CommandOutline& command : program.commands) usages += command.usage + '\n';
  page += unfilled(usages) + ".SH OPTIONS\n";
  for (const GroupOutline& group : program.groups) page += entries(group.options);
  page += ".SH COMMANDS\n";
  for (const CommandOutline& command : program.commands) page += section_of(command);
  // The footer: examples, and a last paragraph with the exit codes.
  const std::size_t gap = program.footer.rfind("\n\n");
  if (gap == std::string::npos) return page;
  const std::size_t begin = program.footer.find('\n') + 1;  // behind the heading
  page += ".SH EXAMPLES\n" + unfilled(program.footer.substr(begin, gap - begin));
  return page + ".SH EXIT STATUS\n" + escaped(program.footer.substr(gap + 2)) + '\n';
}

}  // namespace discmc::command
