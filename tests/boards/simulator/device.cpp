#include "device.hpp"

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>

namespace discmc::simulator {
namespace {

constexpr std::chrono::milliseconds time_to_start{30000};
// If paths are given, the user starts the device.
constexpr std::chrono::milliseconds time_to_start_by_hand{300000};
constexpr std::chrono::milliseconds time_to_end{30000};

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "discmc-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::runtime_error(name + ": no folder can be made: " + std::strerror(errno));
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

Device::Device(const Options& options) {
  const bool is_own = !options.firmware.empty();
  const auto path = [&](const std::string& given, const char* own) {
    return is_own ? folder_.file(own) : given;
  };
  const Qemu::Files files{path(options.stream, "stream"), path(options.rows, "rows"),
                          path(options.monitor, "monitor"), folder_.file("console")};
  stream_ = std::make_unique<Line>(files.stream);
  rows_ = std::make_unique<Line>(files.rows);
  if (!files.monitor.empty()) monitor_ = std::make_unique<Line>(files.monitor);
  if (is_own)
    qemu_ = std::make_unique<Qemu>(options.firmware, files);
  else
    std::cerr << "waiting for the device\n";
  for (Line* line : {stream_.get(), rows_.get(), monitor_.get()})
    if (line != nullptr) line->connect(is_own ? time_to_start : time_to_start_by_hand);
}

std::string Device::mistake(int expected_code) const {
  if (!qemu_) return {};
  const std::optional<int> code = qemu_->wait(time_to_end);
  if (!code) return "the firmware has not ended";
  if (*code == expected_code) return {};
  return "the firmware has ended with " + std::to_string(*code) + " instead of " +
         std::to_string(expected_code);
}

std::string Device::console() const {
  std::ifstream file(folder_.file("console"));
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace discmc::simulator
