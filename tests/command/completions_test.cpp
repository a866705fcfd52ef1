// Completions of the command line, tested in the shells.
#include "cli/help/outline.hpp"

#include "command.hpp"

namespace {

using namespace command_tests;

std::string bash_offers(const std::string& line) {
  const Result result = Workshop().shell(
      "\"$discmc\" completions bash > completions\n"
      "bash --norc -c '. ./completions; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1))\n"
      "function=$(complete -p discmc | sed \"s/.*-F \\([^ ]*\\) .*/\\1/\")\n"
      "$function discmc \"${COMP_WORDS[COMP_CWORD]}\" \"${COMP_WORDS[COMP_CWORD - 1]}\"\n"
      "echo ${COMPREPLY[*]}' bash discmc " +
      line);
  CHECK(result.code == 0);
  CHECK(result.error.empty());
  return result.out;
}

std::string fish_offers(const std::string& line) {
  const Result result = Workshop().shell(
      "\"$discmc\" completions fish > completions\n"
      "HOME=. fish --no-config -c '. ./completions; complete -C \"discmc " +
      line + "\"' | cut -f 1 | tr '\\n' ' '");
  CHECK(result.code == 0);
  return result.out;
}

}  // namespace

TEST_CASE("bash completes commands, options and the accepted words of option values") {
  if (!Workshop().has_program("bash")) return;
  CHECK(bash_offers("ex") == "extract\n");
  CHECK(contains(bash_offers("''"), "extract view info render compare"));
  CHECK(bash_offers("--ve") == "--version\n");
  CHECK(bash_offers("extract v.nrrd --bor") == "--border\n");
  CHECK(bash_offers("extract v.nrrd --border ''") == "closed open\n");
  CHECK(bash_offers("render --border o") == "open\n");
  CHECK(bash_offers("decode --conf") == "--conforming\n");
  CHECK(bash_offers("completions ''") == "bash zsh fish\n");
}

TEST_CASE("bash completes file names by its own default") {
  if (!Workshop().has_program("bash")) return;
  CHECK(bash_offers("extract v") == "\n");
  CHECK(bash_offers("extract v.nrrd -o v") == "\n");
  CHECK(bash_offers("extract v.nrrd --iso -") == "\n");
  CHECK(contains(Workshop().done("completions bash"), "\ncomplete -o default -F "));
}

TEST_CASE("fish completes commands, options and the accepted words of option values") {
  if (!Workshop().has_program("fish")) return;
  CHECK(fish_offers("ex") == "extract ");
  CHECK(fish_offers("extract v.nrrd --bor") == "--border ");
  CHECK(fish_offers("extract v.nrrd --border ") == "closed open ");
  CHECK(fish_offers("completions ") == "bash fish zsh ");
}

TEST_CASE("each shell accepts its completions as a script") {
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    if (!Workshop().has_program(shell)) continue;
    INFO(shell);
    const Result result = Workshop().shell("\"$discmc\" completions " + shell +
                                           " > completions && " + shell + " -n completions");
    CHECK(result.code == 0);
    CHECK(result.error.empty());
  }
}

TEST_CASE("zsh completes the values, files and texts of options") {
  const std::string script = Workshop().done("completions zsh");
  CHECK(script.rfind("#compdef discmc\n", 0) == 0);
  CHECK(contains(script, "'extract:Extract the surface of a volume as a mesh or a stream'"));
  CHECK(contains(script, "'(--border)--border["));
  CHECK(contains(script, "]:closed|open:(closed open)'"));
  CHECK(contains(script, "]:FILE:_files'"));
  CHECK(contains(script, "'*--iso["));
  CHECK(contains(script, "'1:FILE:_files'"));
}

TEST_CASE("completion scripts quote special characters in texts of the command line") {
  const std::string text = "it's [a] volume: $HOME `ls`; and more";
  discmc::command::CommandOutline program{"it", text, {}, {}, {}, "", ""};
  program.groups = {{"Options", {{{"-o"}, "", {}, text, false, false}}}};
  CHECK(contains(discmc::command::zsh_completions(program),
                 "'(-o)-o[it'\\''s \\[a\\] volume\\: $HOME `ls`]'"));
  CHECK(contains(discmc::command::fish_completions(program),
                 " -d 'it'\\''s [a] volume: $HOME `ls`'\n"));
  CHECK(!contains(discmc::command::bash_completions(program), "HOME"));
}

TEST_CASE("completions of another shell are refused") {
  const Result result = Workshop().run("completions csh");
  CHECK(result.code == 2);
  CHECK(contains(result.error, "invalid value 'csh'; expected bash|zsh|fish"));
}
