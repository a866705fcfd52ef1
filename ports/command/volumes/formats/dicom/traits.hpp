// Traits that distinguish the volumes of one series: times, echoes, phases, kernels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class DcmItem;

namespace discmc::command {

class Attributes;

/// A trait of a frame, and its value as text.
struct DicomTrait {
  std::size_t kind = 0;  ///< index below trait_count()
  std::string value;
};

/// The traits of a frame, ordered by kind.
using DicomTraits = std::vector<DicomTrait>;

std::size_t trait_count();

/// Whether frames with different values never share a volume, as with two kernels. Other traits may
/// differ within a volume, because slices are acquired one after another.
bool is_of_volume(std::size_t kind);

/// Whether frames with different values share a volume only if their slices interleave evenly.
bool is_of_stack(std::size_t kind);

/// Whether the value is a UID, which some programs create anew for every slice.
bool is_uid(std::size_t kind);

/// Whether the value is of little use to people, such as a UID.
bool is_for_programs(std::size_t kind);

/// Whether volumes can be ordered by the value, such as a time, but not a UID.
bool has_order(std::size_t kind);

/// Returns the value of a trait; empty if the frame has none.
const std::string& trait_of(const DicomTraits& traits, std::size_t kind);

/// Returns text for people: "echo time 4.6 ms".
std::string trait_text(std::size_t kind, const std::string& value);

/// Returns text for people: "echo time".
const char* trait_name(std::size_t kind);

/// Whether a value precedes another one; compares numbers as numbers.
bool is_trait_before(const std::string& a, const std::string& b);

/// Reads the traits of a frame.
DicomTraits traits_of(DcmItem& dataset, const Attributes& attributes, std::uint32_t frame);

}  // namespace discmc::command
