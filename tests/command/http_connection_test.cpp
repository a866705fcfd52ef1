// Requests to the server of discmc view --serve: parsing, and the number of bytes read.
#include "pages/http_connection.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <future>
#include <string_view>

#include "test.hpp"

namespace {

using discmc::command::HttpConnection;
using discmc::command::HttpRequest;
using discmc::command::parse_request;

// Two ends of a connection; the test is the client.
class Client {
 public:
  Client() { REQUIRE(socketpair(AF_UNIX, SOCK_STREAM, 0, ends_.data()) == 0); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  ~Client() { close(ends_[0]); }

  int server() const { return ends_[1]; }

  // Returns the number of bytes sent before the server closed the connection.
  std::size_t send(std::string_view bytes, std::size_t piece = std::string_view::npos) const {
    std::size_t sent = 0;
    while (sent < bytes.size()) {
      const std::string_view next = bytes.substr(sent, piece);
      const ssize_t count = ::send(ends_[0], next.data(), next.size(), MSG_NOSIGNAL);
      if (count < 0) break;
      sent += static_cast<std::size_t>(count);
    }
    return sent;
  }

 private:
  std::array<int, 2> ends_{};
};

// The server's result for a request, and the number of bytes that the client could send.
struct Exchange {
  HttpRequest request;
  std::size_t sent;
};

Exchange exchange(const std::string& bytes, std::size_t piece = std::string::npos) {
  const Client client;
  auto sent = std::async(std::launch::async, [&] { return client.send(bytes, piece); });
  HttpRequest request;
  {
    HttpConnection connection(client.server());
    request = connection.read_request();
  }
  return {request, sent.get()};
}

}  // namespace

TEST_CASE("the method, path, host and range of an HTTP request are parsed") {
  const HttpRequest request = parse_request(
      "GET /data?x=1 HTTP/1.1\r\nAccept: */*\r\nhOST:\t localhost:8000 \r\nrange: bytes=1-2\r\n");
  CHECK(request.status == 200);
  CHECK(request.method == "GET");
  CHECK(request.path == "/data");
  CHECK(request.host == "localhost:8000");
  CHECK(request.has_range);
  CHECK(!parse_request("GET / HTTP/1.1\r\nX-Range: bytes=1-2").has_range);
  CHECK(parse_request("GET / HTTP/1.1").host.empty());
}

TEST_CASE("invalid HTTP/1 requests, and requests with two hosts, are refused") {
  for (const std::string_view head : {"", "GET", "GET /", "GET / HTTP/2.0", "GET  / HTTP/1.1",
                                      "Host: localhost\r\nGET / HTTP/1.1",
                                      "GET / HTTP/1.1\r\nHost: localhost\r\nHost: evil.example"}) {
    CAPTURE(head);
    CHECK(parse_request(head).status == 400);
  }
}

TEST_CASE("an HTTP request is read up to its empty line, in pieces of any size") {
  const std::string bytes = "GET / HTTP/1.1\r\nHost: localhost\r\n\r\nRange: of the body\r\n\r\n";
  for (std::size_t piece = 1; piece <= bytes.size(); ++piece) {
    CAPTURE(piece);
    const HttpRequest request = exchange(bytes, piece).request;
    CHECK(request.status == 200);
    CHECK(request.host == "localhost");
    CHECK(!request.has_range);
  }
}

TEST_CASE("a request head longer than the limit is answered with 431 and not read to its end") {
  const std::string begin = "GET / HTTP/1.1\r\nHost: localhost\r\nX: ", end = "\r\n\r\n";
  const std::size_t left = HttpConnection::max_head_bytes - begin.size() - end.size();
  CHECK(exchange(begin + std::string(left, 'a') + end).request.host == "localhost");
  CHECK(exchange(begin + std::string(left + 1, 'a') + end).request.status == 431);

  constexpr std::size_t endless = std::size_t{1} << 24;
  std::string headers = begin;
  while (headers.size() < endless) headers += "\r\nX: " + std::string(4000, 'a');
  for (const std::string& bytes : {headers, "GET /" + std::string(endless, 'a')}) {
    const Exchange answer = exchange(bytes);
    CHECK(answer.request.status == 431);
    CHECK(answer.sent < endless / 2);
  }
}

TEST_CASE("a client that disconnects ends the wait for its request") {
  const Client client;
  client.send("GET / HT");
  HttpConnection connection(dup(client.server()));
  CHECK(connection.is_open());
  shutdown(client.server(), SHUT_RD);
  CHECK(connection.read_request().status == 400);
  CHECK(!connection.is_open());
  close(client.server());
}
