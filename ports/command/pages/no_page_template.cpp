#include "page_template.hpp"

namespace discmc::host {

std::string_view page_template() {
  return {};
}

}  // namespace discmc::host
