#include "temporary_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace discmc::command {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error("temporary file: " + what + ": " + std::strerror(errno) +
                           "; set TMPDIR to a folder with more space");
}

}  // namespace

TemporaryFile::TemporaryFile() {
  std::error_code error;
  std::string name = (std::filesystem::temp_directory_path(error) / "discmc-XXXXXX").string();
  if (error)
    throw std::runtime_error(
        "there is no folder for temporary files; set TMPDIR to a folder that can be written");
  file_ = mkstemp(name.data());
  if (file_ < 0) fail(name);
  unlink(name.c_str());
}

TemporaryFile::~TemporaryFile() {
  close(file_);
}

std::uint64_t TemporaryFile::append(const void* data, std::size_t bytes) {
  const std::uint64_t begin = size_;
  const char* next = static_cast<const char*>(data);
  for (const char* const end = next + bytes; next != end;) {
    const ssize_t written =
        pwrite(file_, next, static_cast<std::size_t>(end - next), static_cast<off_t>(size_));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail("writing failed");
    next += written;
    size_ += static_cast<std::uint64_t>(written);
  }
  return begin;
}

void TemporaryFile::read(std::uint64_t from, void* data, std::size_t bytes) const {
  char* next = static_cast<char*>(data);
  for (char* const end = next + bytes; next != end;) {
    const ssize_t got =
        pread(file_, next, static_cast<std::size_t>(end - next), static_cast<off_t>(from));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) fail("reading failed");
    next += got;
    from += static_cast<std::uint64_t>(got);
  }
}

}  // namespace discmc::command
