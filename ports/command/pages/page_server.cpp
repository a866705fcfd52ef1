#include "page_server.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <streambuf>
#include <string_view>
#include <thread>
#include <vector>

#include "http_connection.hpp"
#include "page.hpp"

namespace discmc::command {
namespace {

constexpr const char* own_address = "127.0.0.1";
constexpr const char* html = "text/html; charset=utf-8";
constexpr const char* binary = "application/octet-stream";

enum HttpStatus {
  ok = 200,
  forbidden = 403,
  not_found = 404,
  method_not_allowed = 405,
  range_refused = 416
};

// Refuses requests that name another site (DNS rebinding). Refuses requests for a part of a file,
// because no decoder can start in its middle.
int status_of(const HttpRequest& request) {
  if (request.status != ok) return request.status;
  const std::string name = request.host.substr(0, request.host.rfind(':'));
  if (name != own_address && name != "localhost") return forbidden;
  if (request.method != "GET") return method_not_allowed;
  if (request.has_range) return range_refused;
  return request.path == "/" || request.path == "/data" ? ok : not_found;
}

// Returns the lines before a body. If the size is unknown, each piece of the body begins with its
// own size.
std::string head_of(int status, const char* type, std::optional<std::uint64_t> bytes) {
  return "HTTP/1.1 " + std::to_string(status) + (status == ok ? " OK" : " Refused") +
         "\r\nContent-Type: " + type +
         (bytes ? "\r\nContent-Length: " + std::to_string(*bytes)
                : "\r\nTransfer-Encoding: chunked") +
         "\r\nConnection: close"
         "\r\nX-Content-Type-Options: nosniff"
         "\r\nCross-Origin-Resource-Policy: same-origin"
         "\r\nContent-Security-Policy: frame-ancestors 'none'"
         "\r\nCache-Control: no-store\r\n\r\n";
}

std::string size_of_chunk(std::size_t bytes) {
  std::ostringstream text;
  text << std::hex << bytes << "\r\n";
  return text.str();
}

// Sends its bytes to a client. Fails when the client disconnects or the server stops.
class ClientBuffer : public std::streambuf {
 public:
  ClientBuffer(HttpConnection& connection, bool is_chunked, const std::atomic<bool>& is_stopping)
      : connection_(connection), is_chunked_(is_chunked), is_stopping_(is_stopping) {}

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    const std::string_view piece(bytes, static_cast<std::size_t>(count));
    if (piece.empty()) return 0;  // an empty chunk would end the body
    const bool is_sent = !is_stopping_ &&
                         (!is_chunked_ || connection_.send(size_of_chunk(piece.size()))) &&
                         connection_.send(piece) && (!is_chunked_ || connection_.send("\r\n"));
    return is_sent ? count : 0;
  }
  int sync() override { return !is_stopping_ && connection_.is_open() ? 0 : -1; }

 private:
  HttpConnection& connection_;
  const bool is_chunked_;
  const std::atomic<bool>& is_stopping_;
};

class Server {
 public:
  explicit Server(const ServedFile& file)
      : file_(file),
        page_(served_page(file.name, "data", file.is_live)),
        listener_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {}
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server() { close(listener_); }

  // Returns the port, or nothing if it is in use.
  std::optional<std::uint16_t> bind(std::uint16_t port) {
    const int yes = 1;  // even if a server has just ended
    setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    sockaddr_in address{};
    socklen_t bytes = sizeof address;
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    inet_pton(AF_INET, own_address, &address.sin_addr);
    auto* const generic_address = reinterpret_cast<sockaddr*>(&address);
    const bool is_bound = ::bind(listener_, generic_address, bytes) == 0 &&
                          listen(listener_, SOMAXCONN) == 0 &&
                          getsockname(listener_, generic_address, &bytes) == 0;
    return is_bound ? std::optional(ntohs(address.sin_port)) : std::nullopt;
  }

  void serve_until_signal(const sigset_t& signals) {
    constexpr std::size_t pages = 64;  // each may wait for more of its file
    std::vector<std::thread> threads;
    while (threads.size() < pages) threads.emplace_back([this] { answer_all(); });
    int signal = 0;
    sigwait(&signals, &signal);
    is_stopping_ = true;
    end_soon();
    shutdown(listener_, SHUT_RDWR);
    for (std::thread& thread : threads) thread.join();
  }

 private:
  // A client that neither reads nor writes could delay the end indefinitely.
  static void end_soon() {
    std::thread([] {
      constexpr std::chrono::seconds patience(1);
      std::this_thread::sleep_for(patience);
      std::_Exit(EXIT_SUCCESS);
    }).detach();
  }

  // Answers one connection after another; the system queues further ones.
  void answer_all() {
    constexpr std::chrono::milliseconds until_others_close(100);
    while (!is_stopping_) {
      const int socket = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
      if (socket >= 0)
        answer(socket);
      else if (!is_stopping_)
        std::this_thread::sleep_for(until_others_close);
    }
  }

  void answer(int socket) {
    HttpConnection connection(socket);
    const HttpRequest request = connection.read_request();
    const int status = status_of(request);
    if (status != ok)
      connection.send(head_of(status, "text/plain", 0));
    else if (request.path == "/")
      send(connection, html, page_.size(), [this](std::ostream& out) { out << page_; });
    else
      send(connection, binary, file_.bytes, file_.write);
  }

  void send(HttpConnection& connection, const char* type, std::optional<std::uint64_t> bytes,
            const std::function<void(std::ostream&)>& write) {
    if (!connection.send(head_of(ok, type, bytes))) return;
    ClientBuffer sending(connection, !bytes, is_stopping_);
    std::ostream out(&sending);
    out.exceptions(std::ios::badbit | std::ios::failbit);
    try {
      write(out);
      if (!bytes) connection.send("0\r\n\r\n");
    } catch (const std::ios_base::failure&) {
      // The client has closed the page.
    } catch (const std::exception& error) {
      std::cerr << "discmc: " << error.what() << '\n';
    }
  }

  const ServedFile& file_;
  std::string page_;
  int listener_;
  std::atomic<bool> is_stopping_{false};
};

}  // namespace

void serve_page(const ServedFile& file, std::uint16_t port,
                const std::function<void(const std::string& address)>& started) {
  Server server(file);
  const auto bound = server.bind(port);
  if (!bound)
    throw std::runtime_error("port " + std::to_string(port) +
                             " is in use; give another --port, or leave it out for any free port");
  // Threads started later inherit the blocked signals.
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM}) sigaddset(&signals, signal);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  started(std::string("http://") + own_address + ':' + std::to_string(*bound) + '/');
  server.serve_until_signal(signals);
}

}  // namespace discmc::command
