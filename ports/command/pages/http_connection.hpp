// A connection to a browser: its requests and the answers.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace discmc::command {

/// The parts of a request (RFC 9112) that a server of whole files needs.
struct HttpRequest {
  int status = 200;  ///< otherwise the error, and no other member is set
  std::string method;
  std::string path;  ///< as written, without a query
  std::string host;  ///< with its port, as written
  bool has_range = false;
};

/// Parses the lines before the first empty line.
HttpRequest parse_request(std::string_view head);

/// Owns a connected socket and closes it.
class HttpConnection {
 public:
  /// The most that a client can make the server store: enough for the cookies of other servers on
  /// this computer.
  static constexpr std::size_t max_head_bytes = std::size_t{1} << 16;

  explicit HttpConnection(int socket);
  HttpConnection(const HttpConnection&) = delete;
  HttpConnection& operator=(const HttpConnection&) = delete;
  ~HttpConnection();

  /// Reads up to the empty line, without a body. Limit: max_head_bytes (else 431), ten seconds
  /// (else 408).
  HttpRequest read_request();
  /// Returns false if the client has disconnected, or has accepted nothing for a minute.
  bool send(std::string_view bytes);
  bool is_open() const;

 private:
  int socket_;
};

}  // namespace discmc::command
