// Slices in the format of SkyScan's NRecon: BMP with a log.
#include "volume_files.hpp"

namespace {

using namespace volume_files;

std::string little(std::uint32_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> 8 * i & 0xff);
  return text;
}

// A picture of 3 by 2 voxels.
struct Bmp {
  std::uint32_t bits = 8;
  bool is_from_the_top = false;
  std::uint32_t compression = 0;
  std::uint32_t colours = 256;
  std::uint32_t pixels_per_metre = 0;
  std::string palette = {};  ///< empty: a grey palette in order
  std::string gap = {};      ///< bytes between the palette and the pixels
  std::string rows = std::string("\1\2\3\0\4\5\6\0", 8);

  std::string bytes() const {
    std::string greys;
    for (std::uint32_t i = 0; i < colours; ++i) greys += little(i * 0x10101, 4);
    const std::string& all = palette.empty() ? greys : palette;
    const auto at = static_cast<std::uint32_t>(54 + all.size() + gap.size());
    const std::uint32_t height = is_from_the_top ? 0xfffffffe : 2;
    return "BM" + little(at + static_cast<std::uint32_t>(rows.size()), 4) + little(0, 4) +
           little(at, 4) + little(40, 4) + little(3, 4) + little(height, 4) + little(1, 2) +
           little(bits, 2) + little(compression, 4) + little(0, 4) + little(pixels_per_metre, 4) +
           little(pixels_per_metre, 4) + little(colours, 4) + little(0, 4) + all + gap + rows;
  }
};

std::vector<double> samples(const Bmp& bmp, std::optional<std::uint32_t> channel = {}) {
  const Folder folder;
  return read_all(*open_volume(folder.write("v.bmp", bmp.bytes()), of_channel(channel)));
}

TEST_CASE("BMP rows begin with the lowest, unless the height is negative") {
  Bmp bmp;
  CHECK(samples(bmp) == std::vector<double>{4, 5, 6, 1, 2, 3});
  bmp.is_from_the_top = true;
  CHECK(samples(bmp) == std::vector<double>{1, 2, 3, 4, 5, 6});
  bmp.gap = std::string(56, 'x');  // as NRecon has it
  CHECK(samples(bmp) == std::vector<double>{1, 2, 3, 4, 5, 6});
}

TEST_CASE("BMP of less than 8 bits, and a channel of a colour BMP, are read") {
  Bmp bits;
  bits.bits = 1;
  bits.palette = little(0, 4) + little(0xffffff, 4);
  bits.rows = "\xa0" + std::string(3, '\0') + "\x60" + std::string(3, '\0');
  CHECK(samples(bits) == std::vector<double>{0, 255, 255, 255, 0, 255});
  Bmp nibbles;
  nibbles.bits = 4;
  nibbles.colours = 16;
  nibbles.rows = "\x12\x30" + std::string(2, '\0') + "\x45\x60" + std::string(2, '\0');
  CHECK(samples(nibbles) == std::vector<double>{4, 5, 6, 1, 2, 3});
  Bmp colours;
  colours.bits = 24;
  colours.colours = 0;
  colours.rows = std::string("bgrBGR123\0\0\0", 12) + std::string("cgsCGS456\0\0\0", 12);
  CHECK(samples(colours, 0) == std::vector<double>{'s', 'S', '6', 'r', 'R', '3'});
  CHECK(samples(colours, 2) == std::vector<double>{'c', 'C', '4', 'b', 'B', '1'});
  colours.bits = 32;
  colours.rows = std::string("bgr-BGR-123-", 12) + std::string("cgs-CGS-456-", 12);
  CHECK(samples(colours, 1) == std::vector<double>{'g', 'G', '5', 'g', 'G', '2'});
}

TEST_CASE_FIXTURE(Folder, "a BMP palette of greys is applied, and a palette of colours is noted") {
  Bmp bmp;
  bmp.palette = little(0, 4) + little(0xff0000, 4) + std::string(254 * 4, '\1');
  const auto reds = open_volume(write("v.bmp", bmp.bytes()));
  CHECK(noted(reds->info(), "numbers of colours in a palette"));
  CHECK(read_all(*reds) == std::vector<double>{4, 5, 6, 1, 2, 3});
  bmp.palette.clear();
  for (std::uint32_t i = 0; i < 256; ++i) bmp.palette += little((255 - i) * 0x10101, 4);
  CHECK(samples(bmp) == std::vector<double>{251, 250, 249, 254, 253, 252});
}

TEST_CASE_FIXTURE(Folder, "BMP pictures whose palettes differ are refused") {
  Bmp bmp;
  bmp.palette = little(0, 4) + little(0xff0000, 4) + std::string(254 * 4, '\1');
  write("a1.bmp", bmp.bytes());
  bmp.palette = little(0, 4) + little(0x00ff00, 4) + std::string(254 * 4, '\1');
  write("a2.bmp", bmp.bytes());
  check_refused(path(), "has another palette, unlike a1.bmp");
}

TEST_CASE_FIXTURE(Folder, "unsupported or truncated BMP is refused") {
  Bmp packed;
  packed.compression = 1;
  check_refused(write("v.bmp", packed.bytes()), "of 8 bits and compression 1");
  const std::string whole = Bmp().bytes();
  for (const std::size_t size : {2U, 20U, 53U, 60U, 1077U, 1080U}) {
    INFO(size);
    check_refused(write("v.bmp", whole.substr(0, size)), "the BMP file is cut off");
  }
}

// ---- the log ----

class SkyScan : public Folder {
 public:
  explicit SkyScan(const std::string& reconstruction, const std::string& log = "s_rec.log") {
    for (const std::string number : {"0007", "0008", "0009"})
      write("s_rec" + number + ".bmp", Bmp().bytes());
    Bmp overview;
    overview.colours = 16;
    write("s_rec_spr.bmp", overview.bytes());
    write(log,
          "[System]\r\nCamera Pixel Size (um)= 50.0\r\n[Acquisition]\r\n"
          "Image Pixel Size (um)= 26.8\r\nPixel Size (um)=99\r\n[Reconstruction]\r\n" +
              reconstruction);
  }
};

TEST_CASE("the spacing of SkyScan slices is the pixel size of the reconstruction in the log") {
  const SkyScan scan(
      "Result Image Width (pixels)=3\r\nResult Image Height (pixels)=2\r\n"
      "Section to Section Step=2\r\nPixel Size (um)=12.50\r\n");
  for (const fs::path& name : {scan.path(), scan.path() / "*.bmp", scan.path() / "s_rec*.bmp"}) {
    const VolumeInfo info = read_info(name);
    CHECK(info.format == "BMP");
    CHECK(info.dims == Dims{3, 2, 3});
    CHECK(info.spacing_mm == Spacing{0.0125, 0.0125, 0.025});
    CHECK(noted(info, "spacing from 's_rec.log'"));
    CHECK(noted(info, "'s_rec_spr.bmp' is an overview, and is left out"));
  }
  CHECK(read_info(scan.path(), {{}, Spacing{1, 2, 3}}).spacing_mm == Spacing{1, 2, 3});
}

TEST_CASE(
    "a SkyScan log for slices of another size is ignored; without a reconstructed pixel size, the "
    "scan's applies") {
  const SkyScan other("Result Image Width (pixels)=1000\r\nPixel Size (um)=12.50\r\n");
  CHECK(noted(read_info(other.path()),
              "'s_rec.log' describes slices of another size, and is not used"));
  CHECK(noted(read_info(other.path()), "no spacing given"));
  for (const SkyScan& none :
       {SkyScan("Result Image Width (pixels)=3\r\nResult Image Height (pixels)=2\r\n"),
        SkyScan("Pixel Size (um)=0\r\n")})
    CHECK(read_info(none.path()).spacing_mm[0] == doctest::Approx(0.0268));
  const SkyScan elsewhere("Pixel Size (um)=12.50\r\n", "other.log");
  CHECK(noted(read_info(elsewhere.path()), "no spacing given"));
}

TEST_CASE("without files named as slices, SkyScan's overview is read") {
  const SkyScan scan("");
  CHECK(read_info(scan.path() / "s_rec_spr.bmp").dims[2] == 1);
}

}  // namespace
