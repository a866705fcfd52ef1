// discmc: slices of a 3D scanner in, merged surfaces out, on the scanner.
//
// The headers in data-flow order; each is the manual of its part:
//
//   limits.hpp            how large a scan may be
//   capacities.hpp        what memory it takes
//   row_ring.hpp          rows from an interrupt to a task
//   packed_samples.hpp    samples of 10 and 12 bits, unpacked
//   row_picker.hpp        a part of what the sensor sees, or every Nth voxel of it
//   block_means.hpp       fewer and larger voxels
//   threshold_row.hpp     rows of bits, with a threshold for each row or column
//   majority_filter.hpp   bits without noise
//   row_input.hpp         what push() and skip_row() of all scanners have in common
//   extractor.hpp         samples in, regions out: what firmware meets
//     learning_extractor.hpp  the same for hosts, with memory to learn in; not included here
//     gradient_normals.hpp    with normals
//   sink.hpp              the events that come out: regions, rings, runs, loose fragments
//   chain.hpp, polygon.hpp  Freeman chains and the polygons they are
//   encoder.hpp           a sink that writes the stream (WIRE.md)
//     byte_output.hpp         where its bytes go
//     stream_header.hpp       what it says of the scan
//     application_record.hpp, placement.hpp  the user's own data in it, and where the volume lies
//     slab_range.hpp                   which slices of a volume it is of
//   checkpoint.hpp        extractor and encoder as bytes that survive a power failure
//     checkpoint_store.hpp    in flash, the newest whole one of several
//     flash_device.hpp        the driver's part of it
//   decoder.hpp           bytes of a stream in, the same events out
//     stream_report.hpp       what arrived, and what did not
//   records_packet.hpp    packets that pass from an encoder or a decoder to another encoder
//   slice_encoder.hpp     samples in, a stream of their bits out: a tenth of the bytes, and whoever
//                         receives it extracts the surface
//     key_slices.hpp          where it can be begun, and what memory it takes
//   slice_decoder.hpp     rows of bits out of it
//   surface_decoder.hpp   bytes of either stream in, the same events out
//   surface_group.hpp, shared_output.hpp  several surfaces of one scan, over one link
//   joiner.hpp            loose fragments of one stream or several in, regions out
//   normal.hpp            normals in fixed point, of facets, gradients and polygons
//   sample_window.hpp     normals of polygons that are there already, in a second pass
//   cell.hpp, facet_table.hpp  the geometry of a cell, for tools and tests
//   version.hpp           which version this is
//
// Everywhere: lattice.hpp (coordinates in half-steps, links, incidences), plane.hpp, status.hpp,
// arena.hpp, pool.hpp, compiler.hpp.
//
// They say of a function or a value, where there is something to say:
//
//   Owner:   whose the memory is that a pointer leads to, and how long it must stay
//   Units:   what a number counts
//   Limit:   what must hold; it is checked only where an error or is_valid() says so
//   Errors:  which Status comes of what; `ok` and `more` are none
//   Cost:    how the work grows with what
//
// The namespace has short names (Link, Run, Event, Memory) and namespaces (trace, wire, slices):
// where yours are alike, write discmc:: instead of `using namespace discmc`.
//
// Behind the extractor works trace/, in data-flow order:
//
//   intake.hpp, sample_rows.hpp       where samples come in, and are kept for normals
//   threshold.hpp, bit_rows.hpp       samples become bits
//     vector.hpp, vector_threshold.hpp  many at once, on hosts
//   swept_row.hpp, neighbourhood.hpp  crossing edges, and the voxels around them
//   sector_table.hpp, passes.hpp      which chains pass a vertex; derived_passes.hpp finds them
//     loop_facets.hpp                 from the facets of a cell
//   sweep.hpp                         hands them on to
//   fragments.hpp, queues.hpp         pieces of chains, and their ends that wait
//     records.hpp, run_list.hpp       what they are kept in
//   delivery.hpp, holes.hpp           rings, grouped into regions, to the sink
//   seams.hpp                         for slabs
//   corner_sweep.hpp                  what hosts do faster:
//     learnt_passes.hpp                 passes that are remembered,
//     numbered_passes.hpp               by their numbers,
//     corners.hpp, corner.hpp           and fragments as lists of corners,
//     corner_pass.hpp                   which passes lengthen
//   extractor_definitions.hpp         what is compiled of all this, for each kind of extractor
//
// Behind encoder and decoder works stream/:
//
//   wire.hpp                                     packets: cobs.hpp frames, crc32.hpp protects them
//     packet_writer.hpp, packet_reader.hpp         written and read, whatever they hold
//   record.hpp, record_encoding.hpp              what they hold
//     region_model.hpp, range_coder.hpp            in few bits
//   normal_encoding.hpp                          and the normals in it
//
// Behind the encoder and the decoder of slices works slices/:
//
//   surfaces.hpp                           rows of several surfaces
//   row_code.hpp, row_coders.hpp           a row, voxel by voxel and run by run
//     slice_model.hpp                        by what is learnt of its neighbours
//
// And behind the joiner join/:
//
//   waiting_chains.hpp, waiting_table.hpp  what waits for the fragments before and behind it
//     held_chains.hpp                        what chains are kept in
//   region_holes.hpp                       which holes lie in a region
//
// discmc.h, for C, has its implementation in c/: object.hpp (where objects lie and how they are
// saved), values.hpp (values and sinks of C), and extractor_kind.hpp and encoder_kind.hpp.
#ifndef DISCMC_DISCMC_HPP
#define DISCMC_DISCMC_HPP

#include <discmc/checkpoint_store.hpp>
#include <discmc/decoder.hpp>
#include <discmc/encoder.hpp>
#include <discmc/extractor.hpp>
#include <discmc/front/block_means.hpp>
#include <discmc/front/majority_filter.hpp>
#include <discmc/front/packed_samples.hpp>
#include <discmc/front/row_picker.hpp>
#include <discmc/front/row_ring.hpp>
#include <discmc/front/threshold_row.hpp>
#include <discmc/geometry/facet_table.hpp>
#include <discmc/joiner.hpp>
#include <discmc/placement.hpp>
#include <discmc/polygon.hpp>
#include <discmc/sample_window.hpp>
#include <discmc/shared_output.hpp>
#include <discmc/slab_range.hpp>
#include <discmc/slice_encoder.hpp>
#include <discmc/surface_decoder.hpp>
#include <discmc/surface_group.hpp>
#include <discmc/version.hpp>

#endif
