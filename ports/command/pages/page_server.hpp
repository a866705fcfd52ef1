// Serves a page and the file that it shows, to browsers on this computer.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string>

namespace discmc::command {

/// The file that the page shows.
struct ServedFile {
  std::string name;                          ///< with the extension of its format
  bool is_live = false;                      ///< a stream that still grows
  std::optional<std::uint64_t> bytes;        ///< if known
  std::function<void(std::ostream&)> write;  ///< writes its content for each client;
                                             ///< several threads call it
};

/// Serves the page at / and the file at /data, and nothing else, until SIGINT or SIGTERM. Answers
/// on 127.0.0.1, to requests by that name or localhost. When a client disconnects, the output of
/// `write` throws std::ios_base::failure; other exceptions are printed. port: 0 is any free port.
/// started: called once with the page's address. Limit: one server at a time; it blocks those two
/// signals in all threads. A second after the signal the process ends with success, even if a
/// browser is connected. Throws std::runtime_error if the port is in use, and in builds without the
/// page or without a server.
void serve_page(const ServedFile& file, std::uint16_t port,
                const std::function<void(const std::string& address)>& started);

}  // namespace discmc::command
