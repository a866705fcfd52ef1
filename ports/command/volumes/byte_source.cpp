#include "byte_source.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <iostream>
#include <system_error>

#include "volume_error.hpp"

namespace discmc::command {
namespace {

std::size_t read_from(std::istream& in, void* bytes, std::size_t count) {
  in.read(static_cast<char*>(bytes), static_cast<std::streamsize>(count));
  return static_cast<std::size_t>(in.gcount());
}

class StandardInput final : public ByteSource {
 public:
  std::size_t read(void* bytes, std::size_t count) override {
    return read_from(std::cin, bytes, count);
  }
  std::uint64_t max_left() const override { return unbounded; }
};

class Pipe final : public ByteSource {
 public:
  explicit Pipe(std::ifstream in) : in_(std::move(in)) {}
  std::size_t read(void* bytes, std::size_t count) override { return read_from(in_, bytes, count); }
  std::uint64_t max_left() const override { return unbounded; }

 private:
  std::ifstream in_;
};

class HeldBytes final : public ByteSource {
 public:
  explicit HeldBytes(std::vector<unsigned char> bytes) : bytes_(std::move(bytes)) {}
  std::size_t read(void* bytes, std::size_t count) override {
    const std::size_t part = std::min(count, bytes_.size() - at_);
    if (part > 0) std::memcpy(bytes, bytes_.data() + at_, part);
    at_ += part;
    return part;
  }
  std::uint64_t max_left() const override { return bytes_.size() - at_; }

 private:
  std::vector<unsigned char> bytes_;
  std::size_t at_ = 0;
};

class RegularFile final : public ByteSource {
 public:
  RegularFile(std::ifstream in, std::uint64_t bytes) : in_(std::move(in)), left_(bytes) {}
  std::size_t read(void* bytes, std::size_t count) override {
    const std::size_t got = read_from(in_, bytes, count);
    left_ -= std::min<std::uint64_t>(got, left_);
    return got;
  }
  std::uint64_t skip(std::uint64_t count) override {
    const std::uint64_t skipped = std::min(count, left_);
    in_.seekg(static_cast<std::streamoff>(skipped), std::ios::cur);
    left_ -= skipped;
    return skipped;
  }
  std::uint64_t max_left() const override { return left_; }
  std::optional<std::uint64_t> left() const override { return left_; }

 private:
  std::ifstream in_;
  std::uint64_t left_;
};

}  // namespace

std::uint64_t ByteSource::skip(std::uint64_t count) {
  std::array<unsigned char, 65536> dropped;
  for (std::uint64_t left = count; left > 0;) {
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(left, dropped.size()));
    const std::size_t got = read(dropped.data(), wanted);
    left -= got;
    if (got < wanted) return count - left;
  }
  return count;
}

std::size_t PartwiseSource::read(void* bytes, std::size_t count) {
  std::size_t done = 0;
  while (done < count && (left_ > 0 || next_part())) {
    const std::size_t copied = std::min(count - done, left_);
    std::memcpy(static_cast<char*>(bytes) + done, part_, copied);
    part_ += copied;
    left_ -= copied;
    done += copied;
  }
  return done;
}

bool is_read_once(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  return file == "-" || std::filesystem::is_fifo(status) ||
         std::filesystem::is_character_file(status);
}

std::unique_ptr<ByteSource> bytes_of_file(const std::filesystem::path& file) {
  if (file == "-") return std::make_unique<StandardInput>();
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (error == std::errc::filename_too_long)
    fail(file, "the name is longer than the system allows", "give a shorter one");
  const auto fail_to_open = [&] {
    fail(file, "the file cannot be opened", "check its permissions");
  };
  if (status.type() == std::filesystem::file_type::none) fail_to_open();
  if (!std::filesystem::exists(status)) fail(file, "there is no such file", "check the name");
  const bool is_regular = std::filesystem::is_regular_file(status);
  if (!is_regular && !is_read_once(file))
    fail(file, "this is neither a file nor a pipe", "store the volume in a file first");
  const std::uint64_t bytes = is_regular ? std::filesystem::file_size(file, error) : 0;
  std::ifstream in(file, std::ios::binary);
  if (error || !in) fail_to_open();
  if (is_regular) return std::make_unique<RegularFile>(std::move(in), bytes);
  return std::make_unique<Pipe>(std::move(in));
}

bool is_file(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

std::unique_ptr<ByteSource> bytes_in_memory(std::vector<unsigned char> bytes) {
  return std::make_unique<HeldBytes>(std::move(bytes));
}

}  // namespace discmc::command
