// Readers report each assumption and each omission in a note.
#include "volume_files.hpp"

namespace {

using namespace volume_files;
using Notes = std::vector<std::string>;

const std::string no_spacing = "no spacing given, 1 mm assumed";
const std::string no_axes =
    "the axes are not named; read as array[z][y][x]; to read others, give --axes, such as xyz";
const std::string no_unit = "no unit of length given, mm assumed";

std::string vti(const std::string& image, const std::string& points) {
  return "<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\"><ImageData WholeExtent=\"0 4 0 2 "
         "0 3\" " +
         image + "><Piece Extent=\"0 4 0 2 0 3\"><PointData " + points;
}

const std::string appended = "</PointData></Piece></ImageData><AppendedData encoding=\"raw\">_" +
                             std::string("\x3c\0\0\0", 4) + u8;

const std::string vtk =
    "# vtk DataFile Version 3.0\nof the test\nBINARY\nDATASET STRUCTURED_POINTS\n"
    "DIMENSIONS 5 3 4\n";
const std::string scalars = "POINT_DATA 60\nSCALARS a unsigned_char 1\nLOOKUP_TABLE default\n";

/// The notes after reading the whole volume.
Notes notes_of(const fs::path& file, const VolumeOptions& options = {}) {
  const auto reader = open_volume(file, options);
  read_all(*reader);
  return reader->notes();
}

VolumeOptions raw_options() {
  return {RawLayout{{5, 3, 4}}};
}

}  // namespace

TEST_CASE_FIXTURE(Folder,
                  "every format without a placement notes exactly the missing spacing and axes") {
  Nifti nifti;
  nifti.integer(123, 1, 0);
  const std::vector<std::pair<fs::path, Notes>> files = {
      {write("v.nrrd", nrrd(nrrd_u8) + "\n" + u8), {no_spacing}},
      {write("v.mha", metaimage(metaimage_u8 + "ElementDataFile = LOCAL\n") + u8), {no_spacing}},
      {write("v.nii", nifti.file(u8)),
       {"no orientation (sform, qform); left and right are unknown", no_unit}},
      {write("v.vtk", vtk + scalars + u8), {no_spacing}},
      {write("v.vti",
             vti("", "><DataArray type=\"UInt8\" format=\"appended\" offset=\"0\"/>") + appended),
       {no_spacing}},
      {write("v.npy", npy("|u1", "4, 3, 5", u8)), {no_axes, no_spacing}},
  };
  for (const auto& [file, notes] : files) {
    const std::string name = file.filename().string();
    INFO(name);
    CHECK(notes_of(file) == notes);
  }
  CHECK(notes_of(write("v.raw", u8), raw_options()) == Notes{no_spacing});
}

TEST_CASE_FIXTURE(Folder, "with --spacing, a missing spacing of the file is not noted") {
  VolumeOptions options = raw_options();
  options.spacing_mm = {1, 2, 3};
  CHECK(notes_of(write("v.raw", u8), options).empty());
  options.layout.reset();
  CHECK(notes_of(write("v.npy", npy("|u1", "4, 3, 5", u8)), options) == Notes{no_axes});
  CHECK(notes_of(write("v.nrrd", nrrd(nrrd_u8 + "spacings: 1 nan 1\n") + "\n" + u8), options)
            .empty());
}

TEST_CASE_FIXTURE(
    Folder,
    "bytes behind the samples are noted, in compressed files after the last slice is read") {
  const std::string behind = " bytes after the samples are left out; check the sizes";
  const std::string head = nrrd(nrrd_u8 + "spacings: 1 1 1\n" + units_in_mm);
  const VolumeInfo whole = read_info(write("v.nrrd", head + "\n" + u8 + "1234567"));
  CHECK(noted(whole, "7" + behind));
  write("header+data", "header" + u8);
  CHECK(noted(read_info(write("v.nhdr", head + "data file: header+data\n")), "6" + behind));
  const auto packed = open_volume(write("v.nrrd.gz", gzip(head + "\n" + u8 + "7")));
  CHECK(packed->notes().empty());
  read_all(*packed);
  REQUIRE(packed->notes().size() == 1);
  CHECK(packed->notes()[0].find("more" + behind) == 0);
  CHECK(notes_of(write("v.nrrd.gz", gzip(head + "\n" + u8))).empty());
}

TEST_CASE_FIXTURE(Folder, "surplus bytes are noted only behind the last volume of a file") {
  VolumeOptions options;
  const std::string head = nrrd(nrrd_u8 + "spacings: 1 1 1 1\n" + units_in_mm, "5 3 4 2") + "\n";
  for (const std::uint32_t frame : {0U, 1U}) {
    options.frame = frame;
    CHECK(notes_of(write("v.nrrd", head + u8 + u8), options).empty());
    CHECK(notes_of(write("v.nrrd.gz", gzip(head + u8 + u8)), options).empty());
    CHECK(notes_of(write("v.nrrd", head + u8 + u8 + "7"), options).size() == 1);
  }
}

TEST_CASE_FIXTURE(Folder, "further arrays in VTK's files are noted") {
  const std::string file = vtk + "SPACING 1 1 1\n" + scalars + u8;
  const auto left_out = [&](const std::string& bytes) {
    const Notes notes = notes_of(write("v.vtk", bytes));
    return notes.size() > 1 ? notes.back() : std::string();
  };
  CHECK(left_out(file + "\n").empty());
  CHECK(left_out(file + "\nSCALARS b float 1\nLOOKUP_TABLE default\n1234") ==
        "everything after the first array is left out: 'SCALARS b float 1'");
  std::string text = file.substr(0, file.size() - u8.size());
  text.replace(text.find("BINARY"), 6, "ASCII");
  for (int voxel = 0; voxel < voxels; ++voxel) text += "7 ";
  CHECK(left_out(text).empty());
  CHECK(left_out(text + "\nSCALARS b float 1\n").find("left out: the text 'SCALARS'") !=
        std::string::npos);

  const std::string a = "<DataArray type=\"UInt8\" Name=\"a\" format=\"appended\" offset=\"0\"/>";
  const std::string b = "<DataArray type=\"UInt8\" Name=\"b\" format=\"appended\" offset=\"64\"/>";
  const std::string spacing = "Spacing=\"1 1 1\"";
  CHECK(notes_of(write("v.vti", vti(spacing, ">" + a) + appended)) == Notes{no_unit});
  CHECK(notes_of(write("v.vti", vti(spacing, ">" + a + b) + appended)) ==
        Notes{no_unit, "array 'a' is read, others are left out: 'b'"});
  CHECK(notes_of(write("v.vti", vti(spacing, "Scalars=\"a\">" + b + a) + appended)) ==
        Notes{no_unit, "array 'a' is read, others are left out: 'b'"});
  std::string numbers;
  for (int voxel = 0; voxel < voxels; ++voxel) numbers += "7 ";
  const std::string in_place =
      "<DataArray type=\"UInt8\" Name=\"a\" format=\"ascii\">" + numbers + "</DataArray>" + b;
  CHECK(notes_of(write("v.vti", vti(spacing, ">" + in_place))) ==
        Notes{no_unit, "array 'a' is read, the first; everything after its samples is left out"});
  CHECK(notes_of(write("v.vti", vti(spacing, "Scalars=\"a\">" + in_place))) == Notes{no_unit});
}

TEST_CASE("equal notes of a volume are printed once") {
  VolumeInfo info;
  note(info, "a");
  note(info, "b");
  note(info, "a");
  CHECK(info.notes == Notes{"a", "b"});
}
