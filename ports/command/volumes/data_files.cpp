#include "data_files.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "header_fields.hpp"
#include "text/words.hpp"
#include "volume_error.hpp"

namespace discmc::command {
namespace {

// A pattern of printf with one whole number, such as "%d" or "%03d". printf itself would also
// interpret anything else that the file contains.
struct Pattern {
  std::string before;
  std::string after;
  std::size_t width = 0;

  std::string name(std::int64_t number) const {
    const std::string digits = std::to_string(number);
    return before + std::string(width - std::min(width, digits.size()), '0') + digits + after;
  }
};

std::optional<Pattern> pattern_of(std::string_view text) {
  const std::size_t percent = text.find('%');
  const std::size_t letter = text.find_first_not_of("0123456789", percent + 1);
  if (letter == std::string_view::npos || text[letter] != 'd') return std::nullopt;
  const std::string_view width = text.substr(percent + 1, letter - percent - 1);
  const bool is_padded = !width.empty() && width.front() == '0';
  if (width.size() > 2 || (!width.empty() && !is_padded)) return std::nullopt;
  Pattern pattern{std::string(text.substr(0, percent)), std::string(text.substr(letter + 1))};
  if (width.size() == 2) pattern.width = static_cast<std::size_t>(width[1] - '0');
  if (pattern.after.find('%') != std::string::npos) return std::nullopt;
  return pattern;
}

DataFiles numbered(const std::filesystem::path& header, std::string_view field,
                   std::string_view text) {
  const auto parts = words(text);
  const auto pattern = pattern_of(parts[0]);
  if (!pattern || parts.size() < 3 || parts.size() > 5)
    fail(header,
         std::string(field) + " is " + shown(text) + ", which is not a pattern with a range",
         "correct it, as in: slice%03d.raw 1 4 1");
  const std::int64_t first = integer(header, field, parts[1]);
  const std::int64_t last = integer(header, field, parts[2]);
  const std::int64_t step = parts.size() > 3 ? integer(header, field, parts[3]) : 1;
  constexpr std::int64_t max_number = std::int64_t{1} << 30;
  const auto is_small = [](std::int64_t number) {
    return number >= -max_number && number <= max_number;
  };
  if (!is_small(first) || !is_small(last) || !is_small(step) || step == 0 ||
      (last - first) / step < 0)
    fail(header, std::string(field) + " is " + shown(text) + ", whose range is empty",
         "give the first number, the last number and the step");
  const auto path = [header, pattern = *pattern, first, step](std::uint64_t file) {
    return beside(header, pattern.name(first + static_cast<std::int64_t>(file) * step));
  };
  return {static_cast<std::uint64_t>((last - first) / step) + 1, path};
}

DataFiles listed(ByteStream& header) {
  std::vector<std::filesystem::path> paths;
  while (const auto line = header.read_line())
    if (!trimmed(*line).empty()) paths.push_back(beside(header.file(), trimmed(*line)));
  if (paths.empty())
    fail(header.file(), "the list of data files is empty",
         "name one file per line after the header");
  const std::size_t count = paths.size();
  return {count, [paths = std::move(paths)](std::uint64_t file) { return paths[file]; }};
}

class JoinedFiles final : public ByteSource {
 public:
  JoinedFiles(DataFiles files, std::uint64_t bytes_each,
              std::function<ByteStream(const std::filesystem::path&)> open)
      : files_(std::move(files)), bytes_each_(bytes_each), open_(std::move(open)) {}

  std::size_t read(void* bytes, std::size_t count) override {
    std::size_t done = 0;
    while (done < count && (left_ > 0 || next_file())) {
      const std::size_t wanted =
          static_cast<std::size_t>(std::min<std::uint64_t>(count - done, left_));
      const std::size_t got = file_->read(static_cast<char*>(bytes) + done, wanted);
      done += got;
      left_ -= got;
      const bool has_more = left_ == 0 && !file_->peek(1).empty();
      if (left_ == 0) file_->check_end();
      const std::string damage = file_->damage();
      if (got < wanted || !damage.empty())
        fail(file_->file(),
             std::to_string(left_) + " bytes of " + std::to_string(bytes_each_) + " are missing" +
                 (damage.empty() ? "" : ": " + damage),
             "copy the file again");
      // If a header were not skipped, all samples would be displaced.
      if (has_more && !skips_header_)
        fail(file_->file(),
             "the data file is longer than its share of " + std::to_string(bytes_each_) + " bytes",
             "give the bytes before the samples as byte skip or HeaderSize");
    }
    return done;
  }

  // Later files are not opened before their turn.
  std::uint64_t max_left() const override { return unbounded; }

 private:
  bool next_file() {
    if (next_ == files_.count) return false;
    file_.emplace(open_(files_.path(next_++)));
    left_ = bytes_each_;
    skips_header_ = file_->position() > 0;
    return true;
  }

  DataFiles files_;
  std::uint64_t bytes_each_;
  std::function<ByteStream(const std::filesystem::path&)> open_;
  std::uint64_t next_ = 0;
  std::uint64_t left_ = 0;
  bool skips_header_ = false;
  std::optional<ByteStream> file_;
};

}  // namespace

bool names_several_files(std::string_view text) {
  const auto parts = words(text);
  return !parts.empty() &&
         (parts[0] == "LIST" || (parts.size() > 1 && parts[0].find('%') != std::string_view::npos));
}

DataFiles data_files(ByteStream& header, std::string_view field, std::string_view text) {
  return words(text)[0] == "LIST" ? listed(header) : numbered(header.file(), field, text);
}

ByteStream joined(const std::filesystem::path& header, const DataFiles& files, VolumeInfo& info,
                  std::function<ByteStream(const std::filesystem::path&)> open) {
  const std::uint64_t bytes = bytes_of_all(info);
  if (bytes % files.count != 0 || bytes < files.count)
    fail(header,
         std::to_string(files.count) + " data files share " + std::to_string(bytes) + " bytes",
         "name a file for each slice");
  const std::uint64_t share = bytes / files.count;
  if (const auto in_file = open(files.path(0)).left(); in_file && *in_file > share)
    note(info,
         std::to_string(*in_file - share) + " bytes after the samples of a data file are left out");
  return {header, std::make_unique<JoinedFiles>(files, share, std::move(open))};
}

}  // namespace discmc::command
