// discmc: slices of a 3D scanner in, merged surfaces out, on the scanner.
//
// The headers in the way of the data; each is the manual of its part:
//
//   limits.hpp            how large a scan may be and what memory it takes
//   extractor.hpp         samples in, regions out: what firmware meets
//     slice.hpp             samples become rows of bits; active cells
//     cell.hpp              a cell's corners, points and loops
//     facet_table.hpp       the facets of each configuration
//     patch_table.hpp       the same as the sweep works with them
//     frontier.hpp          what waits for cells to come
//     merge.hpp             patches become regions (regions.hpp, fragment_store.hpp)
//     arena.hpp, pool.hpp, hash_table.hpp   where all of it is kept
//     gradient_normals.hpp  the normals of corners, from the samples (sample_rows.hpp)
//   sink.hpp              the events that come out: regions, rings, runs
//   chain.hpp, polygon.hpp  Freeman chains and the polygons they are
//   encoder.hpp           a sink that writes the stream (wire.hpp, WIRE.md)
//   checkpoint.hpp        both of them as bytes that survive a power failure
//     record.hpp, region_model.hpp, record_encoding.hpp, normal_encoding.hpp, range_coder.hpp,
//     cobs.hpp, crc32.hpp
//   decoder.hpp           bytes of a stream in, the same events out
//   joiner.hpp            loose fragments of one stream or several in, regions out
//     held_chains.hpp, waiting_chains.hpp, waiting_table.hpp, region_holes.hpp, plane.hpp
//   normal.hpp            normals in fixed point, of facets, gradients and polygons
//   sample_window.hpp     the normals of polygons that are there already, in a second pass
//
// Everywhere: lattice.hpp (coordinates in half-steps, links, incidences) and status.hpp.
#ifndef DISCMC_DISCMC_HPP
#define DISCMC_DISCMC_HPP

#include <discmc/decoder.hpp>
#include <discmc/encoder.hpp>
#include <discmc/extractor.hpp>
#include <discmc/facet_table.hpp>
#include <discmc/joiner.hpp>
#include <discmc/polygon.hpp>
#include <discmc/sample_window.hpp>

#endif
