// What a browser asks on a connection, and what it is sent.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace discmc::command {

/// The parts of a request (RFC 9112) that matter where files are only fetched, and whole.
struct HttpRequest {
  int status = 200;  ///< otherwise of the refusal, and nothing else is set
  std::string method;
  std::string path;  ///< as written, without a query
  std::string host;  ///< with its port, as written
  bool has_range = false;
};

/// Reads the lines before the first empty one.
HttpRequest parse_request(std::string_view head);

/// A connected socket, which it closes.
class HttpConnection {
 public:
  /// What a client can make the server keep: enough for the cookies of other servers here.
  static constexpr std::size_t max_head_bytes = std::size_t{1} << 16;

  explicit HttpConnection(int socket);
  HttpConnection(const HttpConnection&) = delete;
  HttpConnection& operator=(const HttpConnection&) = delete;
  ~HttpConnection();

  /// Reads up to the empty line, and no body. Limit: max_head_bytes (431) in ten seconds (408).
  HttpRequest read_request();
  /// Returns false when the client is gone, or has taken nothing for a minute.
  bool send(std::string_view bytes);
  bool is_open() const;

 private:
  int socket_;
};

}  // namespace discmc::command
