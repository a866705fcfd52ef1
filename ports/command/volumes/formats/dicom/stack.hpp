// Finds the volumes among many DICOM frames, and chooses one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "image.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// The frames of one volume.
struct DicomStack {
  std::vector<DicomFrame> frames;
  /// How the stack differs from others of its series, for people: ", echo time 4.6 ms".
  std::string distinction = {};
  /// Set if only an order distinguishes it, not an element: "number 2 by trigger time".
  std::string order = {};

  const DicomImage& image() const { return *frames[0].image; }
};

/// How to sort many frames into volumes.
struct DicomSorting {
  /// Whether each volume has one slice per position; otherwise positions are ignored.
  bool is_by_position = true;
  /// Whether one volume may have slices of several series.
  bool merges_series = false;
};

/// Returns the stacks of all frames, ordered by series number. A stack has one series, size, sample
/// type, direction, kernel and kind of image. If slices share a position, a stack holds slices of
/// one time, one echo, or another trait.
std::vector<DicomStack> dicom_stacks(const std::vector<DicomFrame>& frames,
                                     const DicomSorting& sorting);

/// Whether two frames have the same directions. Both have a place, or neither does.
bool have_one_direction(const DicomFrame& a, const DicomFrame& b);

/// Returns the positions of the first and the last slice along a normal. Limit: all frames have
/// places.
std::pair<double, double> extent_along(const DicomStack& stack, const Vector& normal);

/// Returns the file's name and the frame's number, for messages.
std::string name_of(const DicomFrame& frame);

/// Frames without common positions, or frames that no trait separates.
struct SeparatedFrames {
  std::vector<DicomFrame> frames;
  /// Set if only an order separates them, not a trait: "number 2 by trigger time".
  std::string order;
};

/// Separates frames with places and one direction. Copies of an object count once, unless all
/// frames stay together.
std::vector<SeparatedFrames> separated(const std::vector<DicomFrame>& frames);

/// A stack, and the number of stacks in the chosen series.
struct ChosenStack {
  const DicomStack* stack = nullptr;
  std::uint64_t among = 1;
};

/// Returns the stack of the series, given by its UID or its number in the list, from 1; a single
/// stack needs no choice. The frame, from 0, chooses one of several in a series. Throws
/// VolumeError, with the list, if the choice fits no stack or several.
ChosenStack chosen_stack(const std::filesystem::path& source, const std::vector<DicomStack>& stacks,
                         const VolumeOptions& options);

}  // namespace discmc::command
