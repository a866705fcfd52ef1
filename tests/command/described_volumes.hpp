// Folders of real volumes. Each volume has a JSON file of the same name with "file" and "iso", a
// list of thresholds on stored samples.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace discmc::command {

struct DescribedVolume {
  std::filesystem::path file;
  std::vector<int32_t> thresholds;
};

/// The value of "key". The files are flat, except for the list.
inline std::string json_value(const std::string& json, const std::string& key) {
  const size_t at = json.find('"' + key + '"');
  if (at == std::string::npos) return {};
  const size_t begin = json.find(':', at) + 1;
  const size_t first = json.find_first_not_of(" \n\r\t", begin);
  if (json[first] == '[') return json.substr(first + 1, json.find(']', first) - first - 1);
  if (json[first] == '"') return json.substr(first + 1, json.find('"', first + 1) - first - 1);
  return json.substr(first, json.find_first_of(",}", first) - first);
}

inline DescribedVolume read_description(const std::filesystem::path& file) {
  std::ifstream stream(file);
  const std::string json{std::istreambuf_iterator<char>(stream), {}};
  DescribedVolume volume{file.parent_path() / json_value(json, "file"), {}};
  std::string list = json_value(json, "iso");
  std::replace(list.begin(), list.end(), ',', ' ');
  std::istringstream thresholds(list);
  for (int32_t threshold = 0; thresholds >> threshold;) volume.thresholds.push_back(threshold);
  return volume;
}

/// All volumes of a folder, by name.
inline std::vector<DescribedVolume> described_volumes(const std::filesystem::path& folder) {
  std::vector<DescribedVolume> volumes;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") volumes.push_back(read_description(entry.path()));
  std::sort(volumes.begin(), volumes.end(),
            [](const DescribedVolume& a, const DescribedVolume& b) { return a.file < b.file; });
  return volumes;
}

}  // namespace discmc::command
