#include "stack.hpp"

#include <fstream>
#include <map>
#include <string>
#include <system_error>

#include "text/number_text.hpp"
#include "text/words.hpp"

namespace discmc::command {
namespace {

bool begins_with(const std::string& text, const std::string& begin) {
  return text.rfind(begin, 0) == 0;
}

// Returns a section of the log: one "key=value" per line.
std::map<std::string, std::string> section(const std::filesystem::path& log,
                                           std::string_view name) {
  std::map<std::string, std::string> values;
  std::ifstream in(log);
  bool is_inside = false;
  for (std::string line; std::getline(in, line);) {
    const std::string_view text = trimmed(line);
    const std::size_t equals = text.find('=');
    if (!text.empty() && text.front() == '[') is_inside = text == name;
    if (is_inside && equals != std::string_view::npos)
      values.emplace(trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1)));
  }
  return values;
}

std::optional<SkyScanLog> parsed(const std::filesystem::path& file) {
  auto values = section(file, "[Reconstruction]");
  constexpr double mm_of_um = 1e-3;
  auto pixel_um = decimal(values["Pixel Size (um)"]);
  if (!(pixel_um > 0.0))
    pixel_um = decimal(section(file, "[Acquisition]")["Image Pixel Size (um)"]);
  if (!pixel_um || *pixel_um <= 0) return std::nullopt;
  const double step = decimal(values["Section to Section Step"]).value_or(1);
  SkyScanLog log;
  log.file = file;
  log.spacing_mm.fill(*pixel_um * mm_of_um);
  log.spacing_mm[2] *= step > 0 ? step : 1;
  log.size = {whole_number<std::uint32_t>(values["Result Image Width (pixels)"]).value_or(0),
              whole_number<std::uint32_t>(values["Result Image Height (pixels)"]).value_or(0)};
  return log;
}

}  // namespace

bool is_overview_name(const std::filesystem::path& file) {
  const std::string stem = lower(file.stem().string());
  constexpr std::string_view end = "_spr";
  return stem.size() > end.size() && stem.substr(stem.size() - end.size()) == end;
}

std::optional<SkyScanLog> skyscan_log(const std::filesystem::path& slice) {
  const std::filesystem::path folder = slice.parent_path();
  std::optional<SkyScanLog> found;
  std::error_code error;
  for (const auto& entry :
       std::filesystem::directory_iterator(folder.empty() ? "." : folder, error)) {
    const std::filesystem::path& file = entry.path();
    if (lower(file.extension().string()) != ".log" ||
        !begins_with(slice.stem().string(), file.stem().string()))
      continue;
    // Among several logs, the longest name is the part nearest to the slice.
    const bool is_nearer =
        !found || file.stem().native().size() > found->file.stem().native().size();
    if (auto log = is_nearer ? parsed(file) : std::nullopt) found = std::move(log);
  }
  return found;
}

}  // namespace discmc::command
