#include "stream_reader.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace discmc::meshing {

StreamReader::StreamReader(const Sink& sink, const StreamChoice& choice) : choice_(choice) {
  if (choice.scan) filter_.emplace(*choice.scan);
  status_ = decoder_.start({}, sink, choice.channel);
}

void StreamReader::read(std::istream& in, const std::function<void(std::uint64_t)>& progress) {
  std::vector<char> buffer(std::size_t{1} << 16);
  while (in) {
    in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    push(reinterpret_cast<const std::uint8_t*>(buffer.data()),
         static_cast<std::size_t>(in.gcount()));
    if (progress) progress(report().bytes);
  }
  finish();
}

void StreamReader::push(const std::uint8_t* bytes, std::size_t count) {
  census_.add(bytes, count);
  if (filter_) {
    const std::vector<std::uint8_t> chosen = filter_->select(bytes, count);
    decode(chosen.data(), chosen.size());
  } else {
    decode(bytes, count);
  }
  require_ok();
}

std::array<std::uint32_t, 3> StreamReader::dims() const {
  const std::uint32_t depth = report().has_trailer ? report().slices
                              : header().depth > 0 ? header().depth
                                                   : Limits::max_slices;
  return {header().width, header().height, depth};
}

void StreamReader::finish() {
  if (status_ == Status::ok) status_ = decoder_.finish();
  require_ok();
}

void StreamReader::require_ok() const {
  if (status_ == Status::wrong_version)
    throw std::runtime_error("stream version " + std::to_string(census_.other_version()) +
                             " is unknown; this discmc reads version " +
                             std::to_string(detail::wire::version) +
                             ", so use the release of discmc that wrote the stream");
  if (status_ != Status::ok)
    throw std::logic_error(std::string("internal error: ") + to_string(status_) + "; report it");
}

void StreamReader::decode(const std::uint8_t* bytes, std::size_t count) {
  Decoded decoded;
  do {
    decoded = decoder_.push(bytes, count);
    bytes += decoded.bytes;
    count -= decoded.bytes;
    if (decoded.status == Status::too_little_memory && memory_ == nullptr)
      decoded.status = set_memory();
    else if (decoded.status == Status::suspended)
      decoded.status = skip_lost_rows();
  } while (decoded.status == Status::ok && count > 0);
  status_ = decoded.status;
}

// The sink accepts everything, so a suspended decoder has lost rows to skip.
Status StreamReader::skip_lost_rows() {
  constexpr std::uint64_t max_work = std::uint64_t{1} << 36;  // some seconds
  const std::uint64_t work_of_row = header().width + std::uint64_t{1000};
  for (;;) {
    skipped_ += SurfaceDecoder::max_skipped_rows * work_of_row;
    if (skipped_ > max_work)
      throw std::runtime_error("the stream claims that more than " +
                               std::to_string(max_work / work_of_row) +
                               " rows were lost, which no scanner does; check the file");
    const Status status = decoder_.push(nullptr, 0).status;
    if (status != Status::suspended) return status;
  }
}

// Reserves enough for surfaces of any size. Unused memory costs nothing; pieces without room are
// joined later.
Status StreamReader::set_memory() {
  const Limits limits{header().width, header().height, header().border};
  constexpr std::uint64_t for_chains = std::uint64_t{64} << 20;
  const std::size_t bytes =
      SurfaceDecoder::minimum_bytes(limits, header().surface_count, header().levels) + for_chains;
  memory_.reset(new std::uint8_t[bytes]);
  return decoder_.set_memory({memory_.get(), bytes});
}

}  // namespace discmc::meshing
