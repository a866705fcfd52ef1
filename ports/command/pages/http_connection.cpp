#include "http_connection.hpp"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>

#include "text/words.hpp"

namespace discmc::command {
namespace {

constexpr std::string_view line_end = "\r\n";
constexpr std::string_view head_end = "\r\n\r\n";
constexpr int bad_request = 400;
constexpr int too_late = 408;
constexpr int too_large = 431;

// Removes and returns the text before a separator, and removes the separator.
std::string_view next_part(std::string_view& text, std::string_view separator) {
  const std::size_t end = text.find(separator);
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + separator.size());
  return part;
}

HttpRequest refused(int status) {
  HttpRequest request;
  request.status = status;
  return request;
}

}  // namespace

HttpRequest parse_request(std::string_view head) {
  std::string_view first = next_part(head, line_end);
  HttpRequest request;
  request.method = next_part(first, " ");
  std::string_view target = next_part(first, " ");
  request.path = next_part(target, "?");
  if (first.rfind("HTTP/1.", 0) != 0) return refused(bad_request);
  bool has_host = false;
  while (!head.empty()) {
    std::string_view value = next_part(head, line_end);
    const std::string name = lower(next_part(value, ":"));
    if (name == "range") request.has_range = true;
    if (name != "host") continue;
    if (has_host) return refused(bad_request);
    has_host = true;
    request.host = trimmed(value);
  }
  return request;
}

HttpConnection::HttpConnection(int socket) : socket_(socket) {
  constexpr timeval max_wait{60, 0};
  setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &max_wait, sizeof max_wait);
  const int yes = 1;
  setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
}

HttpConnection::~HttpConnection() {
  close(socket_);
}

HttpRequest HttpConnection::read_request() {
  using std::chrono::steady_clock;
  constexpr std::chrono::seconds patience(10);
  const auto last = steady_clock::now() + patience;
  std::array<char, 4096> piece;
  std::string head;
  std::size_t end = std::string::npos;
  while (end == std::string::npos) {
    if (head.size() >= max_head_bytes) return refused(too_large);
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(last - steady_clock::now());
    pollfd source{socket_, POLLIN, 0};
    if (left.count() <= 0 || poll(&source, 1, static_cast<int>(left.count())) <= 0)
      return refused(too_late);
    const ssize_t got =
        recv(socket_, piece.data(), std::min(piece.size(), max_head_bytes - head.size()), 0);
    if (got <= 0) return refused(bad_request);
    // The end of the head may begin in an earlier piece.
    const std::size_t from = head.size() - std::min(head.size(), head_end.size() - 1);
    head.append(piece.data(), static_cast<std::size_t>(got));
    end = head.find(head_end, from);
  }
  return parse_request(std::string_view(head).substr(0, end));
}

bool HttpConnection::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

bool HttpConnection::is_open() const {
  char next = 0;
  const ssize_t got = recv(socket_, &next, 1, MSG_PEEK | MSG_DONTWAIT);
  return got > 0 || (got < 0 && (errno == EAGAIN || errno == EINTR));
}

}  // namespace discmc::command
