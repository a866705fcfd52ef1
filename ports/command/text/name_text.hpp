// Names of arbitrary bytes as text for files.
#pragma once

#include <string>
#include <string_view>

namespace discmc::command {

/// Returns a quoted JSON string. Invalid UTF-8 becomes the replacement character, U+FFFD.
std::string json_string(std::string_view name);

/// Returns the value of an XML attribute, without quotes. Bytes and control characters that XML
/// cannot hold become U+FFFD.
std::string xml_attribute(std::string_view name);

/// Converts to UTF-8. A text without any non-ASCII character of UTF-8 counts as Latin-1.
std::string utf8(std::string_view text);

}  // namespace discmc::command
