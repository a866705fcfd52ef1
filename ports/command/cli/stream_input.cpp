#include "stream_input.hpp"

#include <discmc/placement.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "commands.hpp"
#include "mesh_output.hpp"
#include "progress.hpp"
#include "samples/spacing.hpp"
#include "streams/application_text.hpp"
#include "streams/slab_ranges.hpp"
#include "surface/joined_surface.hpp"
#include "text/message.hpp"
#include "volumes/format_list.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {
namespace {

// Lists the surfaces of a link by scan, channel and threshold.
std::vector<std::string> list_of_surfaces(const StreamReader& reader) {
  std::vector<std::string> list;
  for (const StreamHeader& header : reader.headers())
    for (std::uint32_t surface = 0; surface < header.surface_count; ++surface)
      list.push_back("scan " + std::to_string(header.scan) + " channel " +
                     std::to_string(header.channel + surface) + " (threshold " +
                     std::to_string(header.thresholds[surface]) + ")");
  return list;
}

std::string joined(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& item : list) text += (text.empty() ? "" : ", ") + item;
  return text;
}

// Keeps the application records of a stream, with the placement of its volume, and passes events to
// the next sink.
struct RecordNotes {
  JoinedSurface& surface;
  std::vector<std::string> records{};
  std::optional<VolumePlacement> placement{};
  SlabRanges slabs{};
  SentFractions fractions{};
  SinkResult accept(const Event& event) {
    fractions.accept(event);
    if (event.kind == Event::Kind::application) {
      records.push_back(text(*event.application));
      Placement nanometres;
      if (read_placement(*event.application, nanometres)) placement = in_millimetres(nanometres);
      SlabRange range;
      if (read_slab_range(*event.application, range)) slabs.add(range);
    }
    return surface.accept(event);
  }
};

// Throws for an input that is not a stream; the message names the command that accepts it.
void refuse_other_kinds(const std::string& path) {
  if (is_volume_name(path))
    throw std::runtime_error(
        path + ": this is a volume, not a stream; give it to discmc extract, info or render");
  if (is_mesh_name(path))
    throw std::runtime_error(path + ": this is a mesh, not a stream; " + commands_for_meshes);
}

// Opens a file; standard input is opened elsewhere.
std::ifstream opened(const std::string& path) {
  if (!std::filesystem::exists(path))
    throw std::runtime_error(path + ": there is no such file; check the name");
  std::ifstream file;
  if (!std::filesystem::is_directory(path))
    file.open(path, std::ios::binary);
  else
    refuse_other_kinds(path);
  if (!file.is_open())
    throw std::runtime_error(path + ": the file cannot be read; check its permissions");
  return file;
}

// size: of the stream, or 0 if unknown.
void read_stream(const std::string& path, std::istream& in, std::uint64_t size,
                 StreamReader& reader) {
  Progress progress(size > 0 ? "reading" : "reading byte", size);
  try {
    reader.read(in, [&progress](std::uint64_t bytes) { progress.show(bytes); });
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
  if (reader.report().has_header) return;
  if (!reader.headers().empty())
    throw std::runtime_error(path + ": the stream has no such surface; choose one of " +
                             joined(list_of_surfaces(reader)));
  refuse_other_kinds(path);
  throw std::runtime_error(display_name(path) + ": there is no header of a discmc stream in its " +
                           std::to_string(reader.report().bytes) +
                           " bytes, and no known volume; give a .dmc file or a volume, or "
                           "headerless samples with --dims and --type" +
                           (path == "-" ? "; a mesh is read from a file only: save it, and give "
                                          "its name to discmc compare, render or view"
                                        : ""));
}

// read: called with the reader.
template <class Read>
DecodedStream decoded_by(Read read, const std::string& path, const StreamChoice& choice,
                         Kept kept) {
  JoinedSurface joined(kept);
  RecordNotes notes{joined};
  StreamReader reader(make_sink(notes), choice);
  read(reader);
  note_others(path, choice, reader);
  if (!notes.slabs.missing().empty())
    print_message(path, "the stream holds only the " + text(notes.slabs.ranges()) + " of " +
                            std::to_string(notes.slabs.ranges()[0].depth) +
                            "; join it with the other slabs by discmc join");
  joined.finish();
  joined.surface().spacing_mm = spacing_mm(reader.header());
  if (notes.placement && !is_usable(*notes.placement)) {
    print_message(path,
                  "the placement in the stream is ignored, because its axes span no space; "
                  "coordinates are those of voxels");
    notes.placement.reset();
  }
  StreamReport report = reader.report();
  report.lost_pieces += joined.builder().incomplete_regions();
  return {reader.header(),
          reader.dims(),
          reader.channel(),
          reader.headers(),
          report,
          std::move(joined.surface()),
          joined.builder().counts(),
          std::move(notes.records),
          notes.placement,
          std::move(notes.fractions)};
}

// Example: "3 packets are missing, 100 rows are missing; send or copy the stream again".
std::string losses(const StreamReport& report) {
  const char* const pieces = report.holds_slices ? " rows" : " regions or fragments";
  const std::uint64_t lost = report.holds_slices ? report.lost_rows : report.lost_pieces;
  const std::uint64_t received =
      report.holds_slices ? report.rows : report.regions + report.fragments;
  const std::uint64_t sent =
      report.holds_slices ? report.total_rows : report.totals.regions + report.totals.fragments;
  std::string text;
  const auto add = [&](const std::string& loss) { text += (text.empty() ? "" : ", ") + loss; };
  if (report.lost_packets > 0)
    add(std::to_string(report.lost_packets) +
        (report.lost_packets == 1 ? " packet is missing" : " packets are missing"));
  if (lost > 0) add(std::to_string(lost) + pieces + " are missing");
  if (!report.has_trailer) add("the end is missing after " + std::to_string(received) + pieces);
  if (report.is_unreadable) add("a packet has contents that this version cannot read");
  if (text.empty() && !report.is_mixed)
    add(std::to_string(received) + pieces + " arrived, and the trailer counts " +
        std::to_string(sent));
  if (report.is_mixed) {
    add("packets of two scans with the same number are mixed");
    return text + "; give every scan another number";
  }
  // A stream that only lacks pieces may be one slab of several.
  const bool is_loss = report.lost_packets > 0 || !report.has_trailer || lost == 0;
  return text + (is_loss ? "; send or copy the stream again" : "");
}

}  // namespace

void read_file(const std::string& path, StreamReader& reader) {
  if (path == "-") return read_stream(path, std::cin, 0, reader);
  std::ifstream file = opened(path);
  const bool has_size = std::filesystem::is_regular_file(path);
  read_stream(path, file, has_size ? std::filesystem::file_size(path) : 0, reader);
}

std::string stream_bytes(const std::string& path) {
  std::ifstream file;
  if (path != "-") file = opened(path);
  std::istream& in = path == "-" ? std::cin : file;
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void note_others(const std::string& path, const StreamChoice& choice, const StreamReader& reader) {
  const std::vector<std::string> surfaces = list_of_surfaces(reader);
  if (surfaces.size() < 2 || !choice.is_any()) return;
  print_message(path, "this is scan " + std::to_string(reader.header().scan) + " channel " +
                          std::to_string(reader.channel()) + " of " + joined(surfaces) +
                          "; choose with --scan N and --stream-channel N");
}

void require_one_surface(const std::string& path, const StreamReader& reader) {
  const std::vector<std::string> surfaces = list_of_surfaces(reader);
  if (surfaces.size() > 1)
    throw std::runtime_error(
        path + ": the stream holds " + joined(surfaces) +
        ", and join accepts one surface per stream; give streams with one surface");
}

DecodedStream decode_surface(const std::string& path, const StreamChoice& choice, Kept kept) {
  return decoded_by([&](StreamReader& reader) { read_file(path, reader); }, path, choice, kept);
}

DecodedStream decode_surface(const std::string& path, std::istream& in,
                             const StreamChoice& choice) {
  return decoded_by([&](StreamReader& reader) { read_stream(path, in, 0, reader); }, path, choice,
                    Kept::polygons);
}

std::optional<Crossings> crossings_of(const std::string& path, const DecodedStream& decoded,
                                      SurfaceKind surface, double tolerance) {
  if (surface == SurfaceKind::merged) return std::nullopt;
  if (surface == SurfaceKind::interpolated && !decoded.fractions.are_sent())
    throw std::invalid_argument(path +
                                ": the stream holds no fractions to interpolate; give --surface "
                                "relaxed, or extract it with --wire slices --levels 4");
  Crossings crossings(decoded.dims, decoded.surface.polygons);
  decoded.fractions.place(crossings);
  if (surface == SurfaceKind::relaxed)
    relax_noted(crossings, decoded.surface, decoded.header.border, tolerance);
  return crossings;
}

void note_empty(const std::string& path, const DecodedStream& decoded) {
  if (decoded.report.is_complete() && decoded.surface.polygons.empty())
    print_message(path, "the stream holds no polygon; extract it with another threshold");
}

int completeness(const std::string& path, const StreamReport& report) {
  if (report.is_complete()) return exit_ok;
  print_message(path, "the stream is incomplete: " + losses(report));
  return exit_incomplete;
}

}  // namespace discmc::command
