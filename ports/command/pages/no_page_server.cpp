#include <stdexcept>

#include "page_server.hpp"

namespace discmc::command {

void serve_page(const ServedFile&, std::uint16_t, const std::function<void(const std::string&)>&) {
  throw std::runtime_error(
      "--serve needs cpp-httplib, and discmc was built without it; install libcpp-httplib-dev and "
      "build again");
}

}  // namespace discmc::command
