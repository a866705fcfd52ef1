// The user's browser.
#pragma once

#include <string>

namespace discmc::command {

/// Opens a file or an address with the program in the environment variable BROWSER, or else with
/// the desktop's default program. Does not wait for the program. Returns whether it was started.
bool open_in_browser(const std::string& page);

}  // namespace discmc::command
