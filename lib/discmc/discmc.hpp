// discmc: extracts the surface of a 3D scan on the scanner's own microcontroller, while the scan
// runs.
//
//   samples -> Extractor -> Encoder -> your link        regions: the receiver only draws
//   samples -> SliceEncoder -> your link                thresholded slices: a tenth of the bytes
//   your link -> Receiver -> Joiner -> your sink        regions, from a stream of either kind
//
// You supply all memory. The library uses no heap, no floating point, no exceptions and no global
// state. examples/firmware.cpp sends regions, and examples/link.cpp receives streams of either
// kind.
//
// This file includes everything that firmware and receivers need. Each header is the reference of
// its part. Programs on a PC that want meshes include mesh.hpp of the mesh library instead
// (docs/cpp.md). Four documents belong to all:
//
//   docs/README.md     the way through the headers
//   docs/concepts.md   the terms
//   docs/statuses.md   the cause and the remedy of each Status
//   docs/front-end.md  rows from the sensor, and what may be called from where
//
// Comments use five words:
//
//   Owner    who owns the memory behind a pointer, and for how long
//   Units    the unit of a number
//   Limit    a condition for you to keep: nothing checks it, unless Errors or is_valid() is named
//   Errors   the statuses that a call can return, besides ok and suspended
//   Cost     work, memory or bytes of stream
#ifndef DISCMC_DISCMC_HPP
#define DISCMC_DISCMC_HPP

#include <discmc/version.h>
#include <discmc/byte_output.hpp>
#include <discmc/checkpoint_store.hpp>
#include <discmc/decoder.hpp>
#include <discmc/encoder.hpp>
#include <discmc/extractor.hpp>
#include <discmc/fraction.hpp>
#include <discmc/fraction_slice_encoder.hpp>
#include <discmc/front/downsampler.hpp>
#include <discmc/front/majority_filter.hpp>
#include <discmc/front/packed_samples.hpp>
#include <discmc/front/row_cropper.hpp>
#include <discmc/front/row_ring.hpp>
#include <discmc/front/threshold_row.hpp>
#include <discmc/joiner.hpp>
#include <discmc/normal_extractor.hpp>
#include <discmc/placement.hpp>
#include <discmc/polygon.hpp>
#include <discmc/receiver.hpp>
#include <discmc/sample_window.hpp>
#include <discmc/slice_encoder.hpp>
#include <discmc/surface_group.hpp>

#endif
