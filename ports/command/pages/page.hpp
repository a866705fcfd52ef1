// A page with its data inside, or beside it on a server.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

namespace discmc::command {

/// Returns the page of ports/web as built into the command, or an empty text in builds without it.
std::string_view page_template();

/// Writes the page with a file in it, which the page shows when opened. name: of the file, with the
/// extension of its format. write: called once, writes the content of the file. Throws
/// std::runtime_error in builds without the page.
void write_page(const std::string& name, const std::function<void(std::ostream&)>& write,
                std::ostream& out);

/// Whether a file begins as every page of this build does.
bool is_page(const std::filesystem::path& file);

/// Returns the page that fetches the named file from `source`, an address beside its own, and may
/// fetch nothing else. is_live: the file is a stream that still grows. Throws std::runtime_error
/// like write_page().
std::string served_page(const std::string& name, const std::string& source, bool is_live);

}  // namespace discmc::command
