#include "line.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <utility>

namespace discmc::simulator {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw std::runtime_error(path + ": " + what);
}

int listen_at(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path)
    fail(path, "the name is too long for a socket: give one below " +
                   std::to_string(sizeof address.sun_path) + " bytes");
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  if (std::filesystem::is_socket(path)) unlink(path.c_str());  // left by an earlier run
  const int listener = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const auto* any_address = reinterpret_cast<const sockaddr*>(&address);
  if (listener < 0 || bind(listener, any_address, sizeof address) != 0 || listen(listener, 1) != 0)
    fail(path, std::string("no socket can be made: ") + std::strerror(errno));
  return listener;
}

// Sent rows should be on their way, not queue in the kernel by the thousand.
void keep_short(int descriptor) {
  const int bytes = 1;  // the kernel uses its minimum
  setsockopt(descriptor, SOL_SOCKET, SO_SNDBUF, &bytes, sizeof bytes);
}

}  // namespace

Line::Line(std::string path) : path_(std::move(path)) {
  if (!std::filesystem::is_character_file(path_)) {
    listener_ = listen_at(path_);
    return;
  }
  descriptor_ = open(path_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor_ < 0) fail(path_, std::string("cannot be opened: ") + std::strerror(errno));
}

Line::~Line() {
  hang_up();
  if (listener_ < 0) return;
  close(listener_);
  unlink(path_.c_str());
}

void Line::connect(std::chrono::milliseconds patience) {
  if (is_open()) return;
  pollfd caller{listener_, POLLIN, 0};
  if (poll(&caller, 1, static_cast<int>(patience.count())) != 1)
    fail(path_, "no device has called: is QEMU started with this socket?");
  descriptor_ = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (descriptor_ < 0) fail(path_, std::strerror(errno));
  keep_short(descriptor_);
}

std::size_t Line::read(std::uint8_t* bytes, std::size_t count) {
  if (!is_open()) return 0;
  const ssize_t got = ::read(descriptor_, bytes, count);
  if (got > 0) return static_cast<std::size_t>(got);
  if (got == 0 || (errno != EAGAIN && errno != EINTR)) hang_up();
  return 0;
}

void Line::send(const std::uint8_t* bytes, std::size_t count) {
  waiting_.insert(waiting_.end(), bytes, bytes + count);
  flush();
}

void Line::flush() {
  if (!is_open() || waiting_.empty()) return;
  const ssize_t sent = write(descriptor_, waiting_.data(), waiting_.size());
  if (sent > 0) waiting_.erase(waiting_.begin(), waiting_.begin() + sent);
  if (sent < 0 && errno != EAGAIN && errno != EINTR) hang_up();
}

void Line::hang_up() {
  if (is_open()) close(descriptor_);
  descriptor_ = -1;
}

}  // namespace discmc::simulator
