// The header of an NRRD file.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_NRRD_HEADER_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_NRRD_HEADER_HPP

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>

#include "segment_labels.hpp"
#include "volumes/header_fields.hpp"
#include "volumes/volume_stream.hpp"

namespace discmc::command {

struct NrrdHeader {
  HeaderFields fields;  ///< by the first of their spellings, in lower case
  SegmentLabels segments{};
  bool closed = false;  ///< by the empty line that data may follow
};

/// Reads the header, or up to a list of data files, which is its rest.
NrrdHeader read_nrrd_header(ByteStream& stream);

/// Whether a word of the header is one of those.
inline bool one_of(std::string_view text, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), text) != names.end();
}

/// Throws the refusal of an axis that is none of space. what: follows the number of the axis.
[[noreturn]] void fail_axis(const HeaderFields& fields, std::size_t axis, const std::string& what);

}  // namespace discmc::command

#endif
