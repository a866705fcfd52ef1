// A page and the file that it shows, for browsers on this computer.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string>

namespace discmc::command {

/// What the page shows.
struct ServedFile {
  std::string name;                          ///< with the extension of its format
  bool is_live = false;                      ///< a stream that is still coming
  std::optional<std::uint64_t> bytes;        ///< where it is known
  std::function<void(std::ostream&)> write;  ///< writes its content, for every page that asks;
                                             ///< called by several threads at a time
};

/// Serves the page at / and the file at /data, and nothing else, until SIGINT or SIGTERM. It
/// answers on 127.0.0.1, to requests by that name or localhost. The output of `write` throws
/// std::ios_base::failure when the page is gone; what else is thrown is printed. port: 0 is any
/// that is free. started: called once with the page's address. Limit: one at a time; of all
/// threads, those two signals are blocked. A second after the signal the process ends with success,
/// even if a browser is connected. Throws std::runtime_error where the port is taken, and where the
/// command was built without the page or without a server.
void serve_page(const ServedFile& file, std::uint16_t port,
                const std::function<void(const std::string& address)>& started);

}  // namespace discmc::command
