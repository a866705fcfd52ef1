// discmc: slices of a 3D scanner in, merged surfaces out, on the scanner.
//
// Everything that firmware needs. Hosts also include host/host_extractor.hpp. docs/map.md shows
// the path of the data through the headers; each header is the reference of its part.
#ifndef DISCMC_DISCMC_HPP
#define DISCMC_DISCMC_HPP

#include <discmc/version.h>
#include <discmc/byte_output.hpp>
#include <discmc/checkpoint_store.hpp>
#include <discmc/decoder.hpp>
#include <discmc/encoder.hpp>
#include <discmc/extractor.hpp>
#include <discmc/front/downsampler.hpp>
#include <discmc/front/majority_filter.hpp>
#include <discmc/front/packed_samples.hpp>
#include <discmc/front/row_cropper.hpp>
#include <discmc/front/row_ring.hpp>
#include <discmc/front/threshold_row.hpp>
#include <discmc/gradient_normals.hpp>
#include <discmc/joiner.hpp>
#include <discmc/placement.hpp>
#include <discmc/polygon.hpp>
#include <discmc/sample_window.hpp>
#include <discmc/slice_encoder.hpp>
#include <discmc/surface_decoder.hpp>
#include <discmc/surface_group.hpp>

#endif
