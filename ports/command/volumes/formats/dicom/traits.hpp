// What distinguishes the volumes of one series: times, echoes, phases, kernels.
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
  std::size_t kind = 0;  ///< among trait_count()
  std::string value;
};

/// The traits that a frame has, by their kinds.
using DicomTraits = std::vector<DicomTrait>;

std::size_t trait_count();

/// Whether frames with different values are never of one volume, as with two kernels. Frames of
/// other traits may be, as slices are acquired one after the other.
bool is_of_volume(std::size_t kind);

/// Whether frames that differ in it are of one volume only if their slices interleave evenly.
bool is_of_stack(std::size_t kind);

/// Whether it is a UID, which some programs make anew for every slice.
bool is_uid(std::size_t kind);

/// Whether the value is of little use to people, as a UID.
bool is_for_programs(std::size_t kind);

/// Whether the order of its values is that of volumes: of times, not of UIDs.
bool has_order(std::size_t kind);

/// Returns the value of a trait; empty where the frame has none.
const std::string& trait_of(const DicomTraits& traits, std::size_t kind);

/// For people: "echo time 4.6 ms".
std::string trait_text(std::size_t kind, const std::string& value);

/// For people: "echo time".
const char* trait_name(std::size_t kind);

/// Whether a value comes before another: numbers as such.
bool is_trait_before(const std::string& a, const std::string& b);

/// Reads the traits of a frame.
DicomTraits traits_of(DcmItem& dataset, const Attributes& attributes, std::uint32_t frame);

}  // namespace discmc::command
