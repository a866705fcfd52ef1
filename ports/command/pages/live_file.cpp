#include "live_file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <stdexcept>

#include "text/message.hpp"

namespace discmc::command {
namespace {

constexpr std::size_t piece_bytes = std::size_t{1} << 16;

// Opens without waiting for a writer; a plain open() of a named pipe would wait.
int opened(const std::string& path) {
  const int descriptor = path == "-" ? fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0)
                                     : open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0)
    throw std::runtime_error(path + (errno == ENOENT
                                         ? ": there is no such file; check the name"
                                         : ": the file cannot be read; check its permissions"));
  return descriptor;
}

}  // namespace

LiveFile::LiveFile(const std::string& path)
    : path_(path), descriptor_(opened(path)), reader_([this] { read(); }) {}

LiveFile::~LiveFile() {
  is_stopping_ = true;
  reader_.join();
  close(descriptor_);
}

void LiveFile::read() {
  constexpr int patience_ms = 100;  // longest delay of the destructor
  sigset_t all;                     // other threads handle signals
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
  std::array<char, piece_bytes> piece;
  pollfd source{descriptor_, POLLIN, 0};
  while (!is_stopping_) {
    if (poll(&source, 1, patience_ms) <= 0) continue;
    const ssize_t count = ::read(descriptor_, piece.data(), piece.size());
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    if (count <= 0) break;
    if (bytes_.size() + static_cast<std::size_t>(count) > max_bytes) {
      print_message(path_, "more than " + std::to_string(max_bytes >> 20) +
                               " MiB arrived; the rest is left out");
      break;
    }
    append(piece.data(), static_cast<std::size_t>(count));
  }
  end();
}

void LiveFile::append(const char* bytes, std::size_t count) {
  const std::lock_guard<std::mutex> lock(mutex_);
  bytes_.append(bytes, count);
  has_more_.notify_all();
}

void LiveFile::end() {
  const std::lock_guard<std::mutex> lock(mutex_);
  is_at_end_ = true;
  has_more_.notify_all();
}

void LiveFile::copy_to(std::ostream& out) {
  constexpr std::chrono::milliseconds flush_interval{500};
  std::size_t written = 0;
  std::unique_lock<std::mutex> lock(mutex_);
  while (written < bytes_.size() || !is_at_end_) {
    const std::string piece = bytes_.substr(written, piece_bytes);
    if (piece.empty()) has_more_.wait_for(lock, flush_interval);
    lock.unlock();
    out.write(piece.data(), static_cast<std::streamsize>(piece.size())).flush();
    written += piece.size();
    lock.lock();
  }
}

}  // namespace discmc::command
