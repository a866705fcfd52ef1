// Normals during the scan: an extractor that adds to every run the normal of the surface at its
// start.
//
//   using NormalScan = NormalExtractor16<uint8_t>;      // the type of the samples
//   static uint8_t memory[NormalScan::minimum_bytes(limits) + 24 * 1024];
//   static NormalScan extractor;                        // used like any other extractor
//   encoder.encode_normals();                           // otherwise the stream omits them
//   extractor.set_spacing(spacing_nm);                  // before start(), unless voxels are cubes
//
// A normal is the gradient of the samples at a corner. The gradient needs the samples on all sides.
// So the extractor keeps four slices and six rows of samples, and its events come one slice and one
// row later. At the ends of a volume, and at the seams of a slab, the gradient uses the slices that
// exist. Vertices between two corners have no normal. For normals in a second pass see
// sample_window.hpp.
#ifndef DISCMC_NORMAL_EXTRACTOR_HPP
#define DISCMC_NORMAL_EXTRACTOR_HPP

#include <discmc/extractor.hpp>
#include <discmc/trace/gradient_intake.hpp>

namespace discmc {

/// An extractor with normals. It accepts samples of one type and no bits. Sample is uint8_t,
/// uint16_t or int16_t.
template <class Index, class Sample>
class NormalExtractor : public BasicExtractor<Index, detail::trace::GradientIntake<Sample>,
                                              detail::trace::Sweep<Index, OctahedralNormal>> {
 public:
  NormalExtractor() = default;

  /// Sets the distances between voxels for the normals of the next scans; without this call voxels
  /// are cubes. The `start` event passes the spacing to the stream. spacing_nm: along x, y, z;
  /// negative for a mirrored axis; Units: nanometres. Limit: not during a scan.
  void set_spacing(const int32_t (&spacing_nm)[3]) { this->intake().set_spacing(spacing_nm); }

  /// Bits have no gradient.
  PushResult push_bits(const uint8_t* bits) = delete;

 private:
  NormalExtractor(const NormalExtractor&) = default;
  NormalExtractor& operator=(const NormalExtractor&) = default;
};

template <class Sample>
using NormalExtractor16 = NormalExtractor<uint16_t, Sample>;
template <class Sample>
using NormalExtractor32 = NormalExtractor<uint32_t, Sample>;

}  // namespace discmc

#endif
