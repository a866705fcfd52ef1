#include "page.hpp"

namespace discmc::command {

std::string_view page_template() {
  return {};
}

}  // namespace discmc::command
