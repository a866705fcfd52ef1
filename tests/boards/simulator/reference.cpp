#include "reference.hpp"

#include <discmc/encoder.hpp>
#include <stdexcept>
#include <string>

namespace discmc::simulator {
namespace {

using Bytes = std::vector<std::uint8_t>;

ByteOutput output_to(Bytes& stream) {
  return {&stream, [](void* context, const std::uint8_t* bytes, std::size_t count) {
            auto& all = *static_cast<Bytes*>(context);
            all.insert(all.end(), bytes, bytes + count);
            return count;
          }};
}

void require(Status status) {
  if (status != Status::ok) throw std::invalid_argument(to_string(status));
}

template <class Sample>
void push(Extractor16& extractor, const Rows& rows, std::uint32_t number) {
  const auto* samples = reinterpret_cast<const Sample*>(rows.row(number));
  require(extractor.push(samples, rows.info().dims[0]).status);
}

void push_row(Extractor16& extractor, const Rows& rows, std::uint32_t number) {
  command::with_scanner_type(rows.info().type,
                             [&](auto type) { push<decltype(type)>(extractor, rows, number); });
}

}  // namespace

std::vector<std::uint8_t> reference_stream(const Rows& rows, const ReferenceScan& scan) {
  const Limits limits{scan.header.width, scan.header.height, scan.header.border};
  std::vector<std::uint8_t> arena(scan.memory);
  Bytes stream;
  Encoder encoder;
  Extractor16 extractor;
  require(encoder.start(scan.header.label(), output_to(stream)));
  const Status started = extractor.start(limits, scan.header.thresholds[0],
                                         {arena.data(), arena.size()}, make_sink(encoder));
  if (started == Status::too_little_memory)
    throw std::invalid_argument("--memory " + std::to_string(scan.memory) +
                                " is too little: give the arena_bytes of the firmware's scan.hpp");
  require(started);
  for (std::uint32_t number = 0; number < scan.rows; ++number) {
    const auto skipped = scan.skipped.find(number);
    if (skipped != scan.skipped.end())
      require(extractor.skip_row(skipped->second).status);
    else
      push_row(extractor, rows, number);
  }
  require(scan.is_abandoned ? extractor.abandon() : extractor.finish());
  return stream;
}

}  // namespace discmc::simulator
