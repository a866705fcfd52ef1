// https://nifti.nimh.nih.gov/pub/dist/src/niftilib/nifti1.h and .../nifti2/nifti2.h. Analyze 7.5
// has the fields that NIfTI-1 adopted, but no orientation and no magic number.
#include "header.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "volumes/format_list.hpp"
#include "volumes/header_bytes.hpp"

namespace discmc::command {
namespace {

constexpr std::int32_t bytes_of_1 = 348;
constexpr std::int32_t bytes_of_2 = static_cast<std::int32_t>(nifti2::bytes);

// Reads `count` successive numbers of the file.
template <class Number, class Numbers>
void read_numbers(const HeaderBytes& bytes, std::size_t offset, Numbers& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = static_cast<typename Numbers::value_type>(
        bytes.number<Number>(offset + i * sizeof(Number)));
}

NiftiUnit unit_of(int field) {
  return static_cast<NiftiUnit>(field & 7);
}

NiftiHeader header_of_2(const std::filesystem::path& file, const HeaderBytes& bytes) {
  NiftiHeader header;
  header.format = "NIfTI-2";
  const std::string_view magic = bytes.text(nifti2::magic, 4);
  header.is_one_file = magic == std::string_view("n+2\0", 4);
  if (!header.is_one_file && magic != std::string_view("ni2\0", 4))
    fail(file, "the magic of NIfTI-2 is " + shown(magic), "copy the file again");
  header.datatype = bytes.number<std::int16_t>(nifti2::datatype);
  read_numbers<std::int64_t>(bytes, nifti2::dim, header.dim);
  read_numbers<double>(bytes, nifti2::pixdim, header.pixdim);
  header.vox_offset = bytes.number<std::int64_t>(nifti2::vox_offset);
  header.scl_slope = bytes.number<double>(nifti2::slope);
  header.scl_inter = bytes.number<double>(nifti2::intercept);
  header.qform_code = bytes.number<std::int32_t>(nifti2::qform_code);
  header.sform_code = bytes.number<std::int32_t>(nifti2::sform_code);
  read_numbers<double>(bytes, nifti2::quaternion, header.quatern);
  read_numbers<double>(bytes, nifti2::qoffset, header.qoffset);
  for (std::size_t row = 0; row < 3; ++row)
    read_numbers<double>(bytes, nifti2::srow + 32 * row, header.srow[row]);
  header.unit = unit_of(bytes.number<std::int32_t>(nifti2::units));
  return header;
}

std::int64_t whole_offset(const std::filesystem::path& file, float vox_offset) {
  constexpr float max_number = 0x1p30F;
  if (!(vox_offset >= 0 && vox_offset <= max_number) || std::floor(vox_offset) != vox_offset)
    fail(file, "vox_offset is " + std::to_string(vox_offset), "correct the header");
  return static_cast<std::int64_t>(vox_offset);
}

NiftiHeader header_of_1(const std::filesystem::path& file, const HeaderBytes& bytes) {
  NiftiHeader header;
  header.datatype = bytes.number<std::int16_t>(70);
  read_numbers<std::int16_t>(bytes, 40, header.dim);
  read_numbers<float>(bytes, 76, header.pixdim);
  header.vox_offset = whole_offset(file, bytes.number<float>(108));
  header.scl_slope = decimal(bytes.number<float>(112));
  const std::string_view magic = bytes.text(344, 4);
  header.is_one_file = magic == std::string_view("n+1\0", 4);
  if (!header.is_one_file && magic != std::string_view("ni1\0", 4)) {
    // NIfTI redefined the other fields of Analyze. Only SPM writes a slope.
    header.format = "Analyze 7.5";
    header.unit = NiftiUnit::millimetre;
    if (!std::isfinite(header.scl_slope) || header.scl_slope < 0) header.scl_slope = 0;
    read_numbers<std::int16_t>(bytes, 253, header.originator);
    return header;
  }
  header.format = "NIfTI-1";
  header.scl_inter = decimal(bytes.number<float>(116));
  header.unit = unit_of(bytes.number<std::uint8_t>(123));
  header.qform_code = bytes.number<std::int16_t>(252);
  header.sform_code = bytes.number<std::int16_t>(254);
  read_numbers<float>(bytes, 256, header.quatern);
  read_numbers<float>(bytes, 268, header.qoffset);
  for (std::size_t row = 0; row < 3; ++row)
    read_numbers<float>(bytes, 280 + 16 * row, header.srow[row]);
  return header;
}

// Indexed by sample type.
constexpr std::int16_t datatypes[] = {2, 256, 512, 4, 768, 8, 1280, 1024, 16, 64};

}  // namespace

NiftiHeader read_nifti_header(ByteStream& stream) {
  std::array<char, 4> start{};
  const std::string_view peeked = stream.peek(start.size());
  std::copy(peeked.begin(), peeked.end(), start.begin());
  const auto size_as = [&start](bool is_big_endian) {
    return static_cast<std::int32_t>(whole_of(start.data(), start.size(), is_big_endian));
  };
  for (const bool is_big_endian : {false, true}) {
    const std::int32_t size = size_as(is_big_endian);
    if (size != bytes_of_1 && size != bytes_of_2) continue;
    const HeaderBytes bytes(stream, static_cast<std::size_t>(size), is_big_endian);
    NiftiHeader header =
        size == bytes_of_2 ? header_of_2(stream.file(), bytes) : header_of_1(stream.file(), bytes);
    header.is_big_endian = is_big_endian;
    return header;
  }
  const VolumeFormat* const other = format_of_head(stream.peek(magic_bytes));
  if (other != nullptr && !is_read(*other))
    fail(stream.file(), "this is " + std::string(other->name) + ", which is not supported",
         std::string(other->remedy));
  fail(stream.file(),
       "the header has size " + std::to_string(size_as(is_native_big_endian())) +
           ", which is not a size of NIfTI",
       "check that it is a NIfTI or Analyze file");
}

std::array<std::array<double, 4>, 3> qform_of(const NiftiHeader& header) {
  auto [b, c, d] = header.quatern;
  const double square = 1 - (b * b + c * c + d * d);
  const double a = square < 1e-7 ? 0 : std::sqrt(square);
  if (a == 0) {  // half a turn, whose axis is too long by rounding
    const double length = std::sqrt(b * b + c * c + d * d);
    b /= length, c /= length, d /= length;
  }
  std::array<std::array<double, 4>, 3> rows{{
      {a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c), 0},
      {2 * (b * c + a * d), a * a + c * c - b * b - d * d, 2 * (c * d - a * b), 0},
      {2 * (b * d - a * c), 2 * (c * d + a * b), a * a + d * d - b * b - c * c, 0},
  }};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double length = std::fabs(header.pixdim[axis + 1]);
      rows[row][axis] *= length > 0 ? length : 1;
    }
    if (header.pixdim[0] < 0) rows[row][2] = -rows[row][2];
    rows[row][3] = header.qoffset[row];
  }
  return rows;
}

std::optional<SampleType> type_of_nifti(int datatype) {
  for (const auto& [called, type] : sample_types)
    if (nifti_type_of(type) == datatype) return type;
  return std::nullopt;
}

std::int16_t nifti_type_of(SampleType type) {
  return datatypes[static_cast<std::size_t>(type)];
}

}  // namespace discmc::command
