// Small volumes as files of every format, and functions to read and refuse them, for tests of the
// readers.
#pragma once

#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <system_error>

#include "test.hpp"
#include "volumes/volume.hpp"

namespace volume_files {

namespace fs = std::filesystem;
using discmc::Space;
using discmc::command::open_volume;
using discmc::command::RawLayout;
using discmc::command::VolumeError;
using discmc::command::VolumeInfo;
using discmc::command::VolumeOptions;
using discmc::command::VolumeReader;
using discmc::meshing::Axes;
using discmc::meshing::SampleGrid;
using discmc::meshing::SampleType;
using discmc::meshing::SliceReader;
using Dims = std::array<std::uint32_t, 3>;
using Vector = std::array<double, 3>;
using Spacing = Vector;

/// Options with another value for one member.
template <class Member, class Value>
VolumeOptions with(Member VolumeOptions::*member, const Value& value, VolumeOptions options = {}) {
  options.*member = value;
  return options;
}

inline VolumeOptions of_frame(std::optional<std::uint32_t> frame) {
  return with(&VolumeOptions::frame, frame);
}
inline VolumeOptions of_channel(std::optional<std::uint32_t> channel) {
  return with(&VolumeOptions::channel, channel);
}
inline VolumeOptions with_axes(const std::string& axes, const VolumeOptions& options = {}) {
  return with(&VolumeOptions::axes, axes, options);
}
inline const VolumeOptions gaps_allowed = with(&VolumeOptions::allow_gaps, true);

inline std::string replaced_all(std::string text, const std::string& old, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += by.size())
    text.replace(at, old.size(), by);
  return text;
}

/// A test's own folder, removed at its end.
class Folder {
 public:
  Folder()
      : path_(fs::temp_directory_path() / ("discmc-" + std::to_string(std::random_device()()))) {
    fs::create_directory(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  /// Also makes the folders of the path.
  fs::path write(const fs::path& name, const std::string& bytes) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return path_ / name;
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

inline std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

enum class Wrapper { zlib = 15, gzip = 31 };

inline std::string deflated(const std::string& bytes, Wrapper wrapper) {
  z_stream state{};
  deflateInit2(&state, 6, Z_DEFLATED, static_cast<int>(wrapper), 8, Z_DEFAULT_STRATEGY);
  std::vector<unsigned char> in(bytes.begin(), bytes.end());
  std::vector<unsigned char> out(deflateBound(&state, in.size()));
  state.next_in = in.data();
  state.avail_in = static_cast<uInt>(in.size());
  state.next_out = out.data();
  state.avail_out = static_cast<uInt>(out.size());
  REQUIRE(deflate(&state, Z_FINISH) == Z_STREAM_END);
  out.resize(state.total_out);
  deflateEnd(&state);
  return std::string(out.begin(), out.end());
}

inline std::string gzip(const std::string& bytes) {
  return deflated(bytes, Wrapper::gzip);
}

// The test volume: 5 by 3 by 4 samples, some of them negative if the type allows it.
constexpr int voxels = 5 * 3 * 4;

inline double sample_at(int voxel, SampleType type) {
  switch (type) {
    case SampleType::u8:
      return voxel * 4;
    case SampleType::i8:
      return voxel * 2 - 60;
    case SampleType::u16:
      return voxel * 1000 + 7;
    case SampleType::i16:
      return voxel * 1000 - 30000;
    case SampleType::u32:
      return voxel * 7e7 + 1;
    case SampleType::i32:
      return voxel * 7e7 - 2e9;
    case SampleType::u64:
      return voxel * 3e17;
    case SampleType::i64:
      return voxel * 3e17 - 9e18;
    case SampleType::f32:
      return voxel * 0.25 - 7.5;
    case SampleType::f64:
      break;
  }
  return voxel * 0.1 - 3;
}

// Slices of 8 by 6 samples of the volume of write_dicom.py and write_pictures.py.
inline std::vector<double> patterned(int first, int count) {
  std::vector<double> samples;
  for (int z = first; z < first + count; ++z)
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 8; ++x)
        samples.push_back((x * 7919 + y * 1047 + z * 12997) % 4001 - 2000);
  return samples;
}

// A number, or a sample, as bytes of a file.
template <class Number>
std::string bytes_of(Number number, bool is_big_endian = false) {
  char bytes[sizeof number];
  std::memcpy(bytes, &number, sizeof number);
  if (is_big_endian) std::reverse(bytes, bytes + sizeof number);
  return {bytes, sizeof number};
}
template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  std::string bytes;
  for (const Number number : numbers) bytes += bytes_of(number);
  return bytes;
}

inline std::string stored(SampleType type, bool is_big_endian = false) {
  std::string bytes;
  for (int voxel = 0; voxel < voxels; ++voxel)
    discmc::meshing::with_sample_type(type, [&](auto typed) {
      bytes += bytes_of(static_cast<decltype(typed)>(sample_at(voxel, type)), is_big_endian);
    });
  return bytes;
}

inline const std::string u8 = stored(SampleType::u8);

inline std::string nrrd(const std::string& lines, const std::string& sizes = "5 3 4") {
  return "NRRD0004\n# a comment\nkey:=value\ndimension: " +
         std::to_string(std::count(sizes.begin(), sizes.end(), ' ') + 1) + "\nsizes: " + sizes +
         "\n" + lines;
}

// Samples as text, with a distance of this many millimetres.
inline std::string text_nrrd(const std::string& type, const std::string& sizes,
                             const std::string& samples, const std::string& spacing = "1") {
  const std::string spacings = "spacings: " + spacing + " " + spacing + " " + spacing + "\n";
  return nrrd("type: " + type + "\nencoding: ascii\n" + spacings +
                  "units: \"mm\" \"mm\" \"mm\"\nspace units: \"mm\" \"mm\" \"mm\"\n",
              sizes) +
         "\n" + samples;
}

inline std::string metaimage(const std::string& lines, const std::string& sizes = "5 3 4") {
  return "ObjectType = Image\nNDims = " +
         std::to_string(std::count(sizes.begin(), sizes.end(), ' ') + 1) + "\nDimSize = " + sizes +
         "\n" + lines;
}

// A NumPy array of type descr; the shape is in Python's notation without parentheses.
inline std::string npy(const std::string& descr, const std::string& shape,
                       const std::string& samples, bool is_fortran = false) {
  std::string header = "{'descr': '" + descr +
                       "', 'fortran_order': " + (is_fortran ? "True" : "False") + ", 'shape': (" +
                       shape + "), }\n";
  const auto length = static_cast<unsigned char>(header.size());
  return std::string("\x93NUMPY\1\0", 8) + static_cast<char>(length) + '\0' + header + samples;
}

inline const std::string nrrd_u8 = "type: uchar\nencoding: raw\n";
inline const std::string units_in_mm =
    "units: \"mm\" \"mm\" \"mm\"\nspace units: \"mm\" \"mm\" \"mm\"\n";
inline const std::string metaimage_u8 = "ElementType = MET_UCHAR\n";

// A NIfTI-1 header, field by field at the offsets of the standard.
class Nifti {
 public:
  explicit Nifti(bool is_big_endian = false) : is_big_endian_(is_big_endian) {
    integer(0, 4, 348);
    dims({3, 5, 3, 4});
    type(2);
    for (std::size_t i = 0; i < 4; ++i) real(76 + 4 * i, 1);
    real(108, 352);
    integer(123, 1, 2);  // mm
    bytes_.replace(344, 3, "n+1");
  }
  Nifti& dims(const std::vector<int>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) integer(40 + 2 * i, 2, values[i]);
    return *this;
  }
  Nifti& type(int datatype) { return integer(70, 2, datatype); }
  Nifti& scale(float slope, float intercept) { return real(112, slope).real(116, intercept); }
  // Also declares the rows srow_x, srow_y and srow_z valid.
  Nifti& sform(const std::vector<float>& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) real(280 + 4 * i, rows[i]);
    return integer(254, 2, 1);
  }
  Nifti& pair() {
    bytes_.replace(344, 3, "ni1");
    return real(108, 0);
  }
  Nifti& integer(std::size_t offset, int size, int value) {
    for (int i = 0; i < size; ++i)
      bytes_[offset + static_cast<std::size_t>(is_big_endian_ ? size - 1 - i : i)] =
          static_cast<char>(value >> (8 * i) & 0xff);
    return *this;
  }
  Nifti& real(std::size_t offset, float value) {
    int bits = 0;
    std::memcpy(&bits, &value, 4);
    return integer(offset, 4, bits);
  }
  std::string header() const { return bytes_.substr(0, 348); }
  std::string file(const std::string& data) const { return bytes_ + data; }

 private:
  bool is_big_endian_;
  std::string bytes_ = std::string(352, '\0');
};

inline std::vector<double> read_all(SliceReader& reader) {
  const SampleGrid info = reader.info();
  std::vector<double> samples;
  std::vector<unsigned char> slice(info.slice_bytes());
  for (std::uint32_t k = 0; k < info.dims[2]; ++k) {
    reader.read_slice(slice.data());
    discmc::meshing::with_sample_type(info.type, [&](auto sample) {
      for (std::size_t at = 0; at < slice.size(); at += sizeof sample) {
        std::memcpy(&sample, &slice[at], sizeof sample);
        samples.push_back(static_cast<double>(sample));
      }
    });
  }
  return samples;
}

inline std::vector<double> read_samples(const fs::path& file, const VolumeOptions& options = {}) {
  return read_all(*open_volume(file, options));
}

inline VolumeInfo read_info(const fs::path& file, const VolumeOptions& options = {}) {
  return open_volume(file, options)->info();
}

// The samples of the test volume.
inline std::vector<double> samples_as(SampleType type) {
  std::vector<double> samples;
  for (int voxel = 0; voxel < voxels; ++voxel) samples.push_back(sample_at(voxel, type));
  return samples;
}

inline void check_volume(const fs::path& file, SampleType type, const std::string& format,
                         const VolumeOptions& options = {}) {
  INFO(file.filename().string(), " as ", format);
  const auto reader = open_volume(file, options);
  CHECK(reader->info().dims == Dims{5, 3, 4});
  CHECK(reader->info().type == type);
  CHECK(reader->info().format == format);
  CHECK(read_all(*reader) == samples_as(type));
}

// Checks the volume of u8.
inline void check_volume(const fs::path& file, const std::string& format,
                         const VolumeOptions& options = {}) {
  check_volume(file, SampleType::u8, format, options);
}

// The message of a volume that cannot be read to its end, with a remedy; else empty.
inline std::string error_of(const fs::path& file, const VolumeOptions& options = {}) {
  try {
    read_samples(file, options);
  } catch (const VolumeError& error) {
    CHECK(contains(error.what(), "; "));
    return error.what();
  }
  return {};
}

// Opens and reads a volume that should be refused by its name. Returns the message.
inline std::string refusal(const fs::path& file, const VolumeOptions& options = {}) {
  const std::string text = error_of(file, options);
  if (text.empty()) FAIL("not refused: ", file.string());
  CHECK(contains(text, file.stem().string()));
  return text;
}

template <class... Parts>
void check_refusal(const std::string& text, const Parts&... parts) {
  INFO(text);
  for (const std::string& part : {std::string(parts)...}) CHECK(contains(text, part));
}

// Checks that a volume is refused with a message that contains all parts.
template <class... Parts>
void check_refused(const fs::path& file, const VolumeOptions& options, const Parts&... parts) {
  check_refusal(refusal(file, options), parts...);
}
template <class... Parts>
void check_refused(const fs::path& file, const std::string& part, const Parts&... parts) {
  check_refusal(refusal(file), part, parts...);
}

inline void check_origin(const VolumeInfo& info, const Vector& origin) {
  REQUIRE(info.placement);
  CHECK(info.placement->origin_mm == origin);
}

inline void check_grid(const VolumeInfo& info, const Spacing& spacing, const Vector& origin) {
  CHECK(info.spacing_mm == spacing);
  check_origin(info, origin);
}

inline void check_axes(const VolumeInfo& info, const Axes& axes, const Vector& origin) {
  check_origin(info, origin);
  CHECK(info.placement->axes_mm == axes);
}

inline bool noted(const VolumeInfo& info, const std::string& part) {
  return std::any_of(info.notes.begin(), info.notes.end(),
                     [&](const std::string& note) { return contains(note, part); });
}

}  // namespace volume_files
