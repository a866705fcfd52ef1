// The placement of a volume in each format.
#include "samples/volume_placement.hpp"

#include "volume_files.hpp"

namespace {

using namespace volume_files;
using discmc::meshing::determinant;
using discmc::meshing::VolumePlacement;

struct Headers : Folder {
  VolumeInfo nrrd_info(const std::string& lines) const {
    return read_info(write("v.nrrd", nrrd(nrrd_u8 + lines) + "\n" + u8));
  }
  VolumeInfo metaimage_info(const std::string& lines, const std::string& sizes = "5 3 4") const {
    const std::string header = metaimage(metaimage_u8 + lines + "ElementDataFile = LOCAL\n", sizes);
    return read_info(write("v.mha", header + u8));
  }
  VolumeInfo nifti_info(const Nifti& nifti) const {
    return read_info(write("v.nii", nifti.file(u8)));
  }
};

// A volume with voxels 0.5, 2 and 3 mm apart.
Nifti nifti_of_spacing() {
  return Nifti().real(80, 0.5F).real(84, 2).real(88, 3);
}

void check_placement(const VolumeInfo& info, Space space, const Vector& origin, const Axes& axes) {
  REQUIRE(info.placement);
  CHECK(info.placement->space == space);
  constexpr double rounding = 1e-6;  // of 32-bit numbers
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(std::fabs(info.placement->origin_mm[i] - origin[i]) < rounding);
    for (std::size_t axis = 0; axis < 3; ++axis)
      CHECK(std::fabs(info.placement->axes_mm[axis][i] - axes[axis][i]) < rounding);
  }
  // Without it, the rest of the placement rotates and translates the surface, and never mirrors it.
  const Vector& s = info.spacing_mm;
  CHECK((s[0] * s[1] * s[2] < 0) == (determinant(info.placement->axes_mm) < 0));
}

}  // namespace

TEST_CASE_FIXTURE(Headers, "NRRD's directions and origin are read in its space") {
  const std::string turned =
      "space directions: (0,2,0) (-3,0,0) (0,0.6,0.8)\nspace origin: (10,-20,30.5)\n";
  const Axes axes{{{0, 2, 0}, {-3, 0, 0}, {0, 0.6, 0.8}}};
  for (const auto& each :
       std::vector<std::pair<std::string, Space>>{{"space: left-posterior-superior\n", Space::lps},
                                                  {"space: LPS\n", Space::lps},
                                                  {"space: right-anterior-superior\n", Space::ras},
                                                  {"space: RAS\n", Space::ras},
                                                  {"space: scanner-xyz\n", Space::scanner},
                                                  {"space: 3D-right-handed\n", Space::scanner},
                                                  {"space dimension: 3\n", Space::scanner}}) {
    const auto& [field, space] = each;
    INFO(each.first);
    const VolumeInfo info = nrrd_info(field + units_in_mm + turned);
    check_placement(info, space, {10, -20, 30.5}, axes);
    CHECK(info.notes.empty());
  }
}

TEST_CASE_FIXTURE(Headers, "NRRD's left-handed spaces are converted to right-handed ones") {
  const std::string turned =
      "space directions: (0,2,0) (-3,0,0) (0,0,4)\nspace origin: (10,-20,30)\n";
  const Axes axes{{{0, 2, 0}, {3, 0, 0}, {0, 0, 4}}};
  for (const std::string name : {"left-anterior-superior", "LAS"}) {
    const VolumeInfo info = nrrd_info("space: " + name + "\n" + turned);
    check_placement(info, Space::ras, {-10, -20, 30}, axes);
    CHECK(info.notes.empty());
  }
  const VolumeInfo info = nrrd_info("space: 3D-left-handed\n" + turned);
  check_placement(info, Space::scanner, {-10, -20, 30}, axes);
  CHECK(noted(info, "x of the left-handed space '3D-left-handed' negated"));
}

TEST_CASE_FIXTURE(Headers, "the units of NRRD apply to its space coordinates") {
  check_placement(nrrd_info("space: LPS\nspace units: \"cm\" \"mm\" \"um\"\n"
                            "space directions: (0,2,0) (0.3,0,0) (0,0,4000)\n"
                            "space origin: (1,2,5000)\n"),
                  Space::lps, {10, 2, 5}, {{{0, 2, 0}, {3, 0, 0}, {0, 0, 4}}});
}

TEST_CASE_FIXTURE(Headers, "NRRD with spacings alone lies along the coordinates of its space") {
  CHECK_FALSE(nrrd_info("spacings: 0.5 2 3\n").placement);
  CHECK_FALSE(nrrd_info("space dimension: 3\n"
                        "space directions: (0.5,0,0) (0,-2,0) (0,0,3)\n")
                  .placement);
  check_placement(nrrd_info("space dimension: 3\nspacings: 0.5 2 3\nspace origin: (1,2,3)\n"),
                  Space::scanner, {1, 2, 3}, {{{0.5, 0, 0}, {0, 2, 0}, {0, 0, 3}}});
}

TEST_CASE_FIXTURE(
    Headers,
    "NRRD's axis mins and maxs bound voxels or voxel centres, depending on the centering") {
  const std::string bounds = "axis mins: -20 3 40\naxis maxs: -17.5 -3 64\n";
  const VolumeInfo cells = nrrd_info(bounds + units_in_mm + "centerings: cell cell cell\n");
  check_placement(cells, Space::scanner, {-19.75, 2, 43}, {{{0.5, 0, 0}, {0, -2, 0}, {0, 0, 6}}});
  CHECK(cells.notes.empty());
  const VolumeInfo unknown = nrrd_info(bounds + units_in_mm);
  CHECK(unknown.placement == cells.placement);
  CHECK(noted(unknown, "no centerings given"));
  check_placement(nrrd_info("axismins: -20 3 40\naxismaxs: -18 -3 64\ncenters: node node node\n"),
                  Space::scanner, {-20, 3, 40}, {{{0.5, 0, 0}, {0, -3, 0}, {0, 0, 8}}});
  check_placement(nrrd_info(bounds + "units: cm mm um\ncenterings: cell node cell\n"),
                  Space::scanner, {-197.5, 3, 0.043}, {{{5, 0, 0}, {0, -3, 0}, {0, 0, 0.006}}});
}

TEST_CASE_FIXTURE(Headers, "NRRD's spacings and origin precede axis mins and maxs, with a note") {
  const std::string bounds = "axis mins: 0 0 0\naxis maxs: 5 6 4\ncenters: cell cell cell\n";
  const VolumeInfo spaced = nrrd_info(bounds + "spacings: 1 2 nan\n" + units_in_mm);
  CHECK(spaced.spacing_mm == Vector{1, 2, 1});
  CHECK(spaced.notes.empty());
  const VolumeInfo other = nrrd_info(bounds + "spacings: 1 2 3\n" + units_in_mm);
  CHECK(other.spacing_mm == Vector{1, 2, 3});
  CHECK(noted(other, "axis mins and maxs contradict the spacings"));
  const VolumeInfo placed =
      nrrd_info(bounds + "space: LPS\nspacings: 1 2 3\nspace origin: (7,8,9)\n" + units_in_mm);
  check_placement(placed, Space::lps, {7, 8, 9}, {{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}});
  CHECK(noted(placed, "axis mins and axis maxs are ignored"));
}

TEST_CASE_FIXTURE(Headers, "NRRD's thicknesses replace a missing spacing") {
  const VolumeInfo info = nrrd_info("spacings: 0.5 2 nan\nthicknesses: nan 9 3\n" + units_in_mm);
  CHECK(info.spacing_mm == Vector{0.5, 2, 3});
  CHECK(info.notes ==
        std::vector<std::string>{"no spacing of axis 3 given, its thickness is used"});
}

TEST_CASE_FIXTURE(Headers,
                  "unknown or missing units of length are noted, and millimetres are assumed") {
  const VolumeInfo nrrd = nrrd_info("spacings: 1 2 3\nunits: mm furlong \"\"\n");
  CHECK(noted(nrrd, "unit 'furlong' is unknown, mm assumed"));
  CHECK(noted(nrrd_info("spacings: 1 2 3\n"), "no unit of length given, mm assumed"));
  CHECK(nrrd_info("space: LPS\nspacings: 1 2 3\n").notes.empty());
  CHECK(nrrd_info("spacings: 1 2 3\nunits: microns Micrometers \"\u00b5m\"\n").spacing_mm ==
        Vector{0.001, 0.002, 0.003});
  CHECK(noted(nifti_info(nifti_of_spacing().integer(123, 1, 0)),
              "no unit of length given, mm assumed"));
}

TEST_CASE_FIXTURE(Headers, "an undefined NRRD space is noted") {
  const std::string steps = "space directions: (1,0,0) (0,1,0) (0,0,1)\n" + units_in_mm;
  const VolumeInfo info = nrrd_info("space: right-posterior-superior\n" + steps);
  CHECK(info.notes == std::vector<std::string>{
                          "the space 'right-posterior-superior' is unknown, right-handed assumed"});
  for (const std::string space : {"3D-right-handed-time", "scanner-xyz-time", "LPST"})
    CHECK(nrrd_info("space: " + space + "\n" + steps).notes.empty());
}

TEST_CASE_FIXTURE(Headers, "NIfTI's sform is used unchanged, in RAS") {
  // Sheared, with longer axes than in pixdim.
  const std::vector<float> rows = {0.4F, -1, 0.5F, -90, 0.3F, 1.5F, 0, 126.5F, 0, 0.25F, 3, -72};
  const Axes axes{{{0.4, 0.3, 0}, {-1, 1.5, 0.25}, {0.5, 0, 3}}};
  const VolumeInfo info = nifti_info(nifti_of_spacing().sform(rows));
  check_placement(info, Space::ras, {-90, 126.5, -72}, axes);
  CHECK(noted(info, "spacing (0.5, 2, 3) contradicts the axes, whose (0.5, 1.82"));
  CHECK(info.spacing_mm[2] == doctest::Approx(std::hypot(0.5, 0, 3)));
  const VolumeInfo straight =
      nifti_info(nifti_of_spacing().sform({0.5F, 0, 0, 1, 0, 2, 0, 2, 0, 0, 3, 3}));
  check_placement(straight, Space::ras, {1, 2, 3}, {{{0.5, 0, 0}, {0, 2, 0}, {0, 0, 3}}});
  CHECK(straight.notes.empty());
  // It takes precedence over the qform, and has the units of the header.
  Nifti both = nifti_of_spacing().sform(rows).integer(252, 2, 1);
  check_placement(nifti_info(both.integer(123, 1, 3)), Space::ras, {-0.09, 0.1265, -0.072},
                  {{{0.0004, 0.0003, 0}, {-0.001, 0.0015, 0.00025}, {0.0005, 0, 0.003}}});
}

TEST_CASE_FIXTURE(Headers, "NIfTI's qform rotates by its quaternion and flips z by qfac") {
  Nifti nifti = nifti_of_spacing();
  // Half of a right angle about z, so b and c are 0.
  nifti.integer(252, 2, 1).real(264, 0.70710678F).real(268, 7).real(272, -8).real(276, 9);
  check_placement(nifti_info(nifti), Space::ras, {7, -8, 9},
                  {{{0, 0.5, 0}, {-2, 0, 0}, {0, 0, 3}}});
  check_placement(nifti_info(nifti.real(76, -1)), Space::ras, {7, -8, 9},
                  {{{0, 0.5, 0}, {-2, 0, 0}, {0, 0, -3}}});
  CHECK_FALSE(nifti_info(nifti_of_spacing()).placement);
}

TEST_CASE_FIXTURE(Headers, "NIfTI's qform replaces a singular sform") {
  Nifti nifti = nifti_of_spacing();
  nifti.integer(252, 2, 1).real(264, 0.70710678F).real(268, 7).real(272, -8).real(276, 9);
  const float infinite = std::numeric_limits<float>::infinity();
  const std::vector<std::vector<float>> of_no_use = {std::vector<float>(12, 0),
                                                     std::vector<float>(12, std::nanf("")),
                                                     {1, 0, 0, 5, 1, 0, 0, 6, 0, 0, 1, 7},
                                                     {infinite, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3, 0}};
  for (const auto& rows : of_no_use) {
    const VolumeInfo info = nifti_info(nifti.sform(rows));
    check_placement(info, Space::ras, {7, -8, 9}, {{{0, 0.5, 0}, {-2, 0, 0}, {0, 0, 3}}});
    CHECK(info.notes == std::vector<std::string>{"the sform spans no space, and is ignored"});
    const VolumeInfo neither = nifti_info(nifti_of_spacing().sform(rows));
    CHECK_FALSE(neither.placement);
    CHECK(neither.spacing_mm == Vector{0.5, 2, 3});
    CHECK(noted(neither, "no orientation"));
  }
}

TEST_CASE_FIXTURE(Headers, "a qform of NIfTI that is mirrored against the sform is noted") {
  const std::vector<float> sform = {0.5F, 0, 0, 1, 0, 2, 0, 2, 0, 0, 3, 3};
  const Nifti both = nifti_of_spacing().sform(sform).integer(252, 2, 1);
  CHECK(nifti_info(both).notes.empty());
  const VolumeInfo mirrored = nifti_info(Nifti(both).real(76, -1));
  CHECK(noted(mirrored, "the qform is mirrored against the sform, and ignored"));
  check_placement(mirrored, Space::ras, {1, 2, 3}, {{{0.5, 0, 0}, {0, 2, 0}, {0, 0, 3}}});
}

TEST_CASE_FIXTURE(Headers, "a negative distance in NIfTI is read as positive, with a note") {
  const VolumeInfo info = nifti_info(nifti_of_spacing().real(84, -2));
  CHECK(info.spacing_mm == Vector{0.5, 2, 3});
  CHECK(noted(info, "pixdim 2 is negative, and read as positive"));
}

TEST_CASE_FIXTURE(Headers, "MetaImage's unit is read, and ElementSize as a missing spacing") {
  const std::string place = "ElementSpacing = 0.5 2 3\nOffset = 10 20 30\n";
  const VolumeInfo microns = metaimage_info("DistanceUnits = um\n" + place);
  check_placement(microns, Space::lps, {0.01, 0.02, 0.03},
                  {{{0.0005, 0, 0}, {0, 0.002, 0}, {0, 0, 0.003}}});
  CHECK(microns.notes.empty());
  CHECK(metaimage_info("DistanceUnits = cm\n" + place).spacing_mm == Vector{5, 20, 30});
  CHECK(
      noted(metaimage_info("DistanceUnits = ?\n" + place), "no unit of length given, mm assumed"));
  const VolumeInfo sized = metaimage_info("ElementSize = 0.5 2 3\n");
  CHECK(sized.spacing_mm == Vector{0.5, 2, 3});
  CHECK(noted(sized, "no ElementSpacing given, ElementSize is used"));
  CHECK(metaimage_info("ElementSize = 9 9 9\nElementSpacing = 0.5 2 3\n").spacing_mm ==
        Vector{0.5, 2, 3});
}

TEST_CASE_FIXTURE(Headers, "MetaImage's axes of negative spacing run backwards") {
  check_placement(metaimage_info("ElementSpacing = 1 -2 3\nTransformMatrix = 0 1 0 1 0 0 0 0 1\n"),
                  Space::lps, {0, 0, 0}, {{{0, 1, 0}, {-2, 0, 0}, {0, 0, 3}}});
}

TEST_CASE_FIXTURE(Headers, "MetaImage's matrix has one axis per row, and its origin is in LPS") {
  const std::string spacing = "ElementSpacing = 0.5 2 3\n";
  for (const std::string name : {"Offset", "Position", "Origin"}) {
    const VolumeInfo info = metaimage_info(
        spacing + "TransformMatrix = 0 1 0 -0.6 0 0.8 0.8 0 0.6\n" + name + " = 10 -20 30\n");
    check_placement(info, Space::lps, {10, -20, 30},
                    {{{0, 0.5, 0}, {-1.2, 0, 1.6}, {2.4, 0, 1.8}}});
    CHECK(info.notes.empty());
  }
  CHECK_FALSE(metaimage_info(spacing).placement);
  // The matrix has other sizes for two and four dimensions.
  check_placement(metaimage_info("TransformMatrix = 0 1 -1 0\nOffset = 1 2\n", "5 12"), Space::lps,
                  {1, 2, 0}, {{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}});
  check_placement(metaimage_info("TransformMatrix = 0 1 0 0 -1 0 0 0 0 0 1 0 0 0 0 1\n"
                                 "Offset = 1 2 3 4\n",
                                 "5 3 4 1"),
                  Space::lps, {1, 2, 3}, {{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}});
  CHECK(noted(metaimage_info("TransformMatrix = 1 0 0 1\n"),
              "TransformMatrix of 4 numbers is ignored"));
}

TEST_CASE_FIXTURE(Headers,
                  "MetaImage's AnatomicalOrientation is noted if it contradicts the matrix") {
  const std::string matrix = "ElementSpacing = 1 1 1\nTransformMatrix = 1 0 0 0 -1 0 0 0 1\n";
  CHECK(metaimage_info(matrix + "AnatomicalOrientation = RPI\n").notes.empty());
  CHECK(metaimage_info(matrix + "AnatomicalOrientation = ???\n").notes.empty());
  CHECK(noted(metaimage_info(matrix + "AnatomicalOrientation = RAI\n"),
              "AnatomicalOrientation 'RAI' is ignored; by the TransformMatrix it is 'RPI'"));
}

TEST_CASE_FIXTURE(Headers,
                  "spacings of nanometres are enlarged together with the origin, with a note") {
  for (const std::string place : {"units: \"nm\" \"nm\" \"nm\"\nspacings: 0.5 1 2\n",
                                  "space: LPS\nspace directions: (5e-7,0,0) (0,1e-6,0) (0,0,2e-6)\n"
                                  "space origin: (5e-6,0,0)\n"}) {
    const VolumeInfo info = nrrd_info(place);
    for (std::size_t axis = 0; axis < 3; ++axis)
      CHECK(info.spacing_mm[axis] == doctest::Approx(0.5 * (1U << axis)));
    CHECK(noted(info, "1 nm is written as 1 mm"));
    CHECK(info.placement.has_value() == (place[0] == 's'));
    if (info.placement) CHECK(info.placement->origin_mm[0] == doctest::Approx(5));
  }
  CHECK(noted(nrrd_info("spacings: 1 1 1e-9\n"), "is unusable, 1 mm assumed"));
}

TEST_CASE_FIXTURE(
    Headers, "an unusable placement is replaced by one along the coordinate axes, with a note") {
  const VolumeInfo flat = nrrd_info(
      "space: LPS\nspace directions: (1,0,0) (0,2,0) (1,1,0)\n"
      "space origin: (1,2,3)\n");
  check_placement(flat, Space::lps, {1, 2, 3}, {{{1, 0, 0}, {0, 2, 0}, {0, 0, std::sqrt(2.0)}}});
  CHECK(noted(flat, "the axis directions are unusable"));
  const VolumeInfo far = nrrd_info(
      "space: LPS\nspace directions: (1,0,0) (0,2,0) (0,0,3)\n"
      "space origin: (nan,0,1e10)\n");
  check_placement(far, Space::lps, {0, 0, 0}, {{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}});
  CHECK(noted(far, "origin (nan, 0, 1e+10) is unusable, 0 is used"));
}
