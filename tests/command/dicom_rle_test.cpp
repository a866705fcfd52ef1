// DICOM in RLE: every sample type, and contradicting data.
#include "command.hpp"
#include "dicom_files.hpp"

namespace {

using namespace dicom_files;
using namespace volume_files;

using Strings = std::vector<std::string>;

constexpr std::size_t header_bytes = 64;
const std::string rle_syntax = "1.2.840.10008.1.2.5";

std::string packed(const std::string& bytes) {
  constexpr std::size_t longest = 128;
  std::string result;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t beyond = std::min(at + longest, bytes.size());
    std::size_t end = at + 1;
    const bool is_repeated = end < beyond && bytes[end] == bytes[at];
    while (end < beyond && (bytes[end] == bytes[at]) == is_repeated) ++end;
    const std::size_t length = end - at;
    result += static_cast<char>(is_repeated ? 257 - length : length - 1);
    result += bytes.substr(at, is_repeated ? 1 : length);
    at = end;
  }
  return result;
}

// A frame of these segments. offsets: of the header, if they are to be wrong.
std::string rle(const Strings& segments, std::vector<std::uint64_t> offsets = {},
                std::uint64_t count = 0) {
  std::string data;
  const bool is_right = offsets.empty();
  for (const std::string& segment : segments) {
    if (is_right) offsets.push_back(header_bytes + data.size());
    data += segment + std::string(segment.size() % 2, '\0');
  }
  std::string header = number_bytes(count == 0 ? segments.size() : count, 4, Order::little_endian);
  for (const std::uint64_t offset : offsets)
    header += number_bytes(offset, 4, Order::little_endian);
  header.resize(header_bytes);
  return header + data;
}

// The segments of samples, the highest bytes first.
Strings segments(const std::vector<std::int64_t>& values, std::size_t sample_bytes) {
  Strings result;
  for (std::size_t byte = sample_bytes; byte-- > 0;) {
    std::string plane;
    for (const std::int64_t value : values) plane += static_cast<char>(value >> 8 * byte & 0xff);
    result.push_back(packed(plane));
  }
  return result;
}

std::string frame(int z) {
  return rle(segments(slice_values(z), 2));
}

Strings all_frames() {
  Strings result;
  for (int z = 0; z < depth; ++z) result.push_back(frame(z));
  return result;
}

std::string file(const Strings& fragments, const std::vector<std::uint64_t>& offsets = {}) {
  return frames().fragments(fragments, offsets).file(Order::little_endian, rle_syntax);
}

// The error of reading one slice with this RLE data.
std::string refused(const std::string& data) {
  const Folder folder;
  return refusal(
      folder.write("v.dcm", slice(0).fragments({data}).file(Order::little_endian, rle_syntax)));
}

TEST_CASE_FIXTURE(Folder, "RLE of 8, 16 and 32 bits is read with and without sign") {
  for (const std::size_t bits : {8U, 16U, 32U})
    for (const bool is_signed : {false, true}) {
      INFO(bits, is_signed);
      std::vector<std::int64_t> values = volume_values();
      // One value in every second row gives runs.
      for (std::size_t i = 0; i < values.size(); ++i) {
        const std::int64_t base = i / width % 2 == 0 ? 100 : values[i] % 100 + 100;
        values[i] =
            (is_signed ? base - 128 : base) * (std::int64_t{1} << (bits - 8)) + (bits > 8 ? 7 : 0);
      }
      Dataset data = frames();
      data.samples(values, bits, is_signed);
      Strings fragments;
      for (auto begin = values.begin(); begin != values.end(); begin += width * height)
        fragments.push_back(rle(segments({begin, begin + width * height}, bits / 8)));
      const auto path =
          write("v.dcm", data.fragments(fragments).file(Order::little_endian, rle_syntax));
      CHECK(read_samples(path) == as_read(values));
    }
}

TEST_CASE_FIXTURE(Folder, "RLE runs of every length are read across rows; 128 is skipped") {
  std::string plane;
  std::string segment = "\x80";
  for (int length = 1; length <= 128; ++length) {
    const std::string literal(static_cast<std::size_t>(length), static_cast<char>(length));
    segment += static_cast<char>(length - 1) + literal + '\x80';
    plane += literal;
    if (length == 1) continue;
    segment += static_cast<char>(257 - length);
    segment += static_cast<char>(-length);
    plane += std::string(static_cast<std::size_t>(length), static_cast<char>(-length));
  }
  std::vector<std::int64_t> values;
  for (const char byte : plane) values.push_back(static_cast<unsigned char>(byte));
  constexpr std::size_t columns = 79;  // divides the number of bytes
  Dataset data = image("1");
  data.samples(values, 8, false)
      .whole(0x00280010, {values.size() / columns})
      .whole(0x00280011, {columns});
  const auto path =
      write("v.dcm", data.fragments({rle({segment})}).file(Order::little_endian, rle_syntax));
  CHECK(read_samples(path) == as_read(values));
}

TEST_CASE_FIXTURE(Folder,
                  "an RLE frame in several fragments is read if offsets separate the frames") {
  Strings fragments;
  std::vector<std::uint64_t> offsets;
  std::uint64_t offset = 0;
  for (const std::string& whole : all_frames()) {
    offsets.push_back(offset);
    for (const std::string& part : {whole.substr(0, 70), whole.substr(70)}) {
      fragments.push_back(part);
      offset += 8 + part.size();
    }
  }
  CHECK(read_samples(write("v.dcm", file(fragments, offsets))) == as_read(volume_values()));
  check_refused(write("v.dcm", file(fragments)),
                "frame 0 (the first is 0): its part of the compressed pixel data is unknown");
  ++offsets[3];
  check_refused(write("v.dcm", file(fragments, offsets)),
                "its part of the compressed pixel data is unknown");
  --offsets[3];
  offsets[2] = offsets[1];
  check_refused(write("v.dcm", file(fragments, offsets)), "the offsets of frames are not in order");
}

TEST_CASE_FIXTURE(Folder, "frames that are missing or empty in RLE are refused") {
  Strings fragments = all_frames();
  fragments[2] = "";
  check_refused(write("v.dcm", file(fragments)), "fragment 3 of the pixel data is empty");
  fragments.resize(2);
  check_refused(write("v.dcm", file(fragments)), "pixel data is unknown");
  check_refused(write("v.dcm", file({})), "pixel data is unknown");
}

TEST_CASE("an RLE header that contradicts the data or the samples is refused with its numbers") {
  const Strings good = segments(slice_values(0), 2);
  const std::uint64_t second = header_bytes + good[0].size();
  const std::uint64_t end = second + good[1].size();
  const std::string of_end = ", is not within the data of " + std::to_string(end) + " bytes";
  check_refusal(refused(std::string(62, '\0')), "RLE data of 62 bytes has no header of 64");
  for (const std::uint64_t count : {1ULL, 3ULL, 4ULL, 15ULL, 16ULL, 0xffffffffULL})
    check_refusal(refused(rle(good, {}, count)),
                  "the RLE header counts " + std::to_string(count) + " segments; expected 2");
  const auto with_offsets = [&](std::uint64_t one, std::uint64_t two) {
    return refused(rle(good, {one, two}));
  };
  check_refusal(with_offsets(end + 256, end + 512), "RLE segment 1, from byte " +
                                                        std::to_string(end + 256) + " to " +
                                                        std::to_string(end + 512) + of_end);
  check_refusal(with_offsets(second, header_bytes), "to 64" + of_end);
  check_refusal(with_offsets(63, second), "RLE segment 1, from byte 63");
  check_refusal(with_offsets(0, second), "RLE segment 1, from byte 0");
  check_refusal(with_offsets(header_bytes, 0xfffffffe), "to 4294967294" + of_end);
  check_refusal(with_offsets(0xfffffffe, 0xfffffffe), "from byte 4294967294");
}

TEST_CASE("an RLE segment that is too short or too long is refused") {
  const std::string good = packed(std::string(width * height, 'x'));
  const auto refused_second = [&](const std::string& segment) {
    return refused(rle({good, segment}));
  };
  check_refusal(refused_second(""), "RLE segment 2 ends after 0 of 48 bytes");
  check_refusal(refused_second(packed(std::string(46, 'x'))), "ends after 46 of 48 bytes");
  check_refusal(refused_second(std::string("\x2f"
                                           "ab",
                                           3)),
                "ends within a run of 48 bytes");
  check_refusal(refused_second("\x80\xd1"), "ends within a run of 48 bytes");
  check_refusal(refused_second(packed(std::string(50, 'x'))), "more than the 48 bytes");
  check_refusal(refused_second(std::string("\x81") + 'x'), "more than the 48 bytes");
  check_refusal(refused_second(good + good), "more than the 48 bytes");
  check_refusal(refused(rle({packed(std::string(50, 'x')), good})), "RLE segment 1 has more");
}

TEST_CASE("RLE truncated at any byte is refused") {
  const std::string whole = frame(0);
  for (std::size_t size = 2; size + 1 < whole.size(); size += 2) {
    INFO(size);
    refused(whole.substr(0, size));
  }
}

}  // namespace
