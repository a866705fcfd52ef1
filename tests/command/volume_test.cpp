// The volume readers, on small files written here. If DISCMC_DATA names a folder of volumes with
// JSON files that describe them, these are read, too.
#include "volumes/volume.hpp"
#include "samples/iso_value.hpp"

#include "command.hpp"
#include "described_volumes.hpp"

namespace {

using namespace volume_files;
using discmc::command::json_value;
using discmc::meshing::stored_threshold;

const std::string i16 = stored(SampleType::i16);

}  // namespace

TEST_CASE_FIXTURE(Folder, "raw samples of every type and byte order are read") {
  for (const auto& [called, type] : discmc::command::sample_types) {
    for (const bool is_big_endian : {false, true}) {
      const RawLayout layout{{5, 3, 4}, type, is_big_endian};
      const std::string bytes = stored(type, is_big_endian);
      check_volume(write("v.raw", bytes), type, "raw", {layout});
      check_volume(write("v.raw.gz", gzip(bytes)), type, "raw, gzip", {layout});
    }
  }
}

TEST_CASE_FIXTURE(
    Folder,
    "--spacing applies to headerless samples, whose --dims are checked before anything is read") {
  const auto file = write("v.raw", u8);
  RawLayout layout{{5, 3, 4}};
  const Spacing spacing = {0.5, -0.25, 2};
  CHECK(read_info(file, {layout}).spacing_mm == Spacing{1, 1, 1});
  CHECK(read_info(file, {layout, spacing}).spacing_mm == spacing);
  layout.dims = {32766, 32766, 4};
  check_refused(file, {layout}, "has 60 bytes, but a volume of 32766 x 32766 x 4 u8");
  layout.dims = {32767, 1, 1};
  check_refused(file, {layout}, "dimension 1 has size 32767, outside 1 to 32766");
  layout.dims = {1, 0, 1};
  check_refused(file, {layout}, "dimension 2 has size 0");
}

TEST_CASE_FIXTURE(Folder,
                  "--spacing replaces the file's spacing and keeps the directions of axes") {
  const auto file =
      write("v.nrrd", nrrd(nrrd_u8 + "space: LPS\nspace directions: (0.5,0,0) (0,-2,0) (0,0,3)\n") +
                          "\n" + u8);
  const auto reader = open_volume(file, {{}, Spacing{1, 1.5, 2}});
  CHECK(reader->info().spacing_mm == Spacing{1, -1.5, 2});
  REQUIRE(reader->info().placement);
  CHECK(reader->info().placement->axes_mm == Axes{{{1, 0, 0}, {0, -1.5, 0}, {0, 0, 2}}});
  CHECK(read_all(*reader) == read_samples(file));
}

TEST_CASE_FIXTURE(Folder, "NRRD of every type, byte order, encoding and attachment is read") {
  const std::vector<std::pair<SampleType, std::string>> types = {
      {SampleType::u8, "uint8"},         {SampleType::u16, "unsigned short"},
      {SampleType::i16, "int16_t"},      {SampleType::i8, "int8"},
      {SampleType::u32, "unsigned int"}, {SampleType::i32, "int"},
      {SampleType::f32, "float"},        {SampleType::u64, "uint64_t"},
      {SampleType::i64, "longlong"},     {SampleType::f64, "double"}};
  for (const auto& [type, name] : types) {
    for (const bool big : {false, true}) {
      for (const bool packed : {false, true}) {
        const std::string header = nrrd("type: " + name + "\nendian: " + (big ? "big" : "little") +
                                        "\nencoding: " + (packed ? "gzip" : "raw") + "\n");
        const std::string format = packed ? "NRRD, gzip" : "NRRD, raw";
        const std::string data = packed ? gzip(stored(type, big)) : stored(type, big);
        check_volume(write("v.nrrd", header + "\n" + data), type, format);
        check_volume(write("no_extension", header + "\r\n" + data), type, format);
        write("the data", data);
        check_volume(write("v.nhdr", header + "data file: the data"), type, format + ", detached");
      }
    }
  }
}

TEST_CASE_FIXTURE(
    Folder, "NRRD's line skip applies to the file, and byte skip to the uncompressed content") {
  const std::string skips = "line skip: 2\nbyteskip: 3\n";
  const std::string gzip_u8 = "type: uchar\nencoding: gz\n";
  check_volume(write("a.nrrd", nrrd(nrrd_u8 + skips) + "\none\ntwo\nxyz" + u8), "NRRD, raw");
  check_volume(write("b.nrrd", nrrd(gzip_u8 + skips) + "\none\ntwo\n" + gzip("xyz" + u8)),
               "NRRD, gzip");
  write("c.raw", "anything before" + u8);
  check_volume(write("c.nhdr", nrrd(nrrd_u8 + "data file: c.raw\nbyte skip: -1\n")),
               "NRRD, raw, detached");
  check_refused(write("d.nrrd", nrrd(gzip_u8 + "byte skip: -1\n\n") + gzip(u8)), "byte skip -1");
  check_refused(write("e.nrrd", nrrd(nrrd_u8 + "line skip: 9\n\n") + "one\ntwo\n"),
                "of 9 lines to skip only 2 exist");
  check_refused(write("f.nrrd", nrrd(gzip_u8 + "byte skip: 99\n\n") + gzip(u8)),
                "of 99 bytes to skip 39 are missing");
  check_refused(write("g.nrrd", nrrd(nrrd_u8 + "byte skip: 9223372036854775807\n\n") + u8),
                "of 9223372036854775807 bytes to skip");
}

TEST_CASE_FIXTURE(Folder, "the spacing of NRRD is signed and in millimetres") {
  const auto info = [&](const std::string& lines) {
    return read_info(write("v.nrrd", nrrd(nrrd_u8 + lines) + "\n" + u8));
  };
  const std::string directions = "space dimension: 3\nspace directions: ";
  CHECK(info("spacings: 0.5 -2 3\n").spacing_mm == Spacing{0.5, -2, 3});
  CHECK(info("spacings: 1 2 3\nunits: \"cm\" \"\" \"um\"\n").spacing_mm == Spacing{10, 2, 0.003});
  CHECK(noted(info("spacings: 1 nan 0\n"), "no spacing of axis 2 given, 1 mm assumed"));
  CHECK(noted(info("spacings: 1 nan 0\n"), "spacing 0 of axis 3 is unusable, 1 mm assumed"));
  CHECK(noted(info(""), "no spacing"));
  CHECK(info(directions + "(-0.5,0,0) (0, 2, 0) (0,0,3)\n").spacing_mm == Spacing{-0.5, 2, 3});
  CHECK(info(directions + "(0,2,0) (-3,0,0) (0,0,4)\n").spacing_mm == Spacing{2, 3, 4});
  CHECK(info(directions + "(0,2,0) (3,0,0) (0,0,4)\n").spacing_mm == Spacing{2, 3, -4});
  CHECK(info("space: LAS\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n").spacing_mm ==
        Spacing{-1, 1, 1});
}

TEST_CASE_FIXTURE(Folder, "one of several interleaved NRRD volumes or channels is read at a time") {
  for (const auto& [called, name] : {std::pair<SampleType, std::string>{SampleType::u8, "uchar"},
                                     {SampleType::i16, "short"},
                                     {SampleType::f64, "double"}}) {
    const SampleType type = called;
    const std::size_t size = discmc::meshing::sample_bytes(type);
    const std::string bytes = stored(type, true);
    std::string samples;
    for (std::size_t at = 0; at < bytes.size(); at += size)
      samples += std::string(size, '\0') + bytes.substr(at, size) + std::string(size, '\1');
    for (const std::string kind : {"list", "vector", "3-color"}) {
      const std::string header =
          nrrd("type: " + name +
                   "\nendian: big\nspacings: nan 2 3 4\nunits: \"\" \"cm\" \"mm\" "
                   "\"a b\"\nkinds: " +
                   kind + " domain domain domain\n",
               "3 5 3 4");
      VolumeOptions options;
      auto& chosen = kind == "list" ? options.frame : options.channel;
      check_refused(write("v.nrrd", header + "encoding: raw\n\n" + samples),
                    kind == "list" ? "holds 3 volumes" : "holds 3 channels");
      chosen = 1;
      check_volume(write("v.nrrd", header + "encoding: raw\n\n" + samples), type, "NRRD, raw",
                   options);
      check_volume(write("v.nrrd", header + "encoding: gzip\n\n" + gzip(samples)), type,
                   "NRRD, gzip", options);
      write("v.raw", "xyz" + samples);
      const auto detached =
          write("v.nhdr", header + "encoding: raw\nbyte skip: -1\ndata file: v.raw\n");
      check_volume(detached, type, "NRRD, raw, detached", options);
      CHECK(read_info(detached, options).spacing_mm == Spacing{20, 3, 4});
      CHECK(noted(read_info(detached, options), "'a b'"));
      chosen = 0;
      CHECK(read_samples(detached, options) == std::vector<double>(60, 0));
      chosen = 3;
      check_refused(detached, options, "3: the file holds 3");
      chosen = 0;
      check_refused(
          write("v.nrrd", header + "encoding: raw\n\n" + samples.substr(0, samples.size() - 1)),
          options, "slice 3 (the first is 0) of 4: 1 bytes of it are missing");
    }
  }
}

TEST_CASE_FIXTURE(Folder, "colours of NIfTI and components of MetaImage are channels") {
  const auto check = [](const fs::path& file, std::uint32_t channels, const std::string& format) {
    INFO(file.filename().string(), " of ", channels);
    VolumeOptions options;
    check_refused(file, "holds " + std::to_string(channels) + " channels");
    options.channel = 1;
    check_volume(file, format, options);
    options.channel = 2;
    CHECK(read_samples(file, options) == std::vector<double>(voxels, 2));
    options.channel = channels;
    check_refused(file, options, "there is no channel");
  };
  for (const std::uint32_t channels : {3U, 4U}) {
    std::string samples;
    for (const char sample : u8)
      samples += std::string(1, '\0') + sample + std::string(channels - 2, '\2');
    check(write("v.nii", Nifti().type(channels == 3 ? 128 : 2304).file(samples)), channels,
          "NIfTI-1");
    const std::string header =
        metaimage(metaimage_u8 + "ElementNumberOfChannels = " + std::to_string(channels) + "\n");
    check(write("v.mha", header + "ElementDataFile = LOCAL\n" + samples), channels,
          "MetaImage, raw");
    check(write("z.mha", header + "CompressedData = True\nElementDataFile = LOCAL\n" +
                             deflated(samples, Wrapper::zlib)),
          channels, "MetaImage, zlib");
  }
}

TEST_CASE_FIXTURE(Folder, "unsupported NRRD is refused by name") {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {nrrd("type: block\nencoding: raw\n\n"), "type 'block'"},
      {nrrd("type: char\nencoding: raw\n\n"), "one number per voxel"},
      {nrrd("type: uchar\nencoding: hex\n\n"), "encoding 'hex'"},
      {nrrd("type: short\nencoding: raw\n\n"), "'endian' is missing"},
      {nrrd("type: short\nencoding: raw\nendian: pdp\n\n"), "endian is 'pdp'"},
      {nrrd(nrrd_u8 + "endain: big\n\n"), "'endain' is unknown"},
      {nrrd(nrrd_u8 + "type: uchar\n\n"), "'type' is given twice"},
      {nrrd(nrrd_u8 + "kinds: 3-color domain domain\n\n"), "kind '3-color'"},
      {nrrd(nrrd_u8 + "kinds: 3-color domain domain\n\n"), "unu slice -p 0 -a 0 -i in.nrrd"},
      {nrrd(nrrd_u8 + "kinds: domain list domain domain\n\n", "5 2 3 4"),
       "axis 2 is of kind 'list'; make it the last one, e.g. with: unu permute -p 0 2 3 1 -i"},
      {nrrd(nrrd_u8 + "space directions: none (1,0,0) (0,1,0)\n\n"), "axis 1 has no direction"},
      {nrrd(nrrd_u8 + "space directions: (1,0,0) (0,1,0) none (0,0,1)\n\n", "5 3 2 4"),
       "axis 3 has no direction in space; make it the last one"},
      {nrrd(nrrd_u8 + "kinds: list domain domain domain\n\n", "2 5 3 4") + u8 + u8,
       "holds 2 volumes"},
      {nrrd(nrrd_u8 + "kinds: list domain domain domain\n\n", "200000 30000 3 4"),
       "200000 samples per voxel make the rows too long"},
      {nrrd(nrrd_u8 + "space directions: (1,0,0,0) (1,0,0) (0,1,0)\n\n"), "not a vector of up to"},
      {nrrd(nrrd_u8 + "space directions: (1,0,0) (0,1,0)\n\n"), "2 entries for 3 dimensions"},
      {nrrd(nrrd_u8 + "spacings: 1\n\n"), "1 entries for 3 dimensions"},
      {nrrd(nrrd_u8 + "data file: LIST\nabsent\nb\n"), "absent: there is no such file"},
      {nrrd(nrrd_u8 + "data file: LIST\n"), "list of data files is empty"},
      {nrrd(nrrd_u8 + "data file: %99999d.raw 1 4 1\n"), "not a pattern with a range"},
      {nrrd(nrrd_u8 + "data file: absent.raw\n"), "no such file"},
      {nrrd(nrrd_u8 + "data file: .\n"), "neither a file nor a pipe"},
      {nrrd(nrrd_u8), "no end"},
      {nrrd(nrrd_u8 + "\n", "5 3"), "slice 0 (the first is 0) of 1: 15 bytes"},
      {nrrd(nrrd_u8 + "\n", "5 3 4 2") + u8, "holds 2 volumes"},
      {nrrd(nrrd_u8 + "\n", "5 0 4"), "dimension 2 has size 0"},
      {nrrd(nrrd_u8 + "\n", "5 -3 4"), "dimension 2 has size -3"},
      {nrrd(nrrd_u8 + "\n", "5 3 99999999999999999999"), "not a whole number in range"},
      {"NRRD0006\n", "'NRRD0006'"},
      {"", "begins with ''"},
  };
  // Names that do not occur in messages by chance: the file is v.nrrd, the parts have other names.
  for (const auto& [bytes, part] : cases) check_refusal(error_of(write("v.nrrd", bytes)), part);
}

TEST_CASE_FIXTURE(Folder, "a fourth dimension of size 1 is dropped with a note in every format") {
  for (const auto& file :
       {write("v.nrrd", nrrd(nrrd_u8 + "\n", "5 3 4 1") + u8),
        write("v.mha", metaimage(metaimage_u8 + "ElementDataFile = LOCAL\n", "5 3 4 1") + u8),
        write("v.nii", Nifti().dims({4, 5, 3, 4, 1}).file(u8))})
    CHECK(noted(read_info(file), "dimension 4 of size 1 is dropped"));
}

TEST_CASE_FIXTURE(Folder, "NIfTI axes beyond the third with size 0 are ignored") {
  check_volume(write("v.nii", Nifti().dims({5, 5, 3, 4, 0, 0}).file(u8)), "NIfTI-1");
}

// container_table_test reads files of either byte order.
TEST_CASE_FIXTURE(
    Folder,
    "NIfTI is read without an extension, compressed, in pairs and in concatenated gzip members") {
  check_volume(write("no_extension", Nifti(true).type(4).file(stored(SampleType::i16, true))),
               SampleType::i16, "NIfTI-1");
  write("pair.img", u8);
  const std::string header = Nifti().pair().header();
  check_volume(write("pair.hdr", header), "NIfTI-1 pair");
  check_volume(path() / "pair.img", "NIfTI-1 pair");
  write("packed.img.gz", gzip(u8));
  check_volume(write("packed.hdr", header), "NIfTI-1 pair, gzip");
  const std::string file = Nifti().real(108, 360).file("extended" + u8);
  check_volume(write("later.nii", file), "NIfTI-1");
  const std::size_t half = file.size() / 2;
  check_volume(write("two.nii.gz", gzip(file.substr(0, half)) + gzip(file.substr(half))),
               "NIfTI-1, gzip");
}

TEST_CASE_FIXTURE(Folder, "scale and signed spacing of NIfTI are read") {
  const auto info = [&](const Nifti& nifti) { return read_info(write("v.nii", nifti.file(u8))); };
  CHECK(info(Nifti().scale(0.01F, -3)).slope == 0.01);
  CHECK(info(Nifti().scale(0.01F, -3)).intercept == -3);
  CHECK(info(Nifti().scale(0, -3)).slope == 1);
  CHECK(info(Nifti().scale(0, -3)).intercept == 0);
  for (const float none : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
    const VolumeInfo unscaled = info(Nifti().scale(none, none));
    CHECK(unscaled.slope == 1);
    CHECK(unscaled.intercept == 0);
    CHECK(noted(unscaled, "scl_slope is "));
  }
  Nifti nifti;
  nifti.real(80, 0.5F).real(84, 2).real(88, 3);
  CHECK(info(nifti).spacing_mm == Spacing{0.5, 2, 3});
  Nifti metres = nifti;
  metres.integer(123, 1, 1);
  CHECK(info(metres).spacing_mm == Spacing{500, 2000, 3000});
  // sform: x runs backwards, with an origin.
  Nifti mirrored = nifti;
  mirrored.sform({-0.5F, 0, 0, 90, 0, 2, 0, 0, 0, 0, 3, 0});
  CHECK(info(mirrored).spacing_mm == Spacing{-0.5, 2, 3});
  // qform: no rotation, but qfac turns z.
  Nifti turned = nifti;
  turned.integer(252, 2, 1).real(76, -1);
  CHECK(info(turned).spacing_mm == Spacing{0.5, 2, -3});
}

TEST_CASE_FIXTURE(Folder, "unsupported NIfTI is refused by name") {
  const auto check = [&](const std::string& bytes, const std::string& part) {
    check_refused(write("v.nii", bytes), part);
  };
  check(Nifti().type(32).file(u8), "COMPLEX64");
  check(Nifti().scale(-2, 0).file(u8), "negative slope");
  check(Nifti().scale(2, std::numeric_limits<float>::infinity()).file(u8), "not finite");
  check(Nifti().dims({4, 5, 3, 4, 2}).file(u8), "holds 2 volumes");
  check(Nifti().dims({3, 5, 0, 4}).file(u8), "dimension 2 has size 0");
  check(Nifti().dims({3, -5, 3, 4}).file(u8), "dimension 1 has size -5");
  check(Nifti().dims({9, 5, 3, 4}).file(u8), "9 dimensions");
  check(Nifti().integer(0, 4, 540).file(u8 + u8 + u8 + u8), "magic of NIfTI-2");
  check(Nifti().integer(0, 4, 541).file(u8), "size 541");
  check(Nifti().integer(344, 4, 0).file(u8), "no .img or .img.gz beside it");
  check(Nifti().real(108, -1).file(u8), "vox_offset");
  check(Nifti().real(108, 1000).file(u8), "of 648 bytes to skip 588 are missing");
  check(Nifti().pair().file(u8), "no .img or .img.gz beside it");
  check(Nifti().file(u8).substr(0, 347), "348 bytes");
  check_refused(write("v.img", u8), "no .hdr or .hdr.gz beside it");
}

TEST_CASE_FIXTURE(Folder, "MetaImage of every type, order, compression and attachment is read") {
  const std::vector<std::pair<SampleType, std::string>> types = {
      {SampleType::u8, "MET_UCHAR"},       {SampleType::u16, "MET_USHORT"},
      {SampleType::i16, "MET_SHORT"},      {SampleType::i8, "MET_CHAR_ARRAY"},
      {SampleType::u32, "MET_UINT"},       {SampleType::i32, "MET_INT"},
      {SampleType::u32, "MET_ULONG"},      {SampleType::i32, "MET_LONG"},
      {SampleType::u64, "MET_ULONG_LONG"}, {SampleType::i64, "MET_LONG_LONG"},
      {SampleType::f32, "MET_FLOAT"},      {SampleType::f64, "MET_DOUBLE"}};
  for (const auto& [type, name] : types) {
    for (const bool big : {false, true}) {
      for (const bool packed : {false, true}) {
        const std::string header =
            metaimage("ElementByteOrderMSB = " + std::string(big ? "True" : "False") +
                      "\nCompressedData = " + (packed ? "True" : "False") +
                      "\nElementType = " + name + "\nElementDataFile = ");
        const std::string format = packed ? "MetaImage, zlib" : "MetaImage, raw";
        const std::string plain = stored(type, big);
        const std::string data = packed ? deflated(plain, Wrapper::zlib) : plain;
        check_volume(write("v.mha", header + "LOCAL\n" + data), type, format);
        check_volume(write("no_extension", header + "LOCAL\r\n" + data), type, format);
        write("v.data", data);
        check_volume(write("v.mhd", header + "v.data"), type, format + ", detached");
      }
    }
  }
  write("v.data", "before" + u8);
  for (const std::string size : {"6", "-1"})
    check_volume(write("v.mhd", metaimage(metaimage_u8 + "HeaderSize = " + size +
                                          "\nElementDataFile = v.data\n")),
                 "MetaImage, raw, detached");
}

TEST_CASE_FIXTURE(Folder, "signed spacing and scale of MetaImage are read") {
  const auto info = [&](const std::string& lines) {
    const std::string header = metaimage(metaimage_u8 + lines + "ElementDataFile = LOCAL\n");
    return read_info(write("v.mha", header + u8));
  };
  CHECK(info("ElementSpacing = 0.5 -2 3\n").spacing_mm == Spacing{0.5, -2, 3});
  CHECK(info("ElementSpacing = 0.5 2 3\nTransformMatrix = 1 0 0 0 -1 0 0 0 1\n").spacing_mm ==
        Spacing{0.5, -2, 3});
  const auto scaled =
      info("ElementToIntensityFunctionSlope = 0.5\nElementToIntensityFunctionOffset = -1024\n");
  CHECK(scaled.slope == 0.5);
  CHECK(scaled.intercept == -1024);
}

TEST_CASE_FIXTURE(Folder, "unsupported MetaImage is refused by name") {
  const auto check = [&](const std::string& lines, const std::string& part,
                         const std::string& sizes = "5 3 4") {
    check_refused(write("v.mha", metaimage(lines, sizes) + u8), part);
  };
  const std::string local = "ElementDataFile = LOCAL\n";
  check("ElementType = MET_OTHER\n" + local, "'MET_OTHER'");
  check(metaimage_u8 + "BinaryData = False\n" + local, "not a sample of type u8");
  check(metaimage_u8 + "ElementNumberOfChannels = 0\n" + local, "ElementNumberOfChannels is 0");
  check(metaimage_u8 + "ElementToIntensityFunctionSlope = -1\n" + local, "negative slope");
  check(metaimage_u8 + "ElementSpacing = 1 one 1\n" + local, "'one'");
  check(metaimage_u8 + "ElementSpacing = 1 1\n" + local, "2 numbers for 3 dimensions");
  check(metaimage_u8 + "CompressedData = maybe\n" + local, "CompressedData is 'maybe'");
  check(metaimage_u8 + "HeaderSize = -2\n" + local, "HeaderSize is -2");
  check(metaimage_u8 + "ElementDataFile = v%03d.raw 1 4 1\n", "there is no such file");
  check(metaimage_u8 + local, "holds 2 volumes", "5 3 4 2");
  check(metaimage_u8 + local, "dimension 3 has size 0", "5 3 0");
  check(metaimage_u8, "no equals sign");
  check("ObjectType = Tube\n", "'ObjectType' is given twice");
  check_refused(write("v.mhd", "NDims = 3\n"), "ElementDataFile is missing");
}

TEST_CASE_FIXTURE(
    Folder, "samples that end early are refused with the slice and the number of missing bytes") {
  const std::string header = nrrd("type: short\nendian: little\nencoding: raw\n\n");
  for (const std::size_t kept : {0U, 29U, 30U, 31U, 119U}) {
    const auto file = write("v.nrrd", header + i16.substr(0, kept));
    check_refused(file, "slice " + std::to_string(kept / 30) + " (the first is 0) of 4: " +
                            std::to_string(30 - kept % 30) + " bytes of it are missing");
  }
  const auto file = write("whole.nrrd", header + i16);
  const auto reader = open_volume(file);
  read_all(*reader);
  char slice[30];
  CHECK_THROWS_AS(reader->read_slice(slice), VolumeError);
}

TEST_CASE_FIXTURE(Folder, "compressed samples that end early or are damaged are refused") {
  const std::string header = nrrd("type: short\nendian: little\nencoding: gzip\n\n");
  const std::string packed = gzip(i16);
  for (std::size_t kept = 0; kept < packed.size(); ++kept)
    check_refused(write("v.nrrd", header + packed.substr(0, kept)), "slice ");
  std::string wrong_checksum = packed;
  wrong_checksum[packed.size() - 8] = static_cast<char>(wrong_checksum[packed.size() - 8] ^ 1);
  check_refused(write("v.nrrd", header + wrong_checksum), "damaged");
  check_refused(write("v.nrrd", header + i16), "incorrect header check");
  check_refused(write("v.nrrd", header + gzip(i16.substr(0, 75))),
                "slice 2 (the first is 0) of 4: 15 bytes of it are missing");
}

TEST_CASE_FIXTURE(
    Folder, "a file of unknown format, a folder without a volume and a missing file are refused") {
  check_refused(write("v.dat", "DICM"), "format is unknown");
  check_refused(write("v.dat", "%PDF-1.4"), "this is PDF, which is not supported");
  check_refused(write("v.DMC", ""), "a stream, not a volume; give it to discmc decode");
  for (const std::string mesh : {"v.stl", "v.PLY", "v.3mf", "v.vtp"})
    check_refused(write(mesh, "<?xml"), "a mesh, not a volume; give the volume");
  check_refused(path() / std::string(300, 'v'), "name is longer than the system");
  check_refused(path() / "absent.nii", "no such file");
  fs::create_directory(path() / "folder.nrrd");
  check_refused(path() / "folder.nrrd", "holds no DICOM files and no pictures");
}

TEST_CASE(
    "a stored sample reaches the stored threshold exactly if the scaled sample reaches --iso") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto threshold = [](double slope, double intercept, double iso) {
    VolumeInfo info;
    info.slope = slope;
    info.intercept = intercept;
    return stored_threshold(info, iso);
  };
  CHECK(threshold(1, 0, 500) == 500);
  CHECK(threshold(1, 0, 500.001) == 501);
  CHECK(threshold(1, -1024, -524) == 500);
  CHECK(threshold(0.5, 0, -0.75) == -1);
  for (int stored = -1000; stored <= 1000; ++stored)
    for (const double slope : {0.01, 0.1, 0.3, 0.7, 1.1, 2.5, 1.0 / 3})
      for (const double intercept : {0.0, 0.1, -1024.0, 32767.3}) {
        const double iso = slope * stored + intercept;
        CHECK(threshold(slope, intercept, iso) == stored);
        CHECK(threshold(slope, intercept, iso + 0.01 * slope) == stored + 1);
        CHECK(threshold(slope, intercept, iso - 0.01 * slope) == stored);
      }
  CHECK(threshold(0.3, 0, 0.9) == 3);    // 0.3 * 3 is less than 0.9 in double
  CHECK(threshold(0.01, 0, 0.07) == 7);  // 0.07 / 0.01 is more than 7
  CHECK(threshold(1, 0, 1e300) == INT32_MAX);
  CHECK(threshold(1, 0, -1e300) == INT32_MIN);
  CHECK(threshold(1e-300, 0, 1) == INT32_MAX);
  CHECK(threshold(1, 0, infinity) == INT32_MAX);
  CHECK(threshold(1, 0, -infinity) == INT32_MIN);
  CHECK(threshold(1, 0, std::nan("")) == INT32_MAX);
}

TEST_CASE("the volumes of DISCMC_DATA match their descriptions") {
  const char* folder = std::getenv("DISCMC_DATA");
  if (folder == nullptr || !fs::is_directory(folder)) return;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    INFO(entry.path().filename().string());
    const std::string json = contents(entry.path());
    const auto numbers = [&](const std::string& name) {
      std::string list = json_value(json, name);
      std::replace(list.begin(), list.end(), ',', ' ');
      std::istringstream in(list);
      std::vector<double> result;
      for (double value = 0; in >> value;) result.push_back(value);
      REQUIRE(result.size() == 3);
      return result;
    };
    const auto reader = open_volume(fs::path(folder) / json_value(json, "file"));
    const VolumeInfo& info = reader->info();
    CHECK(name(info.type) == json_value(json, "type"));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      CHECK(info.dims[axis] == numbers("dims")[axis]);
      CHECK(info.spacing_mm[axis] == doctest::Approx(numbers("spacing")[axis]));
    }
    const auto samples = read_all(*reader);
    CHECK(samples.size() == std::size_t{info.dims[0]} * info.dims[1] * info.dims[2]);
  }
}
