#include "header.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include "text/words.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

// Accepts only the fields of the specification; any other may be misspelt and matter.
std::string field_name(const std::filesystem::path& file, std::string_view text) {
  constexpr std::pair<std::string_view, std::string_view> second_spellings[] = {
      {"datafile", "data file"},      {"lineskip", "line skip"}, {"byteskip", "byte skip"},
      {"axismins", "axis mins"},      {"axismaxs", "axis maxs"}, {"centers", "centerings"},
      {"blocksize", "block size"},    {"oldmin", "old min"},     {"oldmax", "old max"},
      {"sampleunits", "sample units"}};
  std::string name = lower(trimmed(text));
  for (const auto& [second, first] : second_spellings)
    if (name == second) name = first;
  constexpr std::string_view known[] = {"dimension",
                                        "type",
                                        "sizes",
                                        "spacings",
                                        "space directions",
                                        "space",
                                        "units",
                                        "encoding",
                                        "space units",
                                        "space dimension",
                                        "endian",
                                        "data file",
                                        "line skip",
                                        "byte skip",
                                        "space origin",
                                        "kinds",
                                        "axis mins",
                                        "axis maxs",
                                        "labels",
                                        "content",
                                        "number",
                                        "thicknesses",
                                        "measurement frame",
                                        "centerings",
                                        "min",
                                        "max",
                                        "sample units",
                                        "old min",
                                        "old max",
                                        "block size"};
  if (std::find(std::begin(known), std::end(known), name) == std::end(known))
    fail(file, "the header field " + shown(name) + " is unknown", "correct or delete the line");
  return name;
}

}  // namespace

NrrdHeader read_nrrd_header(ByteStream& stream) {
  const std::filesystem::path& file = stream.file();
  const std::string magic = stream.read_line().value_or("");
  if (magic.size() != 8 || magic.substr(0, 7) != "NRRD000" || magic[7] < '1' || magic[7] > '5')
    fail(file, "the file begins with " + shown(magic) + ", not with NRRD0001 to NRRD0005",
         "check that it is an NRRD file");
  NrrdHeader header{HeaderFields(file)};
  while (const auto line = stream.read_line()) {
    header.closed = line->empty();
    if (header.closed) break;
    if (line->front() == '#') continue;
    const std::size_t colon = line->find(':');
    if (colon == std::string::npos)
      fail(file, "the header line " + shown(*line) + " has no colon",
           "end the header with an empty line");
    const std::string_view text = *line;
    if (text.substr(colon, 2) == ":=") {  // a key of some program, with its value
      header.segments.add(text.substr(0, colon), text.substr(colon + 2));
      continue;
    }
    const std::string name = field_name(file, text.substr(0, colon));
    header.fields.add(name, trimmed(text.substr(colon + 1)));
    // The list is the rest of the header.
    if (name == "data file" && header.fields.text(name).rfind("LIST", 0) == 0) break;
  }
  return header;
}

void fail_axis(const HeaderFields& fields, std::size_t axis, const std::string& what) {
  const std::size_t axes = words(fields.text("sizes")).size();
  std::string order;
  for (std::size_t other = 0; other < axes; ++other)
    if (other != axis) order += std::to_string(other) + ' ';
  const std::string command =
      axes > 3 ? "make it the last one, e.g. with: unu permute -p " + order + std::to_string(axis)
               : "extract one component, e.g. with: unu slice -p 0 -a " + std::to_string(axis);
  fail(fields.file(), "axis " + std::to_string(axis + 1) + ' ' + what,
       command + " -i in.nrrd -o out.nrrd");
}

}  // namespace discmc::command
