// VTK's image in pieces: an XML file that lists other images (vti_reader.cpp) and their extents.
// Neighbouring pieces share the points of their border, or more points as ghosts.
#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include <pugixml.hpp>

#include "volumes/formats/readers.hpp"
#include "volumes/formats/vtk_image.hpp"
#include "volumes/header_fields.hpp"

namespace discmc::command {
namespace {

struct Piece {
  std::filesystem::path file;
  VtkExtent extent;
  std::array<std::uint32_t, 3> first{}, dims{};  // in voxels of the whole
  std::unique_ptr<VolumeReader> volume = {};     // while its slices are read
  std::uint32_t next = 0;                        // its next slice

  std::uint32_t end(std::size_t axis) const { return first[axis] + dims[axis]; }
  bool has_slice(std::uint32_t z) const { return first[2] <= z && z < end(2); }
};

class PiecesVolume final : public NumberedSlices {
 public:
  /// info: of the whole. options: of the pieces. Throws unless all pieces can be opened and match.
  PiecesVolume(std::filesystem::path file, VolumeInfo info, std::vector<Piece> pieces,
               VolumeOptions options)
      : NumberedSlices(std::move(file), std::move(info)),
        pieces_(std::move(pieces)),
        options_(std::move(options)) {
    std::stable_sort(pieces_.begin(), pieces_.end(),
                     [](const Piece& a, const Piece& b) { return a.first[0] < b.first[0]; });
    for (const Piece& piece : pieces_) {
      const auto volume = opened(piece);
      for (const std::string& text : volume->notes()) note(own_info(), text);
    }
    require_covered(0);
  }

 private:
  void read(std::uint32_t slice, void* samples) override {
    require_covered(slice);
    for (Piece& piece : pieces_)
      if (piece.has_slice(slice)) copy_piece(piece, slice, static_cast<unsigned char*>(samples));
  }

  std::unique_ptr<VolumeReader> opened(const Piece& piece) const {
    auto volume = open_vti(open_content(piece.file), options_);
    const auto text = [&](const std::array<std::uint32_t, 3>& dims, const VolumeInfo& info) {
      return extents(dims) + " voxels of " + std::to_string(info.channels) + " x " +
             std::string(name(info.type));
    };
    const std::string found = text(volume->info().dims, volume->info());
    const std::string expected = text(piece.dims, info());
    if (found != expected)
      fail(piece.file, "the piece has " + found + ", not the " + expected + " of the whole",
           "write all pieces again");
    return volume;
  }

  // Throws if a voxel of the slice is in no piece. Pieces are sorted by x.
  void require_covered(std::uint32_t slice) const {
    std::vector<std::uint32_t> ends(info().dims[1]);  // covered part of each row
    for (const Piece& piece : pieces_) {
      if (!piece.has_slice(slice)) continue;
      for (std::uint32_t y = piece.first[1]; y < piece.end(1); ++y)
        if (piece.first[0] <= ends[y]) ends[y] = std::max(ends[y], piece.end(0));
    }
    for (std::uint32_t y = 0; y < info().dims[1]; ++y)
      if (ends[y] < info().dims[0])
        fail(source(),
             "no piece holds voxel (" + std::to_string(ends[y]) + ", " + std::to_string(y) + ", " +
                 std::to_string(slice) + ")",
             "write it again with all pieces");
  }

  void copy_piece(Piece& piece, std::uint32_t slice, unsigned char* samples) {
    if (!piece.volume) piece.volume = opened(piece);
    for (; piece.first[2] + piece.next < slice; ++piece.next) piece.volume->skip_slice();
    bytes_.resize(piece.volume->info().slice_bytes());
    piece.volume->read_slice(bytes_.data());
    ++piece.next;
    const std::size_t size = sample_bytes(info().type), row = piece.dims[0] * size;
    for (std::size_t y = 0; y < piece.dims[1]; ++y)
      std::memcpy(samples + ((piece.first[1] + y) * info().dims[0] + piece.first[0]) * size,
                  bytes_.data() + y * row, row);
    if (slice + 1 == piece.end(2)) piece.volume.reset();
  }

  std::vector<Piece> pieces_;
  VolumeOptions options_;
  std::vector<unsigned char> bytes_;  // a slice of a piece
};

VtkExtent extent_of(const std::filesystem::path& file, const pugi::xml_node& node,
                    const char* name) {
  return vtk_extent(file, name, reals(file, name, node.attribute(name).value()));
}

// Returns the pieces that hold samples. If an image has fewer pieces than processes, the others are
// empty.
std::vector<Piece> pieces_of(const std::filesystem::path& file, const pugi::xml_node& image,
                             const VtkExtent& whole) {
  std::vector<Piece> found;
  for (const pugi::xml_node& node : image.children("Piece")) {
    const VtkExtent extent = extent_of(file, node, "Extent");
    bool is_empty = false, is_inside = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      is_empty = is_empty || vtk_size(extent, axis, false) < 1;
      is_inside = is_inside && whole[2 * axis] <= extent[2 * axis] &&
                  extent[2 * axis + 1] <= whole[2 * axis + 1];
    }
    if (is_empty) continue;
    if (!is_inside)
      fail(file,
           "the piece of Extent " + shown(node.attribute("Extent").value()) +
               " is outside of WholeExtent",
           "write it again");
    const std::string_view name = node.attribute("Source").value();
    found.push_back({beside(file, name), extent});
    if (!is_file(found.back().file))
      fail(file, "the piece " + shown(name) + " is missing", "copy it to the folder of this file");
  }
  if (found.empty()) fail(file, "it lists no pieces", "write it again with all pieces");
  return found;
}

}  // namespace

std::unique_ptr<VolumeReader> open_pvti(ByteStream stream, const VolumeOptions& options) {
  const std::filesystem::path file = stream.file();
  constexpr std::size_t max_bytes = 1 << 20;
  const std::string_view text = stream.peek(max_bytes);
  pugi::xml_document document;
  document.load_buffer(text.data(), text.size());
  const pugi::xml_node image = document.child("VTKFile").child("PImageData");
  if (!image)
    fail(file, "this lists no pieces of an image (PImageData)", "write it again as .pvti");
  const VtkExtent whole = extent_of(file, image, "WholeExtent");
  std::vector<Piece> pieces = pieces_of(file, image, whole);

  // VTK writes the directions only into the pieces.
  VolumeInfo info = open_vti(open_content(pieces[0].file), options)->info();
  const bool is_of_cells = info.dims[0] != vtk_size(pieces[0].extent, 0, false);
  const auto size = [&](std::size_t axis) { return vtk_size(whole, axis, is_of_cells); };
  set_dims(info, file, {size(0), size(1), size(2)});
  for (Piece& piece : pieces)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      piece.first[axis] = static_cast<std::uint32_t>(piece.extent[2 * axis] - whole[2 * axis]);
      piece.dims[axis] = static_cast<std::uint32_t>(vtk_size(piece.extent, axis, is_of_cells));
    }
  const auto& first = pieces[0].first;
  set_part(info, file, info.dims, {-1.0 * first[0], -1.0 * first[1], -1.0 * first[2]}, 1);
  info.whole_dims.reset();
  info.format += ", in pieces";
  return std::make_unique<PiecesVolume>(file, std::move(info), std::move(pieces), options);
}

}  // namespace discmc::command
