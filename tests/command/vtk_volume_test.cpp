// VTK's legacy format, NumPy and InVesalius: cases that the files of other programs lack
// (container_table_test.cpp).
#include "volume_files.hpp"

namespace {

using namespace volume_files;

std::string vtk(const std::string& lines) {
  return "# vtk DataFile Version 3.0\nof the test\nBINARY\n" + lines;
}
const std::string image = "DATASET STRUCTURED_POINTS\nDIMENSIONS 5 3 4\nSPACING 1 2 3\n";
const std::string scalars = "POINT_DATA 60\nSCALARS a unsigned_char 1\nLOOKUP_TABLE default\n";

std::string numpy(const std::string& dictionary) {
  return std::string("\x93NUMPY\1\0", 8) + static_cast<char>(dictionary.size()) + '\0' + dictionary;
}

}  // namespace

TEST_CASE_FIXTURE(Folder,
                  "legacy VTK samples are read from scalars, colours or a field, with placement") {
  const std::string field = "POINT_DATA 60\nFIELD FieldData 1\na 1 60 unsigned_char\n";
  const std::string colours = "POINT_DATA 60\nCOLOR_SCALARS a 1\n";
  for (const std::string& array : {scalars, field, colours}) {
    check_volume(write("v.vtk", vtk(image + array + u8)), "VTK, raw");
    check_volume(write("v", vtk(image + "METADATA\nINFORMATION 0\n\n" + array + u8 + "\n")),
                 "VTK, raw");
  }
  const auto info = read_info(write("v.vtk", vtk(image + "ORIGIN 7 8 -9\n" + scalars + u8)));
  check_origin(info, {7, 8, -9});
}

TEST_CASE_FIXTURE(Folder, "field data before the image in legacy VTK is skipped") {
  const std::string metadata = "METADATA\nINFORMATION 0\n\n";
  const std::string eight = std::string("\0\12 3\4\5\6\7", 8);  // with a line break in it
  const std::string field = "FIELD FieldData 2\nTIME 1 1 double\n" + eight + "\n" + metadata +
                            "N 2 1 int\n" + eight + "\n";
  check_volume(write("v.vtk", vtk(field + image + scalars + u8)), "VTK, raw");
  check_refused(write("v.vtk", vtk("FIELD FieldData 1\nTIME 1 -1 double\n" + image + scalars + u8)),
                "the field's line 'TIME 1 -1 double' is not that of an array");
  const std::string header = "# vtk DataFile Version 3.0\n\nASCII\n";
  std::string text;
  for (const char sample : u8) text += std::to_string(static_cast<unsigned char>(sample)) + ' ';
  check_volume(write("v.vtk", header + "FIELD FieldData 1\nTIME 1 3 double\n1 2\n3\n" + image +
                                  scalars + text),
               "VTK, text");
}

TEST_CASE_FIXTURE(Folder, "components of legacy VTK vectors and scalars are chosen as channels") {
  std::string samples, text;
  for (const char sample : u8)
    for (const char each : {sample, static_cast<char>(sample ^ 1), '\7'}) {
      samples += each;
      text += std::to_string(static_cast<unsigned char>(each)) + ' ';
    }
  VolumeOptions options = of_channel(1);
  for (const std::string& array :
       {std::string("VECTORS v unsigned_char\n"), std::string("COLOR_SCALARS c 3\n"),
        std::string("SCALARS a unsigned_char 3\nLOOKUP_TABLE t\n")}) {
    const auto file = write("v.vtk", vtk(image + "POINT_DATA 60\n" + array + samples));
    const auto read = read_samples(file, options);
    REQUIRE(read.size() == voxels);
    for (std::size_t i = 0; i < read.size(); ++i)
      CHECK(read[i] == (static_cast<unsigned char>(u8[i]) ^ 1));
  }
  options.channel = 0;
  const std::string header = "# vtk DataFile Version 3.0\n\nASCII\n" + image;
  check_volume(write("v.vtk", header + "POINT_DATA 60\nVECTORS v unsigned_char\n" + text),
               "VTK, text", options);
}

TEST_CASE_FIXTURE(Folder, "cell data of legacy VTK is placed at the centres between points") {
  const std::string cells =
      "DATASET STRUCTURED_POINTS\nDIMENSIONS 6 4 5\nSPACING 1 2 3\nORIGIN 7 8 -9\nCELL_DATA 60\n"
      "SCALARS a unsigned_char 1\nLOOKUP_TABLE default\n";
  const auto file = write("v.vtk", vtk(cells + u8));
  check_volume(file, "VTK, raw");
  CHECK(read_info(file).placement->origin_mm == Vector{7.5, 9, -7.5});
}

TEST_CASE_FIXTURE(Folder, "unsupported legacy VTK is refused by name") {
  const auto check = [&](const std::string& bytes, const std::string& part) {
    check_refused(write("v.vtk", bytes), part);
  };
  check(vtk("DATASET POLYDATA\n"), "of kind 'POLYDATA'");
  check(vtk(image + "CELLS 60\n" + u8), "header line 'CELLS 60' is unknown");
  check(vtk(image + scalars.substr(scalars.find('S')).insert(0, "CELL_DATA 60\n") + u8),
        "there are 60 samples for the 24 cells of DIMENSIONS");
  check(vtk(image + "POINT_DATA 60\nTENSORS v float\n"), "of kind 'tensors'");
  check(vtk(image + "POINT_DATA 60\nSCALARS a float 3\nLOOKUP_TABLE t\n"),
        "the file holds 3 channels");
  check(vtk(image + "POINT_DATA 60\nSCALARS a bit\nLOOKUP_TABLE t\n"), "type 'bit'");
  check(vtk(image + "POINT_DATA 60\nSCALARS a int\n\n"), "after SCALARS the header has ''");
  check(vtk(image + "POINT_DATA 59\nSCALARS a unsigned_char\nLOOKUP_TABLE t\n" + u8),
        "there are 59 samples for the 60 points of DIMENSIONS");
  check(vtk(image + "POINT_DATA 60\nFIELD FieldData 1\na 1 61 unsigned_char\n" + u8),
        "there are 61 samples");
  check(vtk(image), "no array of samples");
  check(vtk("DIMENSIONS 5 3\n"), "dimensions is followed by 2 words");
  check("# vtk DataFile Version 3.0\n\nASCI\n", "third line is 'asci'");
}

TEST_CASE_FIXTURE(Folder, "a NumPy array has x along its contiguous axis") {
  const std::string c_order = "{'descr': '|u1', 'fortran_order': False, 'shape': (4, 3, 5), }\n";
  const std::string fortran = "{'descr': '|u1', 'fortran_order': True, 'shape': (5, 3, 4), }\n";
  const auto c_file = write("c.npy", numpy(c_order) + u8);
  const auto fortran_file = write("fortran.npy", numpy(fortran) + u8);
  check_volume(c_file, "NumPy");
  check_volume(fortran_file, "NumPy");
  CHECK(noted(read_info(fortran_file), "read as array[x][y][z]"));
  CHECK(noted(read_info(c_file), "no spacing given"));
}

TEST_CASE_FIXTURE(Folder, "unsupported NumPy is refused by name") {
  const auto check = [&](const std::string& bytes, const std::string& part) {
    check_refused(write("v.npy", bytes), part);
  };
  check(numpy("{'descr': '<c8', 'fortran_order': False, 'shape': (4, 3, 5)}"), "'<c8'");
  check(numpy("{'descr': '|u1', 'fortran_order': False, 'shape': (4,)}"), "1 dimensions");
  check(numpy("{'descr': '|u1', 'fortran_order': False}"), "has no shape");
  check(numpy("{'descr': '|u1', 'fortran_order': False, 'shape': (4, 3, x)}"), "shape is 'x'");
  check(numpy("{'descr': '|u1', 'fortran_order': False, 'shape': (4, 3, 5)}") + u8.substr(1),
        "1 bytes of it are missing");
  check("\x93NUMPY\x07 abcdef", "version 7");
  check("\x93NUM", "incomplete");
  check(std::string("\x93NUMPY\2\0\xff\xff\xff\xff", 12), "header has 4294967295 bytes");
}

TEST_CASE_FIXTURE(
    Folder, "an InVesalius project is read with y backwards, and a damaged project is refused") {
  const fs::path project = fs::path(DISCMC_SOURCE_DIR) / "tests" / "command" / "volumes" /
                           "invesalius" / "i16-little.inv3";
  CHECK(read_info(project).spacing_mm == Spacing{0.5, -0.75, 2});
  CHECK(noted(read_info(project), "y runs backwards"));
  std::string bytes = contents(project);
  check_refused(write("v.inv3", bytes.substr(0, 700)), "no whole file main.plist");
  check_refused(write("v.inv3", "nothing"), "no whole file main.plist");
  const std::size_t type = bytes.find("int16");
  bytes.replace(type, 5, "int99");
  check_refused(write("v.inv3", bytes), "type 'int99'");
}
