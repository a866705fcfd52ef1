#include "files.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <system_error>

#include "text/words.hpp"
#include "volumes/packing.hpp"
#include "volumes/volume_error.hpp"
#include "volumes/volume_stream.hpp"

namespace discmc::command {
namespace {

using Path = std::filesystem::path;

// Hidden files of macOS and git annex may have names of images, but hold none.
bool is_hidden(const Path& file) {
  return file.filename().native().rfind('.', 0) == 0;
}

// Returns the entries of a folder and its subfolders, except hidden ones, ordered by name.
template <class Fits>
std::vector<Path> entries_in(const Path& folder, Fits fits) {
  using Iterator = std::filesystem::recursive_directory_iterator;
  std::vector<Path> entries;
  std::error_code error;
  for (Iterator entry(folder, std::filesystem::directory_options::skip_permission_denied, error);
       !error && entry != Iterator(); entry.increment(error)) {
    if (is_hidden(entry->path()))
      entry.disable_recursion_pending();
    else if (fits(*entry))
      entries.push_back(entry->path());
  }
  if (error)
    fail(folder, "the folder cannot be listed (" + error.message() + ")", "check its permissions");
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool is_dicom(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string head(dicom_head_bytes, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  if (packing_of_name(file) && packing_of(head))
    return has_dicom_name(without_packing(file)) ||
           is_dicom_head(open_content(file).peek(dicom_head_bytes));
  return is_dicom_head(head) || has_dicom_name(file);
}

// An element in old files without a file header, low byte first.
struct Element {
  std::uint32_t tag;
  std::size_t bytes;  // size, including its value
};

std::optional<Element> element_at(std::string_view bytes) {
  constexpr std::size_t header_bytes = 8;
  if (bytes.size() < header_bytes) return std::nullopt;
  const auto number = [bytes](std::size_t at, std::size_t count) {
    return static_cast<std::uint32_t>(whole_of(&bytes[at], count, false));
  };
  const auto is_letter = [bytes](std::size_t at) { return bytes[at] >= 'A' && bytes[at] <= 'Z'; };
  // The value representation is either two letters before a 16-bit length, or missing.
  const bool is_explicit = is_letter(4) && is_letter(5);
  return Element{number(0, 2) << 16 | number(2, 2),
                 header_bytes + (is_explicit ? number(6, 2) : number(4, 4))};
}

// Whether a file begins directly with the elements that identify the image, in the order of their
// tags.
bool is_bare_dataset(std::string_view head) {
  constexpr std::uint32_t group = 0x0008;
  constexpr int enough = 3;
  std::uint32_t last = 0;
  for (int count = 0; count < enough; ++count) {
    const auto element = element_at(head);
    if (!element || element->tag >> 16 != group || (count > 0 && element->tag <= last))
      return false;
    last = element->tag;
    head.remove_prefix(std::min(element->bytes, head.size()));
  }
  return true;
}

constexpr std::uint64_t unknown_end = std::numeric_limits<std::uint64_t>::max();

// The items that are open at an offset, by their ends.
class OpenItems {
 public:
  /// length: as stored in the file.
  void start(std::uint64_t content, std::uint32_t length) {
    constexpr std::uint32_t undefined = 0xffffffff;
    ends_.push_back(length == undefined ? unknown_end : content + length);
  }
  void end() {
    if (!ends_.empty()) ends_.pop_back();
  }
  /// Closes the items that end before an offset.
  void go_to(std::uint64_t at) {
    while (!ends_.empty() && ends_.back() <= at) ends_.pop_back();
  }
  std::size_t count() const { return ends_.size(); }

 private:
  std::vector<std::uint64_t> ends_;
};

// The last eight bytes read: a tag and a length.
class Window {
 public:
  void add(std::uint8_t byte) { bytes_ = bytes_ << 8 | byte; }
  std::uint32_t tag() const { return static_cast<std::uint32_t>(bytes_ >> 32); }
  std::uint32_t big_endian_length() const { return static_cast<std::uint32_t>(bytes_); }
  std::uint32_t length() const {
    const std::uint32_t b = big_endian_length();
    return b >> 24 | (b >> 8 & 0xff00) | (b << 8 & 0xff0000) | b << 24;
  }

 private:
  std::uint64_t bytes_ = 0;
};

}  // namespace

bool is_dicom_head(std::string_view head) {
  constexpr std::size_t magic_at = 128;
  return (head.size() > magic_at && head.substr(magic_at, 4) == "DICM") || is_bare_dataset(head);
}

bool has_dicom_name(const std::filesystem::path& file) {
  const std::string extension = lower(file.extension().string());
  return extension == ".dcm" || extension == ".ima";
}

std::vector<Path> files_in(const Path& folder) {
  std::error_code unknown;
  return entries_in(folder, [&](const auto& entry) { return entry.is_regular_file(unknown); });
}

std::vector<Path> dicom_files(const Path& folder) {
  std::vector<Path> files = files_in(folder);
  files.erase(std::remove_if(files.begin(), files.end(), std::not_fn(is_dicom)), files.end());
  return files;
}

std::vector<Path> dead_links(const Path& folder) {
  std::error_code unknown;
  return entries_in(folder, [&](const auto& entry) {
    return entry.is_symlink(unknown) && !entry.exists(unknown);
  });
}

bool is_nested_within(std::uint32_t max_depth, const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  OpenItems items;
  Window window;
  std::uint64_t at = 0;
  std::array<char, 65536> block;
  while (in.read(block.data(), block.size()), in.gcount() > 0)
    for (std::streamsize i = 0; i < in.gcount(); ++i) {
      window.add(static_cast<std::uint8_t>(block[static_cast<std::size_t>(i)]));
      ++at;
      const std::uint32_t tag = window.tag();
      const bool is_item = tag == 0xfeff00e0;
      const bool is_big_endian_item = tag == 0xfffee000;
      if (tag == 0xfeff0de0 || tag == 0xfffee00d) items.end();
      if (!is_item && !is_big_endian_item) continue;
      items.go_to(at - 8);
      items.start(at, is_item ? window.length() : window.big_endian_length());
      if (items.count() > max_depth) return false;
    }
  return true;
}

}  // namespace discmc::command
