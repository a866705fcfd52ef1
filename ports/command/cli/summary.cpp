#include "summary.hpp"

#include <unistd.h>

#include <filesystem>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <system_error>

#include "files/output_file.hpp"
#include "mesh_files/file_format.hpp"
#include "samples/spacing.hpp"
#include "text/number_text.hpp"

namespace discmc::command {
namespace {

void row(std::ostream& out, const char* name, const std::string& value,
         const std::string& note = {}) {
  out << "  " << std::left << std::setw(26) << name << std::right << std::setw(14) << value;
  if (!note.empty()) out << "  " << note;
  out << '\n';
}

std::string ratio(std::uint64_t a, std::uint64_t b) {
  if (b == 0) return "-";
  const std::uint64_t tenths = (10 * a + b / 2) / b;
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

// Names what was too small, or returns an empty string.
std::string shortage(const Extraction& extraction, const MemoryUse& memory) {
  if (extraction.statistics.fragments == 0) return {};
  if (extraction.is_of_slab) return "at the seams, or for lack of memory";
  const bool lacked_holes = memory.peaks.holes == memory.capacities.holes;
  return std::string("the arena lacked slots") + (lacked_holes ? " or holes" : "");
}

// Uses the words of --space if they fit.
const char* space_name(Space space) {
  constexpr const char* names[] = {"scanner", "lps", "ras"};
  return names[static_cast<std::size_t>(space)];
}

void print_memory(const Extraction& extraction, std::ostream& out) {
  if (!extraction.memory) return;
  const MemoryUse& memory = *extraction.memory;
  row(out, "bytes of arena used", grouped(memory.arena_bytes_used),
      "of " + grouped(memory.arena_bytes));
  row(out, "  slots, peak", grouped(memory.peaks.slots), "of " + grouped(memory.capacities.slots));
  row(out, "  holes, peak", grouped(memory.peaks.holes), "of " + grouped(memory.capacities.holes));
  row(out, "loose fragments", grouped(extraction.statistics.fragments),
      shortage(extraction, memory));
}

void print_vector(const char* name, const std::array<double, 3>& vector, std::ostream& out) {
  out << name << ' ' << vector[0] << ' ' << vector[1] << ' ' << vector[2] << '\n';
}

}  // namespace

void print_place(const std::array<double, 3>& spacing_mm,
                 const std::optional<VolumePlacement>& placement, std::ostream& out) {
  const auto digits = out.precision(10);  // nanometres of the largest spacing
  print_vector("spacing", spacing_mm, out);
  out.precision(15);  // nanometres of the farthest origin
  const VolumePlacement place = placement ? *placement : along_coordinates(spacing_mm);
  out << "space " << (placement ? space_name(place.space) : "voxel") << '\n';
  print_vector("origin", place.origin_mm, out);
  print_vector("axis_x", place.axes_mm[0], out);
  print_vector("axis_y", place.axes_mm[1], out);
  print_vector("axis_z", place.axes_mm[2], out);
  out.precision(digits);
}

std::ostream& table_stream(const std::string& output) {
  return is_standard_output(output) ? std::cerr : std::cout;
}

void require_no_terminal(const std::string& output) {
  if (is_standard_output(output) && !traits_of(format_of(output)).is_text &&
      isatty(STDOUT_FILENO) == 1)
    throw std::invalid_argument("bytes are not written to a terminal; give -o FILE, or a pipe");
}

void print_file(const std::string& file, std::ostream& out) {
  if (is_standard_output(file)) return;
  std::error_code error;
  const std::uint64_t bytes = std::filesystem::file_size(file, error);
  out << file;
  if (!error) out << ": " << grouped(bytes) << " bytes";
  out << '\n';
}

void print_mesh_table(const MeshSummary& mesh, const Extraction& extraction, std::ostream& out) {
  row(out, mesh.faces.c_str(), grouped(mesh.face_count),
      "classic Marching Cubes: " + grouped(extraction.statistics.classic_triangles) + " triangles");
  if (mesh.vertex_count > 0) row(out, "vertices", grouped(mesh.vertex_count));
  if (mesh.is_closed) row(out, "closed", *mesh.is_closed ? "yes" : "no");
  print_memory(extraction, out);
}

void print_table(const Extraction& extraction, const Counts& counts, std::uint64_t stream_bytes,
                 std::uint64_t slice_encoder_bytes, std::ostream& out) {
  const Statistics& statistics = extraction.statistics;
  row(out, "voxels", grouped(extraction.voxels));
  row(out, "classic Marching Cubes", grouped(statistics.classic_triangles), "triangles");
  row(out, "facets", grouped(statistics.facets));
  row(out, "regions", grouped(counts.regions));
  row(out, "  with 3 corners", grouped(counts.of_three_corners));
  row(out, "  with 4 corners", grouped(counts.of_four_corners));
  row(out, "  with more", grouped(counts.of_more_corners));
  row(out, "holes", grouped(counts.holes));
  row(out, "triangles per polygon", ratio(statistics.classic_triangles, counts.regions));
  row(out, "bytes of stream", grouped(stream_bytes),
      ratio(stream_bytes, counts.regions) + " per region");
  if (slice_encoder_bytes > 0) {
    row(out, "bytes of slice encoder", grouped(slice_encoder_bytes));
    return;
  }
  print_memory(extraction, out);
}

void print_info(const StreamHeader& header, std::uint8_t channel,
                const std::vector<StreamHeader>& streams, const StreamReport& report,
                const Counts& counts, const std::optional<VolumePlacement>& placement,
                std::ostream& out) {
  out << "dimensions " << header.width << ' ' << header.height << ' '
      << (report.has_trailer ? report.slices : header.depth) << '\n';
  print_place(spacing_mm(header), placement, out);
  out << "wire " << (report.holds_slices ? "slices" : "regions") << '\n'
      << "scan " << header.scan << '\n'
      << "stream_channel " << int{channel} << '\n'
      << "threshold " << header.thresholds[channel - header.channel] << '\n'
      << "border " << (header.border == Border::closed ? "closed" : "open") << '\n'
      << "regions " << counts.regions << '\n'
      << "rings " << counts.rings << '\n'
      << "holes " << counts.holes << '\n'
      << "links " << counts.links << '\n'
      << "corners " << counts.corners << '\n'
      << "polygons_3 " << counts.of_three_corners << '\n'
      << "polygons_4 " << counts.of_four_corners << '\n'
      << "polygons_5plus " << counts.of_more_corners << '\n'
      << "normals " << counts.normals << '\n'
      << "fragments " << report.totals.fragments << '\n'
      << "skipped_rows " << report.totals.skipped_rows << '\n'
      << "lost_packets " << report.lost_packets << '\n'
      << "damaged_packets " << report.damaged_packets << '\n'
      << "lost_pieces " << report.lost_pieces << '\n'
      << "lost_rows " << report.lost_rows << '\n'
      << "repeated_packets " << report.repeated_packets << '\n'
      << "foreign_packets " << report.foreign_packets << '\n'
      << "mixed " << (report.is_mixed ? "yes" : "no") << '\n'
      << "bytes " << report.bytes << '\n'
      << "abandoned " << (report.is_abandoned ? "yes" : "no") << '\n'
      << "complete " << (report.is_complete() ? "yes" : "no") << '\n';
  for (const StreamHeader& stream : streams)
    for (std::uint32_t surface = 0; surface < stream.surface_count; ++surface)
      out << "surface scan " << stream.scan << " channel " << stream.channel + surface
          << " threshold " << stream.thresholds[surface] << '\n';
}

}  // namespace discmc::command
