// VTK's image in XML: what the files of other programs do not have (container_table_test.cpp).
#include <doctest/doctest.h>

#include <string>

#include "volume_files.hpp"

namespace {

using namespace volume_files;

const std::string u8 = stored(SampleType::u8);
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

TEST_CASE("the array named as the scalars is read from several in VTK's XML") {
  const Folder folder;
  const std::string first =
      "<DataArray type=\"Int16\" Name=\"a\" format=\"ascii\">1 2 3</DataArray>";
  const std::string second =
      "<DataArray type=\"UInt8\" Name=\"b\" format=\"appended\" offset=\"3\"/>";
  check_volume(folder.write("v.vti", vti("", whole, "Scalars=\"b\">" + first + second, appended)),
               SampleType::u8, "VTK XML, raw");
  check_volume(
      folder.write("v", "<?xml version=\"1.0\"?>" + vti("", whole, ">" + appended_array, appended)),
      SampleType::u8, "VTK XML, raw");
}

TEST_CASE("VTK's XML gives the place of the first voxel, for any first number") {
  const Folder folder;
  std::string file =
      vti("", whole + " Origin=\"1 2 3\" Spacing=\"2 3 4\" Direction=\"0 -1 0 1 0 0 0 0 1\"",
          ">" + appended_array, appended);
  for (std::size_t at = 0; (at = file.find("0 4 0 2 0 3", at)) != std::string::npos;)
    file.replace(at, 11, "5 9 0 2 -1 2");
  const VolumeInfo info = open_volume(folder.write("v.vti", file))->info();
  REQUIRE(info.placement);
  using Vector = std::array<double, 3>;
  CHECK(info.placement->axes_mm == discmc::meshing::Axes{{{0, 2, 0}, {-3, 0, 0}, {0, 0, 4}}});
  CHECK(info.placement->origin_mm == Vector{1, 12, -1});
}

TEST_CASE("in VTK's XML samples may be those of cells, whose centres are between points") {
  const Folder folder;
  const std::string place = " Origin=\"1 2 3\" Spacing=\"2 3 4\" Direction=\"0 -1 0 1 0 0 0 0 1\"";
  std::string file = vti("", whole + place, ">" + appended_array, appended);
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"0 4 0 2 0 3", "0 5 0 3 0 4"},
                                 {"PointData", "CellData"}})
    for (std::size_t at = 0; (at = file.find(from, at)) != std::string::npos;)
      file.replace(at, from.size(), to);
  const auto cells = folder.write("cells.vti", file);
  check_volume(cells, SampleType::u8, "VTK XML, raw");
  CHECK(open_volume(cells)->info().placement->origin_mm == std::array<double, 3>{-0.5, 3, 5});
  // Those at points come first where there are both.
  const std::string of_cells =
      "<CellData><DataArray type=\"Int16\" Name=\"c\" format=\"appended\" "
      "offset=\"70\"/></CellData>";
  std::string both = vti("", whole, ">" + appended_array, appended);
  both.insert(both.find("<PointData"), of_cells);
  check_volume(folder.write("both.vti", both), SampleType::u8, "VTK XML, raw");
  CHECK(noted(open_volume(folder.path() / "both.vti")->info(), "others are left out: 'c'"));
}

TEST_CASE("in VTK's XML an axis of negative spacing runs backwards along its direction") {
  const Folder folder;
  const std::string place = " Origin=\"1 2 3\" Spacing=\"2 -3 4\" ";
  const auto info = [&](const std::string& direction) {
    return open_volume(folder.write("v.vti", vti("", whole + place + direction,
                                                 ">" + appended_array, appended)))
        ->info();
  };
  const VolumeInfo turned = info("Direction=\"0 -1 0 1 0 0 0 0 1\"");
  REQUIRE(turned.placement);
  CHECK(turned.placement->axes_mm == discmc::meshing::Axes{{{0, 2, 0}, {3, 0, 0}, {0, 0, 4}}});
  CHECK(turned.spacing_mm[0] * turned.spacing_mm[1] * turned.spacing_mm[2] == -24);
  CHECK(info("").placement->axes_mm == discmc::meshing::Axes{{{2, 0, 0}, {0, -3, 0}, {0, 0, 4}}});
  check_refusal(refusal(folder.write("v.vti", vti("", whole + place + "Direction=\"1 0 0 1\"",
                                                  ">" + appended_array, appended))),
                "Direction is '1 0 0 1', which is not 9 numbers");
}

TEST_CASE("a rectilinear grid of even steps in VTK's XML is a volume") {
  const Folder folder;
  const auto text = [](const std::string& numbers) {
    return "<DataArray type=\"Float64\" format=\"ascii\">" + numbers + "</DataArray>";
  };
  const auto grid = [&](const std::string& samples, const std::string& coordinates,
                        const std::string& behind) {
    std::string file = vti("", whole, samples, behind);
    file.insert(file.find("</Piece>"), "<Coordinates>" + coordinates + "</Coordinates>");
    for (std::size_t at = 0; (at = file.find("ImageData", at)) != std::string::npos;)
      file.replace(at, 9, "RectilinearGrid");
    return file;
  };
  std::string numbers;
  for (const char sample : u8) numbers += std::to_string(static_cast<unsigned char>(sample)) + ' ';
  const std::string inline_samples =
      "><DataArray type=\"UInt8\" format=\"ascii\">" + numbers + "</DataArray>";
  const std::string yz = text("3 3.5 4") + text("1 5 9 13");
  const auto even = folder.write("v.vtr", grid(inline_samples, text("-2 0 2 4 6") + yz, ""));
  check_volume(even, SampleType::u8, "VTK XML, text");
  const VolumeInfo info = open_volume(even)->info();
  CHECK(info.spacing_mm == std::array<double, 3>{2, 0.5, 4});
  CHECK(info.placement->origin_mm == std::array<double, 3>{-2, 3, 1});

  // In appended data they are behind the samples.
  const std::string array = "<DataArray type=\"UInt8\" format=\"appended\" offset=\"";
  const auto bytes = [](const std::string& values) {
    return std::string(1, static_cast<char>(values.size())) + std::string(3, '\0') + values;
  };
  check_volume(
      folder.write(
          "appended.vtr",
          grid(">" + appended_array, array + "67\"/>" + array + "76\"/>" + array + "83\"/>",
               appended + bytes("\1\2\3\4\5") + bytes("\2\4\6") + bytes("\1\2\3\4"))),
      SampleType::u8, "VTK XML, raw");
  CHECK(open_volume(folder.path() / "appended.vtr")->info().spacing_mm ==
        std::array<double, 3>{1, 2, 1});

  check_refusal(refusal(folder.write("v.vtr", grid(inline_samples, text("0 1 2 3 9") + yz, ""))),
                "the coordinates of the axis 'x' are uneven, from 0 to 9");
}

TEST_CASE("unsupported VTK XML is refused by name") {
  const Folder folder;
  const auto check = [&](const std::string& bytes, const std::string& part) {
    check_refusal(refusal(folder.write("v.vti", bytes)), part);
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
