#include "row_source.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "common/device_gone.hpp"
#include "common/stop_signal.hpp"

namespace discmc::device {
namespace {

class FileRows final : public RowSource {
 public:
  explicit FileRows(const std::string& path)
      : path_(path), file_(path == "-" ? STDIN_FILENO : open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    struct stat status {};
    if (file_ < 0 || fstat(file_, &status) != 0)
      throw std::runtime_error(path + ": the rows cannot be read (" + std::strerror(errno) +
                               "); check the name and its permissions");
    if (S_ISDIR(status.st_mode))
      throw std::runtime_error(path + ": this is a folder; give a file, a pipe or a device");
    is_numbered_ = S_ISREG(status.st_mode);
  }
  ~FileRows() override {
    if (file_ != STDIN_FILENO) close(file_);
  }

  bool read(std::uint32_t number, std::vector<std::uint8_t>& row) override {
    const std::uint64_t begin = is_numbered_ ? std::uint64_t{number} * row.size() : 0;
    std::size_t filled = 0;
    while (filled < row.size() && !stop_signal::came()) {
      const ssize_t count = read_some(&row[filled], row.size() - filled, begin + filled);
      if (count == 0) return false;
      if (count > 0) filled += static_cast<std::size_t>(count);
      if (count < 0 && errno != EINTR)
        throw DeviceGone(path_ + ": the rows cannot be read: " + std::strerror(errno));
    }
    return filled == row.size();
  }

 private:
  ssize_t read_some(std::uint8_t* place, std::size_t count, std::uint64_t offset) const {
    return is_numbered_ ? pread(file_, place, count, static_cast<off_t>(offset))
                        : ::read(file_, place, count);
  }

  std::string path_;
  int file_;
  bool is_numbered_ = false;
};

class SimulatedRows final : public RowSource {
 public:
  SimulatedRows(const std::array<std::uint32_t, 3>& dims, meshing::SampleType type)
      : dims_(dims), sample_bytes_(meshing::sample_bytes(type)) {}

  bool read(std::uint32_t number, std::vector<std::uint8_t>& row) override {
    const std::uint32_t y = number % dims_[1];
    const std::uint32_t z = number / dims_[1];
    for (std::uint32_t x = 0; x < dims_[0]; ++x) {
      const std::uint8_t sample =
          sample_at(from_middle(x, 0), from_middle(y, 1), from_middle(z, 2));
      row[x * sample_bytes_] = sample;
      if (sample_bytes_ > 1) row[x * sample_bytes_ + 1] = 0;
    }
    return true;
  }

 private:
  // Units: thousandths of half the extent.
  std::int64_t from_middle(std::uint32_t at, std::size_t axis) const {
    const std::int64_t extent = dims_[axis];
    return (2 * std::int64_t{at} + 1 - extent) * 1000 / extent;
  }

  static std::uint8_t sample_at(std::int64_t x, std::int64_t y, std::int64_t z) {
    constexpr std::int64_t ball = 800;
    constexpr std::int64_t hole = 300;
    const bool is_in_ball = x * x + y * y + z * z < ball * ball;
    const bool is_in_hole = x * x + y * y < hole * hole;
    const std::int64_t ripple = (x * 7 + y * 13 + z * 29) % 60;
    return static_cast<std::uint8_t>((is_in_ball && !is_in_hole ? 160 : 80) + ripple / 2);
  }

  std::array<std::uint32_t, 3> dims_;
  std::size_t sample_bytes_;
};

}  // namespace

std::unique_ptr<RowSource> open_rows(const std::string& path) {
  return std::make_unique<FileRows>(path);
}

std::unique_ptr<RowSource> simulated_rows(const std::array<std::uint32_t, 3>& dims,
                                          meshing::SampleType type) {
  return std::make_unique<SimulatedRows>(dims, type);
}

}  // namespace discmc::device
