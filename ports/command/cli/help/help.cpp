#include "outline.hpp"

#include <cstddef>
#include <sstream>

namespace discmc::command {
namespace {

constexpr std::size_t width = 80;
constexpr std::size_t text_column = 26;

// Breaks words into lines that begin at a column. The first line is already at that column.
std::string wrapped(const std::string& text, std::size_t column) {
  std::string lines;
  std::size_t at = column;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (at > column && at + 1 + word.size() > width) {
      lines += '\n' + std::string(column, ' ');
      at = column;
    } else if (at > column) {
      lines += ' ';
      ++at;
    }
    lines += word;
    at += word.size();
  }
  return lines + '\n';
}

// Puts a term on the left and its text on the right, or below a long term.
std::string entry(const std::string& term, const std::string& text) {
  std::string line = "  " + term;
  if (line.size() + 2 > text_column)
    line += '\n' + std::string(text_column, ' ');
  else
    line.append(text_column - line.size(), ' ');
  return line + wrapped(text, text_column);
}

std::string term(const OptionOutline& option) {
  const std::string names = CLI::detail::join(option.names, ", ");
  return option.value.empty() ? names : names + " " + option.value;
}

}  // namespace

std::string help(const CommandOutline& outline) {
  std::string text = outline.description + "\n\nUsage: " + outline.usage + "\n";
  if (!outline.arguments.empty()) text += '\n';
  for (const OptionOutline& argument : outline.arguments)
    text += entry(argument.names.front(), argument.description);
  if (!outline.commands.empty()) text += "\nCommands:\n";
  for (const CommandOutline& command : outline.commands)
    text += entry(command.name, command.description);
  for (const GroupOutline& group : outline.groups) {
    text += '\n' + group.title + ":\n";
    for (const OptionOutline& option : group.options)
      text += entry(term(option), option.description);
  }
  if (!outline.commands.empty())
    text += '\n' + outline.name + " COMMAND --help lists the options of a command.\n";
  if (!outline.footer.empty()) text += '\n' + outline.footer + '\n';
  return text;
}

}  // namespace discmc::command
