// expected VOLUME STREAM: checks that a board's stream of a volume is complete. It must also equal
// the library's stream on this machine, with the limits and the memory of the board's scan.hpp.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

#include <discmc/discmc.hpp>
#include <scan.hpp>

using namespace discmc;

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes read(const char* name) {
  std::ifstream file(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<scan::Sample> samples_of(const Bytes& bytes) {
  std::vector<scan::Sample> samples(bytes.size() / sizeof(scan::Sample));
  std::memcpy(samples.data(), bytes.data(), samples.size() * sizeof(scan::Sample));
  return samples;
}

std::size_t append(void* stream, const std::uint8_t* bytes, std::size_t count) {
  static_cast<Bytes*>(stream)->insert(static_cast<Bytes*>(stream)->end(), bytes, bytes + count);
  return count;
}

// With the zero that ends an earlier frame. Empty if the library refuses the volume.
Bytes stream_of(const std::vector<scan::Sample>& samples) {
  static std::uint8_t arena[scan::arena_bytes];
  Bytes stream{0};
  Encoder encoder;
  Extractor16 extractor;
  const bool good =
      encoder.start({scan::depth, {scan::spacing_nm[0], scan::spacing_nm[1], scan::spacing_nm[2]}},
                    {&stream, append}) == Status::ok &&
      extractor.start(scan::limits, scan::threshold, memory_of(arena), make_sink(encoder)) ==
          Status::ok &&
      extractor.push(samples.data(), static_cast<std::uint32_t>(samples.size())).status ==
          Status::ok &&
      extractor.finish() == Status::ok;
  return good ? stream : Bytes{};
}

bool is_complete(const Bytes& stream) {
  Decoder decoder;
  const Sink nowhere{nullptr, [](void*, const Event&) { return SinkResult::accepted; }};
  return decoder.start(nowhere) == Status::ok &&
         decoder.push(stream.data(), stream.size()).status == Status::ok &&
         decoder.finish() == Status::ok && decoder.report().is_complete() &&
         !decoder.report().is_abandoned && decoder.report().slices == scan::depth;
}

bool fails(const char* why) {
  std::fprintf(stderr, "expected: %s\n", why);
  return true;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::fputs("usage: expected VOLUME STREAM\n", stderr);
    return 2;
  }
  const Bytes expected = stream_of(samples_of(read(arguments[1])));
  const Bytes stream = read(arguments[2]);
  if (expected.empty()) return fails("the library refuses this volume");
  if (stream != expected) {
    const auto [here, there] =
        std::mismatch(expected.begin(), expected.end(), stream.begin(), stream.end());
    std::fprintf(stderr, "expected: %s differs from byte %td on: %zu bytes here, %zu there\n",
                 arguments[2], here - expected.begin(), expected.size(), stream.size());
    return 1;
  }
  if (!is_complete(stream)) return fails("the stream is not complete");
  std::printf("%zu bytes, as expected\n", stream.size());
}
