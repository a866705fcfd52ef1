// A page that has its data inside, or beside it on a server.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

namespace discmc::command {

/// Returns the page of ports/web, as it was when the command was built; nothing where it was not.
std::string_view page_template();

/// Writes the page with a file in it, which it shows when it is opened. name: of the file, with the
/// extension of its format. write: called once, writes the content of the file.
/// Throws std::runtime_error where the command was built without the page.
void write_page(const std::string& name, const std::function<void(std::ostream&)>& write,
                std::ostream& out);

/// Whether a file begins as every page of this build does.
bool is_page(const std::filesystem::path& file);

/// Returns the page that fetches the file of this name from `source`, an address beside its own,
/// and may fetch nothing else. is_live: the file is a stream that is still coming.
/// Throws std::runtime_error as write_page().
std::string served_page(const std::string& name, const std::string& source, bool is_live);

}  // namespace discmc::command
