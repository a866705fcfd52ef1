// Names of any bytes as the text of files.
#pragma once

#include <string>
#include <string_view>

namespace discmc::command {

/// A string of JSON, in quotes. What is no UTF-8 becomes the replacement character, U+FFFD.
std::string json_string(std::string_view name);

/// The value of an attribute of XML, without quotes. What XML cannot hold, control characters too,
/// becomes U+FFFD.
std::string xml_attribute(std::string_view name);

/// The text in UTF-8. One without any character of UTF-8 above ASCII is taken to be Latin-1.
std::string utf8(std::string_view text);

}  // namespace discmc::command
