#include "stream_file.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace discmc::host {
namespace {

std::int32_t nanometres(double millimetres) {
  const double value = std::round(millimetres * 1e6);
  if (!(std::fabs(value) <= 2147483647.0))
    throw std::invalid_argument("spacing " + std::to_string(millimetres) +
                                " mm is more than the 2147 mm that a stream can hold: give the "
                                "volume a smaller unit");
  return static_cast<std::int32_t>(value);
}

}  // namespace

ByteOutput StreamOutput::byte_output() {
  return {this, [](void* context, const std::uint8_t* bytes, std::size_t count) {
            auto& self = *static_cast<StreamOutput*>(context);
            if (self.out_ != nullptr)
              self.out_->write(reinterpret_cast<const char*>(bytes),
                               static_cast<std::streamsize>(count));
            self.bytes_ += count;
            return count;
          }};
}

void read_stream(std::istream& in, Decoder& decoder,
                 const std::function<void(std::uint64_t)>& progress) {
  Status status = Status::ok;
  std::vector<char> buffer(std::size_t{1} << 16);
  while (in && status == Status::ok) {
    in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    const auto count = static_cast<std::size_t>(in.gcount());
    status = decoder.push(reinterpret_cast<const std::uint8_t*>(buffer.data()), count).status;
    if (progress) progress(decoder.report().bytes);
  }
  if (status == Status::ok) status = decoder.finish();
  if (status == Status::wrong_version)
    throw std::runtime_error(
        "the stream is of a version that this program does not know (it knows " +
        std::to_string(wire::version) + "): use a newer discmc");
  if (status != Status::ok) throw std::runtime_error(text(status));
}

std::array<std::int32_t, 3> spacing_nm(const std::array<double, 3>& spacing_mm) {
  return {nanometres(spacing_mm[0]), nanometres(spacing_mm[1]), nanometres(spacing_mm[2])};
}

std::array<double, 3> spacing_mm(const StreamHeader& header) {
  std::array<double, 3> spacing{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    spacing[axis] = header.spacing_nm[axis] != 0 ? header.spacing_nm[axis] * 1e-6 : 1.0;
  return spacing;
}

}  // namespace discmc::host
