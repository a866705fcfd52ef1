// discmc: slices of a 3D scanner in, merged surfaces out, on the scanner.
//
// The headers in data-flow order; each is the manual of its part:
//
//   limits.hpp            how large a scan may be
//   capacities.hpp        what memory it takes
//   extractor.hpp         samples in, regions out: what firmware meets
//     learning_extractor.hpp  the same for hosts, with memory to learn in; not included here
//     intake.hpp            where samples come in; gradient_normals.hpp keeps them for normals
//   sink.hpp              the events that come out: regions, rings, runs, loose fragments
//   chain.hpp, polygon.hpp  Freeman chains and the polygons they are
//   encoder.hpp           a sink that writes the stream (wire.hpp, WIRE.md)
//   checkpoint.hpp        extractor and encoder as bytes that survive a power failure
//   decoder.hpp           bytes of a stream in, the same events out
//   joiner.hpp            loose fragments of one stream or several in, regions out
//     held_chains.hpp, waiting_chains.hpp, waiting_table.hpp, region_holes.hpp, plane.hpp
//   normal.hpp            normals in fixed point, of facets, gradients and polygons
//   sample_window.hpp     normals of polygons that are there already, in a second pass
//   cell.hpp, facet_table.hpp  the geometry of a cell, for tools and tests
//
// Everywhere: lattice.hpp (coordinates in half-steps, links, incidences), status.hpp, arena.hpp.
// Behind the extractor works trace/: bit rows, sectors, passes, queues, fragments, holes.
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
