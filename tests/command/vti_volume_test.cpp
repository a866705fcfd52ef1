// VTK's image in XML: cases that the files of other programs lack (container_table_test.cpp).
#include "volume_files.hpp"

namespace {

using namespace volume_files;

const std::string length("\x3c\0\0\0", 4);  // of the samples

std::string vti(const std::string& root, const std::string& image, const std::string& points,
                const std::string& behind) {
  return "<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\" " + root + "><ImageData " +
         image + "><Piece Extent=\"0 4 0 2 0 3\"><PointData " + points +
         "</PointData></Piece></ImageData>" + behind + "</VTKFile>";
}

const std::string whole = "WholeExtent=\"0 4 0 2 0 3\"";
const std::string appended_array = "<DataArray type=\"UInt8\" format=\"appended\" offset=\"3\"/>";
const std::string appended = "<AppendedData encoding=\"raw\">\n _???" + length + u8;

}  // namespace

TEST_CASE_FIXTURE(Folder, "VTK XML with several arrays is read from the array that Scalars names") {
  const std::string first =
      "<DataArray type=\"Int16\" Name=\"a\" format=\"ascii\">1 2 3</DataArray>";
  const std::string second =
      "<DataArray type=\"UInt8\" Name=\"b\" format=\"appended\" offset=\"3\"/>";
  check_volume(write("v.vti", vti("", whole, "Scalars=\"b\">" + first + second, appended)),
               "VTK XML, raw");
  check_volume(
      write("v", "<?xml version=\"1.0\"?>" + vti("", whole, ">" + appended_array, appended)),
      "VTK XML, raw");
}

TEST_CASE_FIXTURE(
    Folder, "the first voxel of VTK's XML is placed correctly for any first index of the extent") {
  const std::string file =
      vti("", whole + " Origin=\"1 2 3\" Spacing=\"2 3 4\" Direction=\"0 -1 0 1 0 0 0 0 1\"",
          ">" + appended_array, appended);
  const VolumeInfo info =
      read_info(write("v.vti", replaced_all(file, "0 4 0 2 0 3", "5 9 0 2 -1 2")));
  check_axes(info, {{{0, 2, 0}, {-3, 0, 0}, {0, 0, 4}}}, {1, 12, -1});
}

TEST_CASE_FIXTURE(Folder, "cell data of VTK's XML is placed between the points") {
  const std::string place = " Origin=\"1 2 3\" Spacing=\"2 3 4\" Direction=\"0 -1 0 1 0 0 0 0 1\"";
  const std::string file = vti("", whole + place, ">" + appended_array, appended);
  const auto cells = write(
      "cells.vti",
      replaced_all(replaced_all(file, "0 4 0 2 0 3", "0 5 0 3 0 4"), "PointData", "CellData"));
  check_volume(cells, "VTK XML, raw");
  CHECK(read_info(cells).placement->origin_mm == Vector{-0.5, 3, 5});
  // Arrays at points have priority over those of cells.
  const std::string of_cells =
      "<CellData><DataArray type=\"Int16\" Name=\"c\" format=\"appended\" "
      "offset=\"70\"/></CellData>";
  std::string both = vti("", whole, ">" + appended_array, appended);
  both.insert(both.find("<PointData"), of_cells);
  check_volume(write("both.vti", both), "VTK XML, raw");
  CHECK(noted(read_info(path() / "both.vti"), "others are left out: 'c'"));
}

TEST_CASE_FIXTURE(Folder, "in VTK's XML an axis of negative spacing runs backwards") {
  const std::string place = " Origin=\"1 2 3\" Spacing=\"2 -3 4\" ";
  const auto info = [&](const std::string& direction) {
    return read_info(
        write("v.vti", vti("", whole + place + direction, ">" + appended_array, appended)));
  };
  const VolumeInfo turned = info("Direction=\"0 -1 0 1 0 0 0 0 1\"");
  REQUIRE(turned.placement);
  CHECK(turned.placement->axes_mm == Axes{{{0, 2, 0}, {3, 0, 0}, {0, 0, 4}}});
  CHECK(turned.spacing_mm[0] * turned.spacing_mm[1] * turned.spacing_mm[2] == -24);
  CHECK(info("").placement->axes_mm == Axes{{{2, 0, 0}, {0, -3, 0}, {0, 0, 4}}});
  check_refused(write("v.vti", vti("", whole + place + "Direction=\"1 0 0 1\"",
                                   ">" + appended_array, appended)),
                "Direction is '1 0 0 1', which is not 9 numbers");
}

TEST_CASE_FIXTURE(Folder, "a rectilinear grid with even steps in VTK's XML is read as a volume") {
  const auto text = [](const std::string& numbers) {
    return "<DataArray type=\"Float64\" format=\"ascii\">" + numbers + "</DataArray>";
  };
  const auto grid = [&](const std::string& samples, const std::string& coordinates,
                        const std::string& behind) {
    std::string file = vti("", whole, samples, behind);
    file.insert(file.find("</Piece>"), "<Coordinates>" + coordinates + "</Coordinates>");
    return replaced_all(file, "ImageData", "RectilinearGrid");
  };
  std::string numbers;
  for (const char sample : u8) numbers += std::to_string(static_cast<unsigned char>(sample)) + ' ';
  const std::string inline_samples =
      "><DataArray type=\"UInt8\" format=\"ascii\">" + numbers + "</DataArray>";
  const std::string yz = text("3 3.5 4") + text("1 5 9 13");
  const auto even = write("v.vtr", grid(inline_samples, text("-2 0 2 4 6") + yz, ""));
  check_volume(even, "VTK XML, text");
  const VolumeInfo info = read_info(even);
  CHECK(info.spacing_mm == Spacing{2, 0.5, 4});
  CHECK(info.placement->origin_mm == Vector{-2, 3, 1});

  // Appended data follow the samples.
  const std::string array = "<DataArray type=\"UInt8\" format=\"appended\" offset=\"";
  const auto bytes = [](const std::string& values) {
    return std::string(1, static_cast<char>(values.size())) + std::string(3, '\0') + values;
  };
  check_volume(
      write("appended.vtr",
            grid(">" + appended_array, array + "67\"/>" + array + "76\"/>" + array + "83\"/>",
                 appended + bytes("\1\2\3\4\5") + bytes("\2\4\6") + bytes("\1\2\3\4"))),
      "VTK XML, raw");
  CHECK(read_info(path() / "appended.vtr").spacing_mm == Spacing{1, 2, 1});

  check_refused(write("v.vtr", grid(inline_samples, text("0 1 2 3 9") + yz, "")),
                "the coordinates of the axis 'x' are uneven, from 0 to 9");
}

namespace {

// The test volume in two pieces with a common plane of points: x from 0 to 2, and from 2 to 4.
class Pieces {
 public:
  Pieces() {
    write_piece("left.vti", 0, "UInt8");
    write_piece("right.vti", 2, "UInt8");
  }
  const Folder& folder() const { return folder_; }
  fs::path write(const std::string& pieces, const std::string& extent = "5 9 0 2 -1 2") const {
    return folder_.write("v.pvti", "<VTKFile type=\"PImageData\"><PImageData WholeExtent=\"" +
                                       extent + "\" Origin=\"1 2 3\" Spacing=\"2 3 4\">" + pieces +
                                       "</PImageData></VTKFile>");
  }
  static std::string piece(const std::string& extent, const std::string& source) {
    return "<Piece Extent=\"" + extent + "\" Source=\"" + source + "\"/>";
  }
  // As signed samples, these have other values.
  void write_piece(const std::string& name, int first, const std::string& type,
                   int components = 1) const {
    const std::string extent =
        std::to_string(5 + first) + " " + std::to_string(7 + first) + " 0 2 -1 2";
    std::string samples;
    for (int voxel = 0; voxel < voxels; ++voxel)
      if (voxel % 5 >= first && voxel % 5 <= first + 2)
        for (int i = 0; i < components; ++i)
          samples += std::to_string(static_cast<int>(sample_at(voxel, SampleType::u8)) + i) + ' ';
    folder_.write(name,
                  "<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\"><ImageData "
                  "WholeExtent=\"" +
                      extent +
                      "\" Origin=\"1 2 3\" Spacing=\"2 3 4\" Direction=\"0 -1 0 1 0 0 0 0 1\">"
                      "<Piece Extent=\"" +
                      extent + "\"><PointData><DataArray type=\"" + type +
                      "\" Name=\"a\" NumberOfComponents=\"" + std::to_string(components) +
                      "\" format=\"ascii\">" + samples);
  }

 private:
  Folder folder_;
};

const std::string left = Pieces::piece("5 7 0 2 -1 2", "left.vti");
const std::string right = Pieces::piece("7 9 0 2 -1 2", "right.vti");

}  // namespace

TEST_CASE("the pieces of a .pvti file are one volume, in any order") {
  const Pieces pieces;
  const std::string empty = Pieces::piece("5 4 0 -1 0 -1", "none.vti");
  for (const std::string& list : {left + right, right + empty + left}) {
    const auto file = pieces.write(list);
    check_volume(file, "VTK XML, text, in pieces");
    const VolumeInfo info = read_info(file);
    CHECK_FALSE(info.whole_dims);
    check_axes(info, {{{0, 2, 0}, {-3, 0, 0}, {0, 0, 4}}}, {1, 12, -1});
  }
  const auto reader = open_volume(pieces.write(left + right));
  reader->skip_slice();
  reader->skip_slice();
  std::uint8_t slice[15];
  reader->read_slice(slice);
  for (int i = 0; i < 15; ++i) CHECK(slice[i] == sample_at(30 + i, SampleType::u8));
}

TEST_CASE("a folder of .vti pieces is one volume, and is refused if it has another image") {
  const Pieces pieces;
  pieces.write(left + right);
  check_volume(pieces.folder().path(), "VTK XML, text, in pieces");
  pieces.write_piece("other.vti", 0, "UInt8");
  check_refused(pieces.folder().path(), "several volumes in folders: 2");
}

TEST_CASE("--channel applies to all pieces of a .pvti file") {
  const Pieces pieces;
  pieces.write_piece("left.vti", 0, "UInt8", 3);
  pieces.write_piece("right.vti", 2, "UInt8", 3);
  const auto file = pieces.write(left + right);
  VolumeOptions options = of_channel(1);
  const auto samples = read_samples(file, options);
  REQUIRE(samples.size() == voxels);
  for (int voxel = 0; voxel < voxels; ++voxel)
    CHECK(samples[static_cast<std::size_t>(voxel)] == sample_at(voxel, SampleType::u8) + 1);
  pieces.write_piece("right.vti", 2, "UInt8", 2);
  CHECK_THROWS_WITH_AS(
      open_volume(file, options),
      doctest::Contains("3 x 3 x 4 voxels of 2 x u8, not the 3 x 3 x 4 voxels of 3 x u8"),
      VolumeError);
}

TEST_CASE("pieces of a .pvti file that do not form the whole image are refused") {
  const Pieces pieces;
  const auto check = [&](const std::string& list, const std::string& part,
                         const std::string& extent = "5 9 0 2 -1 2") {
    check_refusal(error_of(pieces.write(list, extent)), part);
  };
  check("", "it lists no pieces");
  check(left, "no piece holds voxel (3, 0, 0)");
  check(right, "no piece holds voxel (0, 0, 0)");
  check(left + right, "no piece holds voxel (0, 0, 4)", "5 9 0 2 -1 3");
  check(left + right, "no piece holds voxel (0, 3, 0)", "5 9 0 3 -1 2");
  check(left + Pieces::piece("8 10 0 2 -1 2", "right.vti"),
        "the piece of Extent '8 10 0 2 -1 2' is outside of WholeExtent");
  check(left + Pieces::piece("7 9 0 2 -1 2", "none.vti"), "the piece 'none.vti' is missing");
  check(left + Pieces::piece("7 9 0 2 -1 2", ""), "the piece '' is missing");
  check(left + Pieces::piece("7 9 0 2 -1 2", "../right.vti"),
        "it names '../right.vti', which lies outside of its folder");
  check(left + Pieces::piece("8 9 0 2 -1 2", "right.vti"),
        "the piece has 3 x 3 x 4 voxels of 1 x u8, not the 2 x 3 x 4 voxels of 1 x u8");
  check(left + right, "dimension 1 has size 1000000000", "5 1000000004 0 2 -1 2");
  check(left + right, "WholeExtent is '5 1e+300 0 2 -1 2'", "5 1e300 0 2 -1 2");
  pieces.write_piece("right.vti", 2, "Int16");
  check(left + right, "the piece has 3 x 3 x 4 voxels of 1 x i16, not the");
  check(left + Pieces::piece("7 9 0 2 -1 2", "v.pvti"), "neither ImageData nor RectilinearGrid");
}

TEST_CASE_FIXTURE(Folder, "ghost arrays of VTK's XML are not read as samples") {
  const std::string ghosts =
      "<DataArray type=\"UInt8\" Name=\"vtkGhostType\" format=\"appended\" offset=\"70\"/>";
  const auto file =
      write("v.vti", vti("", whole, ">" + ghosts + appended_array + ghosts, appended));
  check_volume(file, "VTK XML, raw");
  CHECK_FALSE(noted(read_info(file), "left out"));
}

TEST_CASE_FIXTURE(Folder, "unsupported VTK XML is refused by name") {
  const auto check = [&](const std::string& bytes, const std::string& part) {
    check_refused(write("v.vti", bytes), part);
  };
  const std::string points = ">" + appended_array;
  check("<VTKFile type=\"StructuredGrid\">", "VTK's 'StructuredGrid', neither ImageData nor");
  check(vti("", whole, ">", appended), "there is no array of samples");
  check(vti("", whole, points, ""), "no array of samples in the first");
  check(vti("", "WholeExtent=\"0 4 0 2 0 7\"", points, appended), "in several pieces");
  check(vti("", "WholeExtent=\"0 4 0 2\"", points, appended), "WholeExtent is '0 4 0 2'");
  check(vti("compressor=\"vtkLZ4DataCompressor\"", whole, points, appended),
        "'vtkLZ4DataCompressor'");
  check(vti("", whole, "><DataArray type=\"UInt8\" NumberOfComponents=\"3\" format=\"appended\"/>",
            appended),
        "the file holds 3 channels");
  check(vti("", whole, "><DataArray type=\"String\" format=\"appended\"/>", appended), "'String'");
  check(vti("", whole, points, "<AppendedData encoding=\"raw\">x"), "does not begin with _");
  check(vti("", whole, "><DataArray type=\"UInt8\" format=\"binary\">PAAAAD!A", ""),
        "base64 text holds '!'");
  check(vti("", whole, points, "<AppendedData encoding=\"raw\">_???" + std::string(4, '\1') + u8),
        "the array has 16843009 bytes");
  check(vti("", whole, points, "<AppendedData encoding=\"raw\">_???" + std::string(4, '\0') + u8),
        "the array has 0 bytes, the volume 60");
}
