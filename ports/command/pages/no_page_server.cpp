#include <stdexcept>

#include "page_server.hpp"

namespace discmc::command {

void serve_page(const ServedFile&, std::uint16_t, const std::function<void(const std::string&)>&) {
  throw std::runtime_error(
      "this discmc was built without cpp-httplib, which --serve needs: install it (Debian: "
      "libcpp-httplib-dev), and build discmc again");
}

}  // namespace discmc::command
