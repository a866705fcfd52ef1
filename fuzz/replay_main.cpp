// Runs a fuzz target on files, for compilers without libFuzzer and for a crash found elsewhere:
//
//   fuzz_table corpus/table crash-1234
//
// Folders are processed with all their contents, in the order of names.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

void collect(const fs::path& place, std::vector<fs::path>& files) {
  if (!fs::is_directory(place)) {
    files.push_back(place);
    return;
  }
  for (const auto& entry : fs::recursive_directory_iterator(place))
    if (entry.is_regular_file()) files.push_back(entry.path());
}

std::vector<std::uint8_t> content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  // Memory of exactly this size, so that a sanitizer detects a read beyond the end.
  return {bytes.begin(), bytes.end()};
}

}  // namespace

int main(int count, char** arguments) try {
  std::vector<fs::path> files;
  for (int i = 1; i < count; ++i) collect(arguments[i], files);
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    const std::vector<std::uint8_t> bytes = content(file);
    // RecordedEvent before it runs: the last name is the one that crashed.
    std::printf("%s: %zu bytes\n", file.c_str(), bytes.size());
    std::fflush(stdout);
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  std::printf("%zu inputs replayed\n", files.size());
  return files.empty() ? 2 : 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
