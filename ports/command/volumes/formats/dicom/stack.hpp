// DICOM frames that make a volume, found among many, and which volume is meant.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "image.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// Frames of one volume.
struct DicomStack {
  std::vector<DicomFrame> frames;
  /// What distinguishes it from others of its series, for people: ", echo time 4.6 ms".
  std::string distinction = {};
  /// If only an order does, not an element: "number 2 by trigger time".
  std::string order = {};

  const DicomImage& image() const { return *frames[0].image; }
};

/// How to find the volumes of many frames.
struct DicomSorting {
  /// Whether a position is of one slice in each volume; otherwise positions are not looked at.
  bool is_by_position = true;
  /// Whether slices are of one volume whatever their series.
  bool merges_series = false;
};

/// Returns the stacks of all frames, by the numbers of their series. A stack is of one series, of
/// one size, sample type and direction, and of one kernel and kind of image. If slices lie in
/// the same place, a stack holds those with the same time, echo, or another trait.
std::vector<DicomStack> dicom_stacks(const std::vector<DicomFrame>& frames,
                                     const DicomSorting& sorting);

/// Whether two frames, both with a place or both without, have the same directions.
bool have_one_direction(const DicomFrame& a, const DicomFrame& b);

/// Where the first and the last slice lie along a normal. Limit: all frames have places.
std::pair<double, double> extent_along(const DicomStack& stack, const Vector& normal);

/// For messages: the name of the file, and the number of the frame in it.
std::string name_of(const DicomFrame& frame);

/// Frames of which no two lie in the same place, or that nothing separates.
struct SeparatedFrames {
  std::vector<DicomFrame> frames;
  /// If only an order separates them, not a trait: "number 2 by trigger time".
  std::string order;
};

/// Separates frames with places and one direction. Copies of one object count once, but where all
/// frames stay together.
std::vector<SeparatedFrames> separated(const std::vector<DicomFrame>& frames);

/// A stack, and of how many that the choice of the series leaves.
struct ChosenStack {
  const DicomStack* stack = nullptr;
  std::uint64_t among = 1;
};

/// Returns the stack of the series, given by its UID or by its place in the list, from 1; the only
/// stack also without it. The frame chooses one of several in a series; the first is 0. Throws
/// VolumeError, with the list, where none is meant or several are.
ChosenStack chosen_stack(const std::filesystem::path& source, const std::vector<DicomStack>& stacks,
                         const VolumeOptions& options);

}  // namespace discmc::command
