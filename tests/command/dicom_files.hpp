// Writes DICOM files of a few elements byte by byte, as the standard defines them (PS3.5 and
// PS3.10).
#pragma once

#include <cstdio>

#include "volume_files.hpp"

namespace dicom_files {

enum class Order { little_endian, big_endian };

inline std::string number_bytes(std::uint64_t value, std::size_t size, Order order) {
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(value >> 8 * i & 0xff);
  if (order == Order::big_endian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// Elements by their tags. 0x00280010 is (0028,0010).
class Dataset {
 public:
  Dataset& text(std::uint32_t tag, const std::string& vr, std::string value) {
    if (value.size() % 2 == 1) value += vr == "UI" ? '\0' : ' ';
    elements_[tag] = {vr, {}, 1, value, {}};
    return *this;
  }
  Dataset& bytes(std::uint32_t tag, const std::string& vr, std::string value) {
    if (value.size() % 2 == 1) value += '\0';
    elements_[tag] = {vr, {}, 1, value, {}};
    return *this;
  }
  Dataset& whole(std::uint32_t tag, const std::vector<std::uint64_t>& values) {
    elements_[tag] = {"US", values, 2, {}, {}};
    return *this;
  }
  /// The tags of other elements.
  Dataset& tags(std::uint32_t tag, std::uint32_t value) {
    elements_[tag] = {"AT", {value >> 16, value & 0xffff}, 2, {}, {}};
    return *this;
  }
  Dataset& real(std::uint32_t tag, const std::vector<double>& values) {
    std::vector<std::uint64_t> bits(values.size());
    std::memcpy(bits.data(), values.data(), 8 * values.size());
    elements_[tag] = {"FD", bits, 8, {}, {}};
    return *this;
  }
  Dataset& sequence(std::uint32_t tag, const std::vector<Dataset>& items) {
    elements_[tag] = {"SQ", {}, 1, {}, items};
    return *this;
  }
  /// Samples of `bits` bits, 8 or more. Also sets the extents and the other attributes of the
  /// format. Words of 16 bits, unless vr is another one.
  Dataset& samples(const std::vector<std::int64_t>& values, std::size_t bits, bool is_signed,
                   const std::string& vr = "") {
    describe_samples(bits, is_signed);
    std::vector<std::uint64_t> raw(values.begin(), values.end());
    elements_[0x7fe00010] = {vr.empty() ? bits == 8 ? "OB" : "OW" : vr, raw, bits / 8, {}, {}};
    return *this;
  }
  /// Floating-point samples.
  Dataset& floats(const std::vector<double>& values, std::size_t bits) {
    describe_samples(bits, false);
    drop(0x00280101).drop(0x00280102).drop(0x00280103).drop(0x7fe00010);
    std::vector<std::uint64_t> raw;
    for (const double value : values) {
      std::uint64_t pattern = 0;
      const auto narrow = static_cast<float>(value);
      if (bits == 32)
        std::memcpy(&pattern, &narrow, sizeof narrow);
      else
        std::memcpy(&pattern, &value, sizeof value);
      raw.push_back(pattern);
    }
    elements_[bits == 32 ? 0x7fe00008 : 0x7fe00009] = {
        bits == 32 ? "OF" : "OD", raw, bits / 8, {}, {}};
    return *this;
  }
  /// Samples of one bit, eight per byte.
  Dataset& bits(const std::vector<std::uint8_t>& values) {
    describe_samples(1, false);
    std::string packed((values.size() + 7) / 8, '\0');
    for (std::size_t i = 0; i < values.size(); ++i)
      packed[i / 8] = static_cast<char>(packed[i / 8] | values[i] << i % 8);
    return bytes(0x7fe00010, "OB", packed);
  }
  /// Compressed samples. offsets: of the frames; may be empty.
  Dataset& fragments(const std::vector<std::string>& all,
                     const std::vector<std::uint64_t>& offsets = {}) {
    std::string table;
    for (const std::uint64_t offset : offsets)
      table += number_bytes(offset, 4, Order::little_endian);
    std::string value = item(0xfffee000, table);
    for (const std::string& fragment : all) value += item(0xfffee000, fragment);
    elements_[0x7fe00010] = {"OB", {}, 1, value + item(0xfffee0dd, {}), {}, true};
    return *this;
  }
  Dataset& drop(std::uint32_t tag) {
    elements_.erase(tag);
    return *this;
  }

  std::string encoded(Order order = Order::little_endian) const {
    std::string result;
    for (const auto& [tag, element] : elements_) {
      std::string value = element.value;
      for (const std::uint64_t number : element.numbers)
        value += number_bytes(number, element.size, order);
      for (const Dataset& item : element.items) {
        const std::string bytes = item.encoded(order);
        value += tag_bytes(0xfffee000, order) + number_bytes(bytes.size(), 4, order) + bytes;
      }
      if (value.size() % 2 == 1) value += '\0';
      const bool is_long = element.vr[0] == 'O' || element.vr == "SQ" || element.vr == "UN";
      constexpr std::uint32_t undefined = 0xffffffff;
      result +=
          tag_bytes(tag, order) + element.vr + std::string(is_long ? 2 : 0, '\0') +
          number_bytes(element.is_of_fragments ? undefined : value.size(), is_long ? 4 : 2, order) +
          value;
    }
    return result;
  }

  /// The bytes of a file. syntax: the UID in its header, or empty for that of the byte order.
  std::string file(Order order = Order::little_endian, const std::string& syntax = "") const {
    Dataset meta;
    const auto storage = elements_.find(0x00080016);
    meta.bytes(0x00020002, "UI",
               storage == elements_.end() ? "1.2.840.10008.5.1.4.1.1.2" : storage->second.value);
    const std::string of_order =
        order == Order::big_endian ? "1.2.840.10008.1.2.2" : "1.2.840.10008.1.2.1";
    meta.bytes(0x00020010, "UI", syntax.empty() ? of_order : syntax);
    const std::string group = meta.encoded();
    return std::string(128, '\0') + "DICM" + tag_bytes(0x00020000, Order::little_endian) + "UL" +
           number_bytes(4, 2, Order::little_endian) +
           number_bytes(group.size(), 4, Order::little_endian) + group + encoded(order);
  }

 private:
  struct Element {
    std::string vr;
    std::vector<std::uint64_t> numbers;
    std::size_t size;  ///< bytes per number
    std::string value;
    std::vector<Dataset> items;
    bool is_of_fragments = false;
  };

  static std::string tag_bytes(std::uint32_t tag, Order order) {
    return number_bytes(tag >> 16, 2, order) + number_bytes(tag & 0xffff, 2, order);
  }

  static std::string item(std::uint32_t tag, const std::string& value) {
    return tag_bytes(tag, Order::little_endian) +
           number_bytes(value.size(), 4, Order::little_endian) + value;
  }

  void describe_samples(std::size_t bits, bool is_signed) {
    whole(0x00280002, {1}).text(0x00280004, "CS", "MONOCHROME2");
    whole(0x00280100, {bits}).whole(0x00280101, {bits}).whole(0x00280102, {bits - 1});
    whole(0x00280103, {is_signed ? 1U : 0U});
  }

  std::map<std::uint32_t, Element> elements_;
};

// ---- the volume of all files ----

constexpr int width = 8;
constexpr int height = 6;
constexpr int depth = 5;

inline std::int64_t value_at(int x, int y, int z) {
  return (x * 7919 + y * 1047 + z * 12997) % 4001 - 2000;
}

inline std::vector<std::int64_t> slice_values(int z) {
  std::vector<std::int64_t> values;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) values.push_back(value_at(x, y, z));
  return values;
}

inline std::vector<std::int64_t> volume_values() {
  std::vector<std::int64_t> values;
  for (int z = 0; z < depth; ++z)
    for (const std::int64_t value : slice_values(z)) values.push_back(value);
  return values;
}

/// From the last slice to the first.
inline std::vector<std::int64_t> reversed_values() {
  std::vector<std::int64_t> values;
  for (int z = depth; z-- > 0;)
    for (const std::int64_t value : slice_values(z)) values.push_back(value);
  return values;
}

template <class Number, class Change>
std::vector<Number> changed(std::vector<Number> values, Change change) {
  for (Number& value : values) value = change(value);
  return values;
}

inline std::vector<double> as_read(const std::vector<std::int64_t>& values) {
  return std::vector<double>(values.begin(), values.end());
}

inline std::string decimals(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.10g", number);
    text += (text.empty() ? "" : "\\") + std::string(digits);
  }
  return text;
}

/// The image of one or more slices: 0.5 x 0.75 mm, 2.5 mm apart, at (-10, -20, 100), along the
/// axes.
inline Dataset image(const std::string& instance, const std::string& modality = "CT") {
  Dataset data;
  data.text(0x00080008, "CS", "ORIGINAL\\PRIMARY\\AXIAL");
  data.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.2");
  data.text(0x00080018, "UI", "1.2.3." + instance).text(0x00080060, "CS", modality);
  data.text(0x0020000e, "UI", "1.2.3").text(0x00200011, "IS", "4");
  data.text(0x00280030, "DS", "0.75\\0.5");
  data.whole(0x00280010, {height}).whole(0x00280011, {width});
  return data;
}

inline Dataset& put_at(Dataset& data, const std::vector<double>& position,
                       const std::vector<double>& orientation = {1, 0, 0, 0, 1, 0}) {
  return data.text(0x00200032, "DS", decimals(position))
      .text(0x00200037, "DS", decimals(orientation));
}

inline std::vector<double> position(int z) {
  return {-10, -20, 100 + 2.5 * z};
}

/// Slice z of the volume. instance: the last component of its UID.
inline Dataset slice(int z, const std::string& instance = "") {
  Dataset data = image(instance.empty() ? std::to_string(z + 1) : instance);
  put_at(data, position(z)).text(0x00200013, "IS", std::to_string(z + 1));
  return data.samples(slice_values(z), 16, true);
}

/// A file of frames in functional groups. add: adds the items of a frame, and returns its samples.
template <class Add>
Dataset enhanced(int count, Add add) {
  Dataset measures, shared, orientation;
  measures.text(0x00280030, "DS", "0.75\\0.5").text(0x00180050, "DS", "2.5");
  orientation.text(0x00200037, "DS", "1\\0\\0\\0\\1\\0");
  shared.sequence(0x00289110, {measures}).sequence(0x00209116, {orientation});
  std::vector<Dataset> groups;
  std::vector<std::int64_t> samples;
  for (int i = 0; i < count; ++i) {
    Dataset group;
    for (const std::int64_t value : add(group, i)) samples.push_back(value);
    groups.push_back(group);
  }
  Dataset data = image("9", "MR");
  data.drop(0x00280030).sequence(0x52009229, {shared}).sequence(0x52009230, groups);
  data.text(0x00280008, "IS", std::to_string(count));
  return data.samples(samples, 16, true);
}

inline Dataset& place_frame(Dataset& group, int z) {
  Dataset place;
  place.text(0x00200032, "DS", decimals(position(z)));
  return group.sequence(0x00209113, {place});
}

/// A file with all slices.
inline Dataset frames(const std::string& modality = "CT") {
  Dataset data = image("9", modality);
  data.text(0x00280008, "IS", std::to_string(depth));
  return data.samples(volume_values(), 16, true);
}

struct Dicom : volume_files::Folder {
  volume_files::fs::path put(const Dataset& data) const { return write("v.dcm", data.file()); }
};

inline const discmc::meshing::Axes along_axes = {{{0.5, 0, 0}, {0, 0.75, 0}, {0, 0, 2.5}}};

inline void check_places(const volume_files::VolumeInfo& info, const std::array<double, 3>& origin,
                         const discmc::meshing::Axes& axes) {
  REQUIRE(info.placement);
  CHECK(info.placement->space == discmc::Space::lps);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(info.placement->origin_mm[i] == doctest::Approx(origin[i]).epsilon(1e-9));
    for (std::size_t axis = 0; axis < 3; ++axis)
      CHECK(info.placement->axes_mm[axis][i] == doctest::Approx(axes[axis][i]).epsilon(1e-9));
  }
}

}  // namespace dicom_files
