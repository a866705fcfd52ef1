#include "stream_target.hpp"

#include <unistd.h>

#include <cerrno>
#include <iostream>
#include <stdexcept>
#include <system_error>

namespace discmc::device {

StreamTarget::StreamTarget(const std::string& path)
    : path_(path), out_(path == "-" ? &std::cout : &file_), stream_(out_) {
  if (path == "-") {
    if (isatty(STDOUT_FILENO) == 1)
      throw std::runtime_error("a stream is not written to a terminal; give -o FILE, or a pipe");
    return;
  }
  file_.open(path, std::ios::binary);
  if (!file_)
    throw std::runtime_error(path +
                             ": the file cannot be written; check the folder and its permissions");
}

void StreamTarget::flush() {
  if (!out_->flush())
    throw std::runtime_error(path_ + ": writing failed (" + std::generic_category().message(errno) +
                             "); free space, or write to another disk");
}

}  // namespace discmc::device
