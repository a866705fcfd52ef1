// Fuzz target. Any bytes are read as any of the formats, or as headerless samples, in one file or
// two, compressed or not. The result is a VolumeError that names the file and the remedy, or a
// volume within the limits of volume.hpp. Every reading has the same result.
//
//   fuzz_volume_readers -max_len=1500 -dict=volume_readers.dict corpus/volume_readers
//   fuzz_volume_readers corpus/volume_readers                      with replay_main.cpp
//
// write_codec_seeds.py wrote the inputs dicom_* and tiff_*, one for each codec, and most of
// hostile_rle_*.
//
// DISCMC_FUZZ_FILES="v.nrrd v.nhdr" skips inputs with files of other names, to test one reader.

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>
#include <string>

#include "input.hpp"
#include "require.hpp"
#include "samples/iso_value.hpp"
#include "volumes/volume.hpp"
#include "volumes/volume_stream.hpp"

using namespace discmc::command;
namespace fs = std::filesystem;

namespace {

using Bytes = std::vector<uint8_t>;

/// A folder for this process, removed at its end.
class Folder {
 public:
  Folder()
      : path_(fs::temp_directory_path() /
              ("discmc-fuzz-" + std::to_string(std::random_device()()))) {
    fs::create_directory(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// A file that is removed before the next input, which may have the same name.
class File {
 public:
  File(const fs::path& path, const Bytes& bytes) : path_(path) {
    fs::create_directories(path.parent_path());
    std::ofstream stream(path_, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()),
                 static_cast<std::streamsize>(bytes.size()));
    require(!stream.fail(), "cannot write into the folder for temporary files");
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }

 private:
  fs::path path_;
};

/// The file to open, and the one beside it that it may need; of Zarr, files in the folder.
struct Names {
  const char* opened;
  const char* other;
  bool is_raw;
  bool is_of_one_piece = false;  ///< with any bytes, including file separators
};
constexpr Names names[] = {
    {"v.nrrd", nullptr, false},
    {"v.nhdr", "data", false},
    {"v.mha", nullptr, false},
    {"v.mhd", "data", false},
    {"v.nii", nullptr, false},
    {"v.nii.gz", nullptr, false},
    {"v.hdr", "v.img", false},
    {"v.img", "v.hdr", false},
    {"v.hdr", "v.img.gz", false},
    {"v", nullptr, false},
    {"v.raw", nullptr, true},
    {"v.raw.gz", nullptr, true},
    {"v.dcm", nullptr, false, true},
    {"v.png", nullptr, false, true},
    {"v.tif", nullptr, false, true},
    {"v.vtk", nullptr, false},
    {"v.vti", nullptr, false},
    {"v.npy", nullptr, false},
    {"v.inv3", nullptr, false},
    {"v.zip", nullptr, false, true},
    {"v.jpg", nullptr, false, true},
    {"v.bmp", nullptr, false, true},
    {"v.mgh", nullptr, false},
    {"v.mrc", nullptr, false},
    {"v.npz", nullptr, false, true},
    {"v.zarr/.zarray", "v.zarr/0.0.0", false},
    {"v.zarr3/zarr.json", "v.zarr3/c/0/0/0", false},
    {"v.ome.zarr/zarr.json", "v.ome.zarr/0/zarr.json", false},
};

/// Whether the environment selects only other names.
bool is_left_out(const Names& name) {
  static const char* const asked = std::getenv("DISCMC_FUZZ_FILES");
  if (asked == nullptr) return false;
  return (' ' + std::string(asked) + ' ').find(std::string(" ") + name.opened + ' ') ==
         std::string::npos;
}

enum class Wrapping : uint8_t { none, gzip, zlib };

Bytes packed(const Bytes& bytes, Wrapping wrapping) {
  if (wrapping == Wrapping::none) return bytes;
  z_stream state{};
  const int window = wrapping == Wrapping::gzip ? 31 : 15;
  require(deflateInit2(&state, 1, Z_DEFLATED, window, 8, Z_DEFAULT_STRATEGY) == Z_OK, "no zlib");
  Bytes in = bytes;
  Bytes out(deflateBound(&state, in.size()));
  state.next_in = in.data();
  state.avail_in = static_cast<uInt>(in.size());
  state.next_out = out.data();
  state.avail_out = static_cast<uInt>(out.size());
  require(deflate(&state, Z_FINISH) == Z_STREAM_END, "zlib does not end");
  out.resize(state.total_out);
  deflateEnd(&state);
  return out;
}

Bytes joined(Bytes head, const Bytes& tail) {
  head.insert(head.end(), tail.begin(), tail.end());
  return head;
}

/// The result of one opening, for comparison with another.
struct Reading {
  VolumeInfo info;
  Bytes samples;
  std::string error;  ///< empty if everything was read

  bool operator==(const Reading& other) const {
    return info.dims == other.info.dims && info.frames == other.info.frames &&
           info.type == other.info.type && info.spacing_mm == other.info.spacing_mm &&
           info.placement == other.info.placement && info.slope == other.info.slope &&
           info.intercept == other.info.intercept && info.format == other.info.format &&
           info.notes == other.info.notes && samples == other.samples && error == other.error;
  }
};

void check_info(const VolumeInfo& info, size_t file_bytes) {
  require(info.dims[0] >= 1 && info.dims[0] <= 32766, "a width out of its limits");
  require(info.dims[1] >= 1 && info.dims[1] <= 32766, "a height out of its limits");
  require(info.dims[2] >= 1 && info.dims[2] < 1U << 30, "a depth out of its limits");
  for (const double spacing : info.spacing_mm)
    require(std::fabs(spacing) >= 1e-6 && std::fabs(spacing) <= 1e6, "a spacing of no use");
  if (info.placement) require(is_usable(*info.placement), "a placement of no use");
  require(info.slope > 0 && std::isfinite(info.slope), "a slope of no use");
  require(std::isfinite(info.intercept), "an intercept of no use");
  require(!info.format.empty(), "a format without a name");
  // A sample of eight bytes may be two characters of text. Only gzip has such a bound. Other
  // packings and zips of pictures have none, and a list may repeat a file in each line. Files of
  // these are read before their size is known. Zarr has its own bound.
  constexpr size_t max_inflation = 16384;
  const char* const unbounded[] = {"bzip2",    "xz",    "zstd", "lz4",
                                   "detached", ", zip", "npz",  "Zarr"};
  const bool is_bounded = std::none_of(
      std::begin(unbounded), std::end(unbounded),
      [&info](const char* word) { return info.format.find(word) != std::string::npos; });
  require(!is_bounded || info.slice_bytes() <= max_inflation * file_bytes,
          "a slice that no file can hold");
}

// "file: what; remedy"; the file may be one that a header names, anywhere.
void check_error(const std::string& text) {
  const size_t colon = text.find(": ");
  require(colon != std::string::npos && colon > 0, "an error that does not name the file");
  require(text.find("; ", colon) != std::string::npos, "an error without a remedy");
}

Reading read(const fs::path& file, const VolumeOptions& options, size_t file_bytes) {
  constexpr uint32_t max_slices = 20;
  Reading reading;
  try {
    const std::unique_ptr<VolumeReader> reader = open_volume(file, options);
    reading.info = reader->info();
    check_info(reading.info, file_bytes);
    const uint32_t slices = std::min(reading.info.dims[2], max_slices);
    Bytes slice(reading.info.slice_bytes());
    for (uint32_t i = 0; i < slices; ++i) {
      reader->read_slice(slice.data());
      if (slice.size() < 4096)
        reading.samples.insert(reading.samples.end(), slice.begin(), slice.end());
    }
    reading.info.notes = reader->notes();
    if (slices < reading.info.dims[2]) return reading;
    bool is_refused = false;
    try {
      reader->read_slice(slice.data());
    } catch (const VolumeError&) {
      is_refused = true;
    }
    require(is_refused, "a slice after the last one");
  } catch (const VolumeError& error) {
    reading.error = error.what();
    check_error(reading.error);
  }
  return reading;
}

/// stored >= threshold exactly if value >= iso, except for the rounding of decimal numbers.
void check_threshold(const VolumeInfo& info, double iso) {
  const int32_t threshold = stored_threshold(info, iso);
  const auto value = [&](double stored) { return info.slope * stored + info.intercept; };
  const double rounding = 1e-12 * (std::fabs(iso) + std::fabs(info.intercept));
  if (threshold != INT32_MAX)
    require(value(threshold) >= iso - rounding, "a threshold below the iso value");
  if (threshold != INT32_MIN)
    require(value(threshold - 1.0) < iso + rounding, "a threshold above the iso value");
}

VolumeOptions read_options(Input& input) {
  VolumeOptions options;
  RawLayout& layout = options.layout.emplace();
  for (uint32_t& size : layout.dims) size = input.byte();
  const uint32_t flags = input.byte();
  layout.type = sample_types[(flags >> 4) % std::size(sample_types)].second;
  layout.is_big_endian = (flags & 4) != 0;
  if ((flags & 8) != 0)
    options.spacing_mm = {1, std::ldexp(-1, static_cast<int>(input.byte()) - 128), 1};
  return options;
}

/// Headerless samples equal the file's bytes, in the machine's byte order.
void check_raw(const Reading& reading, const RawLayout& layout, const Bytes& file) {
  const size_t bytes = sample_bytes(layout.type);
  const bool is_turned = layout.is_big_endian != is_native_big_endian();
  for (size_t i = 0; i < reading.samples.size(); ++i) {
    const size_t in_sample = i % bytes;
    const size_t of_file = i - in_sample + (is_turned ? bytes - 1 - in_sample : in_sample);
    require(reading.samples[i] == file[of_file], "not the sample of the file");
  }
}

}  // namespace

// The first byte names the files, the second the packing, the frame, whether values are labels, and
// the channel; raw samples have a layout.
// What follows is the first file, and behind a file separator (ASCII 28) its packed rest, or the
// other file.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static const Folder folder;
  Input input(data, size);
  const Names& name = names[input.below(std::size(names))];
  if (is_left_out(name)) return 0;
  const uint32_t choice = input.byte();
  const auto wrapping = static_cast<Wrapping>(choice % 3);
  VolumeOptions options;
  if (name.is_raw) options = read_options(input);
  if (choice / 3 % 4 > 0) options.frame = choice / 3 % 4 - 1;
  options.holds_labels = choice / 12 % 2 == 1;
  if (choice / 24 % 4 > 0) options.channel = choice / 24 % 4 - 1;
  const double iso = (input.byte() - 128.0) / 4;

  const Bytes all = input.bytes(size);
  constexpr uint8_t file_separator = 28;
  const bool is_of_one_piece = name.is_raw || name.is_of_one_piece;
  auto separator = is_of_one_piece ? all.end() : std::find(all.begin(), all.end(), file_separator);
  Bytes head(all.begin(), separator);
  Bytes tail(separator == all.end() ? separator : separator + 1, all.end());
  if (separator == all.end() && name.other == nullptr) std::swap(head, tail);
  tail = packed(tail, wrapping);
  if (name.other == nullptr) head = joined(head, tail);
  // If the data of a pair are opened, their header still comes first.
  const bool asks_for_data = name.other != nullptr && std::strcmp(name.other, "v.hdr") == 0;
  if (asks_for_data) std::swap(head, tail);

  const fs::path opened = folder.path() / name.opened;
  const File first(opened, head);
  std::optional<File> second;
  if (name.other != nullptr) second.emplace(folder.path() / name.other, tail);

  // HDF5 is left out: its library makes no such promise (SECURITY.md).
  if (head.size() >= 4 && std::memcmp(head.data(), "\x89HDF", 4) == 0) return 0;

  const size_t file_bytes = std::max(head.size(), tail.size());
  const Reading reading = read(opened, options, file_bytes);
  require(read(opened, options, file_bytes) == reading, "another reading of the same file");
  if (!reading.info.format.empty()) check_threshold(reading.info, iso);
  if (name.is_raw && reading.info.format == "raw" && !options.holds_labels)
    check_raw(reading, *options.layout, head);
  return 0;
}
