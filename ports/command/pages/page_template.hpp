// The page of ports/web, as it was when the command was built.
#ifndef DISCMC_COMMAND_PAGES_PAGE_TEMPLATE_HPP
#define DISCMC_COMMAND_PAGES_PAGE_TEMPLATE_HPP

#include <string_view>

namespace discmc::command {

/// Returns its text; none where it was not built.
std::string_view page_template();

}  // namespace discmc::command

#endif
