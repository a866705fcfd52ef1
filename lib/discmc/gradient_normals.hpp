// Gradient normals in the first pass: an extractor that adds to every run the normal at its start.
//
//   using Normals = GradientNormals<uint8_t>;           // of the samples' type
//   static uint8_t memory[minimum_bytes<uint16_t, Normals>(limits) + 24 * 1024];
//   static NormalExtractor16<uint8_t> extractor;        // used like any other
//   encoder.encode_normals();                           // otherwise the stream omits them
//   extractor.set_spacing(spacing_nm);                  // before start(), unless voxels are cubes
//
// The extractor keeps the samples of four slices and six rows. It delays every row by a slice and a
// row, so that it has the samples on all sides of the sweep. It computes a normal for each corner
// and stores it with the run that starts there; points in the middle of a side have no normal. A
// slab has one slice of context: near a seam the gradient uses the available slices, as at the end
// of a volume.
#ifndef DISCMC_GRADIENT_NORMALS_HPP
#define DISCMC_GRADIENT_NORMALS_HPP

#include <discmc/extractor.hpp>
#include <discmc/trace/gradient_intake.hpp>

namespace discmc {

/// An extractor with normals. It accepts samples of one type, keeps four slices of them in the
/// memory, and sweeps one slice and one row later. Except for the normals, the events are those of
/// an extractor without normals. memory: at least minimum_bytes<Index,
/// GradientNormals<Sample>>(limits); likewise for explicit capacities.
template <class Index, class Sample>
class NormalExtractor
    : public BasicExtractor<Index, GradientNormals<Sample>, trace::Sweep<Index, OctahedralNormal>> {
 public:
  NormalExtractor() = default;

  /// Sets the distances between voxels for the normals of the next scans; without this call voxels
  /// are cubes. The `start` event passes the spacing to the stream. spacing_nm: negative for a
  /// mirrored axis; Units: nanometres. Limit: not during a scan, whose later normals would differ.
  void set_spacing(const int32_t (&spacing_nm)[3]) { this->intake().set_spacing(spacing_nm); }

  /// Bits have no gradient.
  PushResult push_bits(const uint8_t* bits) = delete;

 private:
  friend struct Checkpoint<NormalExtractor>;
  NormalExtractor(const NormalExtractor&) = default;
  NormalExtractor& operator=(const NormalExtractor&) = default;
};

template <class Sample>
using NormalExtractor16 = NormalExtractor<uint16_t, Sample>;
template <class Sample>
using NormalExtractor32 = NormalExtractor<uint32_t, Sample>;

}  // namespace discmc

#endif
