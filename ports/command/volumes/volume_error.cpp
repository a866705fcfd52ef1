#include "volume_error.hpp"

#include "text/words.hpp"

namespace discmc::command {

VolumeError::VolumeError(const std::string& file, const std::string& fault,
                         const std::string& remedy)
    : std::runtime_error(file + ": " + fault + "; " + remedy),
      file_(file),
      fault_(fault),
      remedy_(remedy) {}

void fail(const std::string& file, const std::string& fault, const std::string& remedy) {
  throw VolumeError(file, fault, remedy);
}

void fail_type(const std::string& file, std::string_view type) {
  fail(file, "samples of type " + shown(type) + " are not supported",
       "give a volume with one number per voxel: whole, or floating point of 32 or 64 bits");
}

void require_slice_left(const std::string& file, std::size_t read, std::size_t slices) {
  if (read == slices)
    fail(file, "all " + std::to_string(read) + " slices have been read", "open the volume again");
}

std::string shown(std::string_view text) {
  constexpr std::size_t max_shown = 60;
  std::string result = "'";
  for (const char c : text.substr(0, max_shown)) result += is_control(c) ? '?' : c;
  return result + (text.size() > max_shown ? "...'" : "'");
}

}  // namespace discmc::command
