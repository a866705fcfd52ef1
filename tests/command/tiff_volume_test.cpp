// Pages of TIFF as volumes: descriptions of OME-XML, ImageJ and tifffile, and the effects of other
// tags.
#include "command.hpp"
#include "tiff_writer.hpp"

namespace {

using namespace tiff_writer;
using namespace volume_files;

const fs::path files = fs::path(DISCMC_SOURCE_DIR) / "tests/command/volumes/pictures";

VolumeOptions chosen(std::optional<std::uint32_t> frame, std::optional<std::uint32_t> channel) {
  VolumeOptions options = of_frame(frame);
  options.channel = channel;
  return options;
}

// The slices of write_pictures.py from this slice on.
std::vector<double> slices(int first, int count) {
  std::vector<double> values = patterned(first, count);
  for (double& value : values) value = std::fmod(value + 251 * 8, 251);
  return values;
}

void check_spacing(const VolumeInfo& info, const Spacing& expected) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    CHECK(info.spacing_mm[axis] == doctest::Approx(expected[axis]).epsilon(1e-6));
}

// Pages of 2 by 1 voxels that contain their number, and a description in the first page.
TiffWriter numbered(int pages, const std::string& description = {}, Tags more = {}) {
  TiffWriter tiff;
  for (int i = 0; i < pages; ++i) {
    Tags tags = more;
    if (i == 0 && !description.empty()) tags[tag::description] = text(description);
    tiff.page(2, 1, std::string(2, static_cast<char>(i)), tags);
  }
  return tiff;
}

struct Tiff : Folder {
  fs::path tiff(int pages, const std::string& description = {}, const Tags& more = {},
                const std::string& name = "v.tif") const {
    return write(name, numbered(pages, description, more).bytes());
  }
};

std::vector<int> pages_read(const fs::path& file, const VolumeOptions& options = {}) {
  std::vector<int> pages;
  const std::vector<double> samples = read_samples(file, options);
  for (std::size_t i = 0; i < samples.size(); i += 2) pages.push_back(static_cast<int>(samples[i]));
  return pages;
}

using Pages = std::vector<int>;

// ---- files of other programs ----

TEST_CASE("a channel and a time of a TIFF hyperstack are chosen for any order of axes") {
  for (const std::string name :
       {"tcz.ome", "tzc.ome", "ctz.ome", "czt.ome", "ztc.ome", "zct.ome", "imagej", "shaped"}) {
    INFO(name);
    const fs::path file = files / ("hyperstack-" + name + ".tif");
    for (const int frame : {0, 1})
      for (const int channel : {0, 1}) {
        const auto reader = open_volume(file, chosen(frame, channel));
        CHECK(reader->info().dims == Dims{8, 6, 3});
        CHECK(reader->info().frames == 2);
        CHECK(reader->info().channels == 2);
        CHECK(read_all(*reader) == slices(6 * frame + 3 * channel, 3));
      }
    check_refused(file, chosen({}, 0),
                  "the file holds 2 volumes, and one is read at a time; choose one with --frame N");
    check_refused(file, chosen(0, {}), "the file holds 2 channels");
    check_refused(file, chosen(2, 0),
                  "there is no volume 2: the file holds 2; choose one "
                  "with --frame 0 to 1");
    check_refused(file, chosen(0, 2),
                  "there is no channel 2: the file holds 2; choose "
                  "one with --channel 0 to 1");
  }
  check_refused(files / "hyperstack-tcz.ome.tif", chosen(0, {}), "2 channels ('bone', 'dye')");
}

TEST_CASE("the spacing of TIFF is read from OME-XML or ImageJ, in their units") {
  check_spacing(read_info(files / "hyperstack-tcz.ome.tif", chosen(0, 0)), {2.5e-3, 5e-4, 5});
  check_spacing(read_info(files / "hyperstack-imagej.tif", chosen(0, 0)),
                {0.5e-3, 0.25e-3, 2.5e-3});
  check_spacing(read_info(files / "imagej.tif"), {0.5, 0.25, 2.5});
  check_spacing(read_info(files / "imagej.tif", {{}, Spacing{1, 2, 3}}), {1, 2, 3});
}

TEST_CASE(
    "TIFF files with missing directories, slice blocks, bit samples, half floats and palettes are "
    "read") {
  CHECK(read_samples(files / "one-directory.tif") == slices(0, 5));
  CHECK(read_samples(files / "deep-tiles1.tif") == slices(0, 5));
  CHECK(read_samples(files / "deep-tiles4.tif") == slices(0, 5));
  check_refused(files / "deep-strips.tif", "several slices (ImageDepth) in strips");

  const auto palette = open_volume(files / "palette.tif");
  CHECK(noted(palette->info(), "numbers of colours in a palette"));
  CHECK(read_all(*palette) == slices(0, 5));

  const auto bilevel = open_volume(files / "bilevel.tif");
  CHECK(bilevel->info().type == SampleType::u8);
  std::vector<double> bits = slices(0, 5);
  for (double& value : bits) value = std::fmod(value, 2);
  CHECK(read_all(*bilevel) == bits);

  const auto halves = open_volume(files / "f16.tif");
  CHECK(halves->info().type == SampleType::f32);
  CHECK(read_all(*halves) == read_samples(files / "f32.tif"));
}

TEST_CASE("a channel of a colour TIFF is chosen") {
  for (const std::string name : {"colours.tif", "planar-colours.tif"}) {
    INFO(name);
    check_refused(files / name, "3 channels ('red', 'green', 'blue')");
    for (const int channel : {0, 1, 2})
      CHECK(read_samples(files / name, chosen({}, channel)) == slices(channel, 1));
  }
}

// ---- OME-XML ----

std::string ome(const std::string& images, const std::string& attributes = {}) {
  return "<?xml version=\"1.0\"?><OME xmlns=\"http://www.openmicroscopy.org/Schemas/OME/2016-06\"" +
         attributes + ">" + images + "</OME>";
}

std::string image(const std::string& sizes, const std::string& inside = "<TiffData/>",
                  const std::string& name = "left") {
  return "<Image Name=\"" + name + "\"><Pixels DimensionOrder=\"XYZCT\" SizeX=\"2\" SizeY=\"1\" " +
         sizes + ">" + inside + "</Pixels></Image>";
}

const std::string four_slices = "SizeZ=\"4\" SizeC=\"1\" SizeT=\"1\"";

// A file with as many pages as slices; checks that it is refused.
std::string refusal_of(const std::string& xml, int pages = 4, const VolumeOptions& options = {}) {
  const Folder folder;
  return refusal(folder.write("v.ome.tif", numbered(pages, xml).bytes()), options);
}

TEST_CASE_FIXTURE(Tiff,
                  "lengths in OME-XML without a unit are in micrometres; invalid units are noted") {
  const auto info_of = [this](const std::string& sizes) {
    const auto xml = ome(image(four_slices + " " + sizes));
    return read_info(tiff(4, xml));
  };
  check_spacing(info_of("PhysicalSizeX=\"2\" PhysicalSizeY=\"3\" PhysicalSizeZ=\"4\""),
                {2e-3, 3e-3, 4e-3});
  const VolumeInfo of_pixels = info_of("PhysicalSizeX=\"2\" PhysicalSizeXUnit=\"pixel\"");
  CHECK(noted(of_pixels, "PhysicalSizeX is in 'pixel', which is not a length"));
  CHECK(noted(of_pixels, "no spacing given"));
  const VolumeInfo without_z = info_of("PhysicalSizeX=\"2\" PhysicalSizeY=\"2\"");
  CHECK(noted(without_z, "no distance of slices given, the distance of pixels is used"));
  check_spacing(without_z, {2e-3, 2e-3, 2e-3});
}

TEST_CASE_FIXTURE(Tiff, "TiffData elements of OME-XML order the pages") {
  const auto pages_of = [this](const std::string& data) {
    return pages_read(tiff(4, ome(image(four_slices, data))));
  };
  CHECK(pages_of("") == Pages{0, 1, 2, 3});
  CHECK(pages_of("<TiffData IFD=\"0\" PlaneCount=\"4\"/>") == Pages{0, 1, 2, 3});
  CHECK(pages_of("<TiffData IFD=\"2\" FirstZ=\"0\" PlaneCount=\"2\"/>"
                 "<TiffData IFD=\"0\" FirstZ=\"2\" PlaneCount=\"2\"/>") == Pages{2, 3, 0, 1});
  CHECK(pages_of("<TiffData IFD=\"3\"/><TiffData IFD=\"2\" FirstZ=\"1\"/>"
                 "<TiffData IFD=\"1\" FirstZ=\"2\"/><TiffData FirstZ=\"3\" PlaneCount=\"1\"/>") ==
        Pages{3, 2, 1, 0});
}

TEST_CASE("OME-XML that does not fit its pages is refused") {
  check_refusal(refusal_of(ome(image(four_slices)), 3), "slice 3 of channel 0 has no page");
  check_refusal(refusal_of(ome(image(four_slices)), 5), "the description lacks page 4");
  const auto with_data = [](const std::string& data) { return ome(image(four_slices, data)); };
  check_refusal(refusal_of(with_data("<TiffData IFD=\"2\" PlaneCount=\"4\"/>")),
                "describes 4 planes from page 2 on, and 'v.ome.tif' has 4 pages");
  check_refusal(refusal_of(with_data("<TiffData/><TiffData IFD=\"1\"/>")),
                "plane 0 has two pages in the description");
  check_refusal(refusal_of(with_data("<TiffData FirstZ=\"4\"/>")), "FirstZ is 4, after the last");
  check_refusal(refusal_of(with_data("<TiffData IFD=\"x\"/>")), "IFD is 'x'");
  check_refusal(refusal_of(ome(image("SizeZ=\"4\" SizeC=\"1\" SizeT=\"0\""))),
                "an image of 0 planes");
  check_refusal(refusal_of(ome("")), "describes no image");
  check_refusal(refusal_of("<OME><Image></OME>"), "the OME-XML is damaged");
  check_refusal(refusal_of(ome(image(four_slices) + "<StructuredAnnotations><ModuloAlongZ/>"
                                                    "</StructuredAnnotations>")),
                "a further axis (ModuloAlongZ)");
  std::string other_order = ome(image(four_slices));
  other_order.replace(other_order.find("XYZCT"), 5, "XZYCT");
  check_refusal(refusal_of(other_order), "DimensionOrder is 'xzyct'");
  std::string other_size = ome(image(four_slices));
  other_size.replace(other_size.find("SizeX=\"2\""), 9, "SizeX=\"3\"");
  check_refusal(refusal_of(other_size),
                "the description has planes of 3 x 1, and the pages have 2 x 1");
}

TEST_CASE_FIXTURE(Folder, "--frame chooses positions of OME-XML") {
  const std::string two_times = "SizeZ=\"1\" SizeC=\"1\" SizeT=\"2\"";
  const std::string xml = ome(image(two_times, "<TiffData IFD=\"0\" PlaneCount=\"2\"/>", "left") +
                              image("SizeZ=\"2\" SizeC=\"1\" SizeT=\"1\"",
                                    "<TiffData IFD=\"2\" PlaneCount=\"2\"/>", "right"));
  check_refusal(refusal_of(xml),
                "the file holds 3 volumes (0 to 1 'left', 2 'right'), and one is "
                "read at a time; choose one with --frame N");
  const fs::path file = write("v.ome.tif", numbered(4, xml).bytes());
  CHECK(pages_read(file, chosen(1, {})) == Pages{1});
  CHECK(pages_read(file, chosen(2, {})) == Pages{2, 3});
}

// Files of one page each. Each file describes all files, or names the one that does.
class OmeSet : public Folder {
 public:
  explicit OmeSet(bool has_companion = false) {
    std::string data;
    for (int z = 0; z < 3; ++z)
      data += "<TiffData FirstZ=\"" + std::to_string(z) + "\" IFD=\"0\"><UUID FileName=\"" +
              name(z) + "\">urn:uuid:" + std::to_string(z) + "</UUID></TiffData>";
    const std::string all = image("SizeZ=\"3\" SizeC=\"1\" SizeT=\"1\"", data);
    if (has_companion) write("set.companion.ome", ome(all));
    for (int z = 0; z < 3; ++z) {
      const std::string own = " UUID=\"urn:uuid:" + std::to_string(z) + "\"";
      const std::string xml = has_companion
                                  ? ome("<BinaryOnly MetadataFile=\"set.companion.ome\"/>", own)
                                  : ome(all, own);
      write(name(z),
            TiffWriter()
                .page(2, 1, std::string(2, static_cast<char>(z)), {{tag::description, text(xml)}})
                .bytes());
    }
  }
  static std::string name(int z) { return "b" + std::to_string(7 - z) + ".ome.tif"; }
};

TEST_CASE("a file of an OME-TIFF set opens the whole set") {
  for (const bool has_companion : {false, true}) {
    const OmeSet set(has_companion);
    CHECK(pages_read(set.path() / OmeSet::name(1)) == Pages{0, 1, 2});
    CHECK(pages_read(set.path()) == Pages{0, 1, 2});
    check_refused(set.path() / "b[67].ome.tif",
                  "' is one of a set of 3 files; give this file alone; it names the others");
  }
}

TEST_CASE("a missing file of an OME-TIFF set is reported by name; a renamed file is still read") {
  const OmeSet set;
  fs::rename(set.path() / OmeSet::name(2), set.path() / "c.ome.tif");
  check_refused(set.path() / OmeSet::name(0),
                "the file '" + OmeSet::name(2) + "' of its set is missing");
  CHECK(pages_read(set.path() / "c.ome.tif") == Pages{0, 1, 2});
  const OmeSet companions(true);
  fs::remove(companions.path() / "set.companion.ome");
  check_refused(companions.path() / OmeSet::name(0),
                "the OME-XML is in 'set.companion.ome', which is missing");
  const Folder renamed;
  for (const std::string old_name : {"old.ome.tif", "/old.ome.tif"}) {
    const std::string data =
        "<TiffData><UUID FileName=\"" + old_name + "\">urn:1</UUID></TiffData>";
    CHECK(pages_read(
              renamed.write("v.ome.tif", numbered(4, ome(image(four_slices, data))).bytes())) ==
          Pages{0, 1, 2, 3});
  }
}

TEST_CASE_FIXTURE(Folder, "OME-TIFF that names files out of its folder is refused") {
  const std::string set =
      "<TiffData FirstZ=\"0\"><UUID FileName=\"../a.tif\">urn:0</UUID></TiffData>"
      "<TiffData FirstZ=\"1\"><UUID FileName=\"../b.tif\">urn:1</UUID></TiffData>";
  check_refused(write("v.ome.tif", numbered(4, ome(image(four_slices, set))).bytes()),
                "'../a.tif', which lies outside of its folder");
  const std::string elsewhere = ome("<BinaryOnly MetadataFile=\"../set.companion.ome\"/>");
  check_refused(write("v.ome.tif", numbered(4, elsewhere).bytes()),
                "'../set.companion.ome', which lies outside of its folder");
}

// ---- ImageJ ----

VolumeInfo info_of(const TiffWriter& tiff, const VolumeOptions& options = {}) {
  const Folder folder;
  return read_info(folder.write("v.tif", tiff.bytes()), options);
}

// A pixel is four units.
const Tags of_four_units = {{tag::x_resolution, fraction(1, 4)},
                            {tag::y_resolution, fraction(1, 4)},
                            {tag::resolution_unit, whole({1})}};

TEST_CASE("units are read in every spelling that ImageJ writes") {
  const std::vector<std::pair<std::string, double>> units = {
      {"m", 1000},     {"cm", 10},        {"mm", 1},    {"micron", 1e-3}, {"\\u00B5m", 1e-3},
      {"\xb5m", 1e-3}, {"\u00b5m", 1e-3}, {"um", 1e-3}, {"nm", 1e-6},     {"inch", 25.4}};
  for (const auto& each : units) {
    const auto& [unit, mm] = each;
    INFO(each.first);
    check_spacing(info_of(numbered(3,
                                   "ImageJ=1.54f\nimages=3\nslices=3\nunit=" + unit +
                                       "\nspacing=-2.0\nmin=0.0\nmax=255.0\n",
                                   of_four_units)),
                  {4 * mm, 4 * mm, 2 * mm});
  }
  check_spacing(
      info_of(numbered(3, "ImageJ=1\nimages=3\nunit=mm\nzunit=um\nspacing=5\n", of_four_units)),
      {4, 4, 5e-3});
  const VolumeInfo in_pixels =
      info_of(numbered(3, "ImageJ=1\nimages=3\nunit=pixel\n", of_four_units));
  CHECK(noted(in_pixels, "its unit is 'pixel', which is not a length"));
  const VolumeInfo deep = info_of(numbered(3, "ImageJ=1\nimages=3\nspacing=5\n", of_four_units));
  CHECK(noted(deep, "it has no unit; if it is mm, give --spacing 4,4,5"));
  CHECK(noted(in_pixels, "no spacing given"));
  const VolumeInfo flat = info_of(numbered(3, "ImageJ=1\nimages=3\nunit=mm\n", of_four_units));
  CHECK(noted(flat, "no distance of slices given, 1 unit assumed, as by ImageJ"));
  check_spacing(flat, {4, 4, 1});
}

TEST_CASE_FIXTURE(Tiff, "pages behind ImageJ's only directory are read or reported missing") {
  const auto file = [this](const std::string& promised, const std::string& behind) {
    return write("v.tif",
                 TiffWriter()
                     .page(2, 1, std::string(2, '\0') + behind,
                           {{279, whole({2})}, {tag::description, text("ImageJ=1\n" + promised)}})
                     .bytes());
  };
  const std::string two_pages("\1\1\2\2", 4);
  // The directory follows the samples here, and is as long as several pages.
  CHECK(pages_read(file("images=3\nslices=3\n", two_pages)) == Pages{0, 1, 2});
  CHECK(pages_read(file("images=3\nframes=3\nhyperstack=true\n", two_pages), chosen(2, {})) ==
        Pages{2});
  check_refused(file("images=2000\nslices=2000\n", two_pages),
                "the description promises 2000 planes, and the file holds ");
  check_refused(tiff(2, "ImageJ=1\nimages=3\n"), "promises 3 planes, and the file holds 2");
  check_refused(tiff(4, "ImageJ=1\nimages=3\n"), "promises 3 planes, and the file holds 4");
  check_refused(tiff(3, "ImageJ=1\nslices=0\n"), "slices is '0'");
}

TEST_CASE_FIXTURE(
    Tiff, "times of an ImageJ series are not read as slices, and the refusal advises --axes") {
  const fs::path file = tiff(3, "ImageJ=1\nimages=3\nframes=3\n");
  check_refused(file, "the file holds 3 volumes of one slice each");
  check_refused(file, "if they are slices, give --axes zyx");
  CHECK(pages_read(file, chosen(1, {})) == Pages{1});
}

TEST_CASE_FIXTURE(Tiff, "--axes names the axis of TIFF pages, as the refusal advises") {
  for (const std::string stack : {"channels=4\n", "frames=4\n", "channels=2\nframes=2\n"}) {
    const fs::path file = tiff(4, "ImageJ=1\nimages=4\n" + stack);
    check_refused(file, "of one slice each, and one is read at a time");
    check_refused(file, "the first is 0; if they are slices, give --axes zyx");
    CHECK(pages_read(file, with_axes("zyx")) == Pages{0, 1, 2, 3});
    CHECK(pages_read(file, with_axes("tyx", chosen(3, {}))) == Pages{3});
    CHECK(pages_read(file, with_axes("cyx", chosen({}, 2))) == Pages{2});
    check_refused(file, with_axes("zxy"), "not 'zxy'; give --axes zyx, cyx or tyx");
    check_refused(file, with_axes("czyx"), "one axis, not 'czyx'; give --axes zyx");
  }
  check_refused(files / "u8.png", with_axes("zyx"),
                "--axes applies to arrays and TIFF, and this is PNG");
}

TEST_CASE("ImageJ's linear calibration and origin are applied") {
  const VolumeInfo info = info_of(numbered(
      3,
      "ImageJ=1\nimages=3\nunit=mm\nspacing=2\ncf=0\nc0=-32768.0\nc1=1.0\nvunit=Gray Value\n"
      "xorigin=8\nzorigin=1\n",
      of_four_units));
  CHECK(info.slope == 1);
  CHECK(info.intercept == -32768);
  check_origin(info, {-32, 0, -2});
  CHECK(noted(info_of(numbered(3, "ImageJ=1\nimages=3\ncf=3\n")),
              "its calibration function '3' is not supported"));
}

// ---- tifffile ----

TEST_CASE_FIXTURE(Tiff, "tifffile's shape determines the axes, with or without letters") {
  const auto file = [this](const std::string& description) { return tiff(4, description); };
  CHECK(pages_read(file("{\"shape\": [4, 1, 2]}")) == Pages{0, 1, 2, 3});
  CHECK(pages_read(file("{\"shape\": [4, 1, 2, 1]}")) == Pages{0, 1, 2, 3});
  CHECK(pages_read(file("shape=(4, 1, 2)")) == Pages{0, 1, 2, 3});
  CHECK(pages_read(file("{\"shape\": [4, 1, 2], \"axes\": \"QYX\"}")) == Pages{0, 1, 2, 3});
  CHECK(pages_read(file("{\"shape\": [2, 2, 1, 2]}"), chosen(1, {})) == Pages{2, 3});
  CHECK(pages_read(file("{\"shape\": [2, 2, 1, 2], \"axes\": \"ZCYX\"}"), chosen({}, 1)) ==
        Pages{1, 3});
  check_refused(file("{\"shape\": [4, 1, 2], \"axes\": \"TYX\"}"), "holds 4 volumes");
  check_refused(file("{\"shape\": [4, 1, 2], \"axes\": \"CYX\"}"), "holds 4 channels");
  check_refused(file("{\"shape\": [9, 1, 2]}"), "promises 9 planes");
  // The metadata of another file, copied by a program.
  CHECK(pages_read(file("{\"shape\": [9, 5, 5]}")) == Pages{0, 1, 2, 3});
  CHECK(pages_read(file("{\"shape\": 9}")) == Pages{0, 1, 2, 3});
}

TEST_CASE_FIXTURE(
    Folder, "tifffile's arrays of one page are slices, and arrays of several pages are volumes") {
  TiffWriter planes;
  for (int i = 0; i < 3; ++i)
    planes.page(2, 1, std::string(2, static_cast<char>(i)),
                {{tag::description, text("{\"shape\": [1, 2]}")}});
  CHECK(pages_read(write("v.tif", planes.bytes())) == Pages{0, 1, 2});
  TiffWriter arrays;
  for (int i = 0; i < 4; ++i)
    arrays.page(2, 1, std::string(2, static_cast<char>(i)),
                i % 2 == 0 ? Tags{{tag::description, text("{\"shape\": [2, 1, 2]}")}} : Tags{});
  const fs::path two = write("v.tif", arrays.bytes());
  check_refused(two, "the file holds 2 volumes");
  CHECK(pages_read(two, chosen(1, {})) == Pages{2, 3});
}

TEST_CASE_FIXTURE(Folder, "TIFF files with several slices each are one volume only with --axes") {
  write("a/t1.tif", numbered(4, ome(image(four_slices))).bytes());
  write("a/t2.tif", numbered(4, ome(image(four_slices))).bytes());
  check_refused(path() / "a", "2 files, of which 't1.tif' alone has 4 slices",
                "--axes zyx if their slices are those of one volume");
  VolumeOptions options = with_axes("zyx");
  CHECK(read_info(path() / "a", options).dims[2] == 8);
}

// ---- other tags ----

TEST_CASE("reduced copies among TIFF pages and in their sub-directories are left out with a note") {
  const std::string large(4, '\7'), small(1, '\7');
  TiffWriter tiff;
  tiff.page(2, 2, large, {{tag::sub_directories, whole({8, 8})}});
  tiff.page(1, 1, small, {{tag::kind_of_page, whole({1})}});
  tiff.page(2, 2, large, {{tag::kind_of_page, whole({2})}});
  const VolumeInfo info = info_of(tiff);
  CHECK(info.dims == Dims{2, 2, 2});
  CHECK(noted(info, "pages that are smaller copies or masks are left out: 1"));
  CHECK(noted(info, "usually smaller copies, are left out: 2"));
}

TEST_CASE("bytes behind the only TIFF page are noted, unless the bytes may be metadata") {
  const auto notes_much = [](std::size_t behind) {
    TiffWriter tiff;
    tiff.page(256, 256, std::string(65536, 'a')).behind(std::string(behind, 'b'));
    return noted(info_of(tiff), "bytes after its only page are left out");
  };
  CHECK(notes_much(200000));
  CHECK(!notes_much(60000));
  CHECK(!notes_much(0));
}

TEST_CASE_FIXTURE(Tiff,
                  "a TIFF page whose rows begin at the bottom or right is read without mirroring") {
  const std::vector<std::pair<std::uint32_t, Spacing>> cases = {
      {1, {1, 1, 1}}, {2, {-1, 1, 1}}, {3, {-1, -1, 1}}, {4, {1, -1, 1}}};
  for (const auto& [orientation, signs] : cases) {
    const VolumeInfo info = info_of(numbered(2, "", {{tag::orientation, whole({orientation})}}));
    CHECK(info.spacing_mm == signs);
    CHECK(noted(info, "(Orientation)") == (orientation != 1));
  }
  check_refused(tiff(2, "", {{tag::orientation, whole({6})}}),
                "its rows are columns (Orientation 6)");
}

TEST_CASE("an unused TIFF resolution is noted with the --spacing that applies the resolution") {
  const Tags of_a_print = {{tag::x_resolution, fraction(254)},
                           {tag::y_resolution, fraction(127)},
                           {tag::resolution_unit, whole({2})}};
  const VolumeInfo info = info_of(numbered(2, "", of_a_print));
  CHECK(info.spacing_mm == Spacing{1, 1, 1});
  CHECK(noted(info, "is not used; to use it, give --spacing 0.1,0.2,Z"));
  VolumeOptions options;
  options.spacing_mm = {0.1, 0.2, 0.3};
  CHECK(info_of(numbered(2, "", of_a_print), options).notes.empty());
}

TEST_CASE_FIXTURE(Folder,
                  "TIFF pages that differ in size, type, resolution or colour are refused") {
  const auto refusal_with = [this](const Tags& more, const VolumeOptions& options = {}) {
    Tags first = of_four_units;
    return refusal(
        write("v.tif", TiffWriter().page(2, 1, "ab", first).page(2, 1, "cdefgh", more).bytes()),
        options);
  };
  const Tags other_resolution = {{tag::x_resolution, fraction(5)},
                                 {tag::y_resolution, fraction(4)},
                                 {tag::resolution_unit, whole({1})}};
  check_refusal(refusal_with({{256, whole({1})}}), "page 1 has 1 x 1 samples of u8");
  check_refusal(refusal_with({{tag::bits, whole({16})}}), "page 1 has 2 x 1 samples of u16");
  check_refusal(refusal_with({{tag::samples, whole({3})}}),
                "page 1 has 3 channels instead of 1, unlike v.tif");
  check_refusal(refusal_with({{tag::photometric, whole({0})}}),
                "page 1 has black and white exchanged, unlike v.tif");
  check_refusal(refusal_with({{tag::orientation, whole({4})}}),
                "page 1 has rows in another direction, unlike v.tif");
  check_refusal(
      refusal_with(other_resolution),
      "another resolution than v.tif; if its voxels have the same size, give --spacing X,Y,Z");
  VolumeOptions options;
  options.spacing_mm = {1, 1, 1};
  CHECK(read_info(path() / "v.tif", options).dims[2] == 2);
}

TEST_CASE_FIXTURE(Folder,
                  "TIFF samples of 1, 2, 4 or 12 bits are unpacked with the highest bit first") {
  const auto values_of = [this](std::uint32_t bits, const std::string& row) {
    const fs::path file =
        write("v.tif", TiffWriter().page(3, 1, row, {{tag::bits, whole({bits})}}).bytes());
    return read_samples(file);
  };
  CHECK(values_of(1, "\xa0") == std::vector<double>{1, 0, 1});
  CHECK(values_of(2, "\xe4") == std::vector<double>{3, 2, 1});
  CHECK(values_of(4, "\x12\x30") == std::vector<double>{1, 2, 3});
  CHECK(values_of(12, "\xab\xc1\x23\xfe\xd0") == std::vector<double>{0xabc, 0x123, 0xfed});
}

TEST_CASE_FIXTURE(Folder, "a TIFF palette of greys is read as grey values") {
  std::vector<std::uint32_t> greys(768);
  for (std::uint32_t i = 0; i < 768; ++i) greys[i] = (255 - i % 256) * 257;
  // Values of 16 bits, two in each value of 32 bits.
  std::vector<std::uint32_t> packed;
  for (std::size_t i = 0; i < greys.size(); i += 2) packed.push_back(greys[i] | greys[i + 1] << 16);
  std::string bytes = TiffWriter()
                          .page(2, 1, std::string("\0\x09", 2),
                                {{tag::photometric, whole({3})}, {320, whole(packed)}})
                          .bytes();
  // The tag as in the standard; libtiff expects 16 bits.
  const std::size_t at = bytes.find(std::string("\x40\x01\x04\x00\x80\x01\x00\x00", 8));
  REQUIRE(at != std::string::npos);
  bytes.replace(at, 8, std::string("\x40\x01\x03\x00\x00\x03\x00\x00", 8));
  const auto reader = open_volume(write("v.tif", bytes));
  CHECK(read_all(*reader) == std::vector<double>{255, 246});
  CHECK(!noted(reader->info(), "palette"));
}

TEST_CASE_FIXTURE(Tiff, "ScanImage pages are slices only if its metadata or --axes defines this") {
  constexpr std::uint16_t software = 305;
  const auto write_slices = [&](const std::string& slices) {
    const Tags more = {{software, text("SI.VERSION_MAJOR = 2020\nSI.hChannels.channelSave = [1;2]\n"
                                       "SI.hStackManager.numSlices = " +
                                       slices + "\n")}};
    return tiff(4, "", more);
  };
  check_refused(write_slices("2"),
                "its 4 pages are not one slice each: ScanImage also stores channels");
  CHECK(read_info(write_slices("2"), with_axes("zyx")).dims[2] == 4);
  CHECK(read_info(write_slices("4")).dims[2] == 4);
}

TEST_CASE_FIXTURE(Tiff, "TIFF variants with another layout or encoding are refused by name") {
  const auto refusal_with = [this](const Tags& more) { return refusal(tiff(2, "", more)); };
  check_refusal(refusal_with({{34412, whole({1, 2})}}), "this is Zeiss LSM");
  check_refusal(refusal_with({{33629, whole({1, 2, 3})}}), "this is MetaMorph STK");
  check_refusal(refusal_with({{34361, whole({1})}}), "this is Olympus FluoView");
  check_refusal(refusal_with({{34361, whole({1})}}), "bfconvert IN OUT.ome.tif");
  check_refusal(refusal_with({{tag::compression, whole({34712})}}),
                "its compression, number 34712");
  check_refusal(refusal_with({{tag::bits, whole({24})}}), "samples of 24 bits and format 1");
  check_refusal(refusal_with({{tag::photometric, whole({32803})}}), "the colours, of kind 32803");
}

}  // namespace
