// Zarr and OME-Zarr: the choice of the array, its orientation, and the storage of its chunks.
// The test container_table reads the files of zarr in Python and of zarrita.
#include "command.hpp"
#include "zip_files.hpp"

namespace {

using namespace volume_files;

const fs::path files = fs::path(DISCMC_SOURCE_DIR) / "tests/command/volumes/zarr";

std::string shape_json(const std::vector<int>& sizes) {
  std::string text;
  for (const int size : sizes) text += (text.empty() ? "[" : ", ") + std::to_string(size);
  return text + "]";
}

const std::string zyx_axes = R"([{"name": "z", "type": "space", "unit": "micrometer"},)"
                             R"( {"name": "y", "type": "space", "unit": "micrometer"},)"
                             R"( {"name": "x", "type": "space", "unit": "micrometer"}])";

std::string dataset(const std::string& path, const std::string& scale,
                    const std::string& further = "") {
  return R"({"path": ")" + path +
         R"(", "coordinateTransformations": [{"type": "scale", "scale": )" + scale + "}" + further +
         "]}";
}

struct ZarrFolder : Folder {
  const fs::path array = path() / "array.zarr", image = path() / "image.zarr";

  // An uncompressed array of version 2 in one chunk.
  void write_array(const fs::path& folder, const std::vector<int>& sizes,
                   const std::string& samples, const std::string& dtype = "|u1") const {
    write(folder / ".zarray",
          R"({"zarr_format": 2, "shape": )" + shape_json(sizes) + R"(, "chunks": )" +
              shape_json(sizes) + R"(, "dtype": ")" + dtype +
              R"(", "compressor": null, "fill_value": 0, "order": "C", "filters": null})");
    std::string key = "0";
    for (std::size_t axis = 1; axis < sizes.size(); ++axis) key += ".0";
    write(folder / key, samples);
  }
  void write_image(const fs::path& folder, const std::string& axes, const std::string& datasets,
                   const std::string& further = "") const {
    write(folder / ".zgroup", R"({"zarr_format": 2})");
    write(folder / ".zattrs", R"({"multiscales": [{"version": "0.4", "axes": )" + axes +
                                  R"(, "datasets": [)" + datasets + "]" + further + "}]}");
  }
};

TEST_CASE_FIXTURE(ZarrFolder,
                  "the finest or the chosen level of OME-Zarr is read with the level's own scale") {
  const fs::path ome = path() / "image.ome.zarr";
  write_image(ome, zyx_axes,
              dataset("full", "[2000, 750, 500]") + ", " + dataset("half", "[4000, 1500, 1000]"));
  write_array(ome / "full", {4, 3, 5}, u8);
  write_array(ome / "half", {2, 2, 3}, std::string(12, '\7'));
  check_volume(ome, "OME-Zarr, level 0 of 2");
  const VolumeInfo info = read_info(ome);
  CHECK(info.spacing_mm == Spacing{0.5, 0.75, 2});
  CHECK(info.notes.empty());
  VolumeOptions options = with(&VolumeOptions::level, 1);
  const auto half = open_volume(ome, options);
  CHECK(half->info().format == "OME-Zarr, level 1 of 2");
  CHECK(half->info().dims == Dims{3, 2, 2});
  CHECK(half->info().spacing_mm == Spacing{1, 1.5, 4});
  options.level = 2;
  check_refused(ome, options, "no level 2: the image has 2; choose one with --level 0 to 1");
  // Also by the folder of its array, which is then a level of the image.
  check_volume(ome / "full", "OME-Zarr, level 0 of 2");
  check_volume(ome / "full" / "", "OME-Zarr, level 0 of 2");
  CHECK(read_info(ome / "half").spacing_mm == Spacing{1, 1.5, 4});
}

TEST_CASE_FIXTURE(
    ZarrFolder,
    "an OME-Zarr level whose path leads out of the image is refused; sub-folders are accepted") {
  write_array(path() / "outside", {4, 3, 5}, u8);
  for (const std::string level : {"../outside", "a/../../outside", "/outside", R"(..\\outside)"}) {
    CAPTURE(level);
    write_image(image, zyx_axes, dataset(level, "[1, 1, 1]"));
    check_refused(image, "outside', which lies outside of its folder");
  }
  write_image(image, zyx_axes, dataset("a/full", "[1, 1, 1]"));
  write_array(image / "a" / "full", {4, 3, 5}, u8);
  check_volume(image, "OME-Zarr");
}

TEST_CASE_FIXTURE(ZarrFolder, "an OME-Zarr level with too large slices is skipped") {
  write_image(image, zyx_axes, dataset("0", "[1, 1, 1]") + ", " + dataset("1", "[4, 3, 5]"));
  write_array(image / "0", {4, 3, 40000}, u8);
  write_array(image / "1", {4, 3, 5}, u8);
  check_volume(image, "OME-Zarr, level 1 of 2");
  check_refused(image, with(&VolumeOptions::level, 0), "size 40000, outside 1 to 32766");
}

TEST_CASE_FIXTURE(
    ZarrFolder, "OME-Zarr scales and translations of a level and of the whole image are combined") {
  write_image(
      image, zyx_axes,
      dataset("0", "[2, 1, 1]", R"(, {"type": "translation", "translation": [10, 20, 30]})"),
      R"(, "coordinateTransformations": [{"type": "scale", "scale": [1000, 1000, 500]}])");
  write_array(image / "0", {4, 3, 5}, u8);
  const VolumeInfo info = read_info(image);
  check_grid(info, {0.5, 1, 2}, {15, 20, 10});
}

TEST_CASE_FIXTURE(ZarrFolder,
                  "each OME-Zarr axis has its own unit, and a missing or unknown unit is noted") {
  write_array(image / "0", {4, 3, 5}, u8);
  write_image(
      image,
      R"([{"name": "z", "type": "space", "unit": "nanometer"},)"
      R"( {"name": "y", "type": "space", "unit": "parsec"}, {"name": "x", "type": "space"}])",
      dataset("0", "[4000000, 2, 3]"));
  const VolumeInfo info = read_info(image);
  CHECK(info.spacing_mm == Spacing{3, 2, 4});
  CHECK(noted(info, "no unit of length given, mm assumed"));
  CHECK(noted(info, "unit 'parsec' is unknown, mm assumed"));
}

TEST_CASE_FIXTURE(ZarrFolder,
                  "--frame and --channel choose a time and a channel of OME-Zarr, and refusals "
                  "list channel names") {
  write_image(
      image,
      R"([{"name": "t", "type": "time"}, {"name": "c", "type": "channel"},)" + zyx_axes.substr(1),
      dataset("0", "[1, 1, 2000, 750, 500]"));
  const std::string other(60, '\1');
  write_array(image / "0", {2, 2, 4, 3, 5}, other + other + other + u8);
  VolumeOptions options = of_frame(1);
  check_refused(image, options, "holds 2 channels, and one is read at a time");
  options.channel = 1;
  check_volume(image, "OME-Zarr", options);
  options.frame.reset();
  check_refused(image, options, "holds 2 volumes");

  write(image / ".zattrs", R"({"multiscales": [{"datasets": [{"path": "0"}]}],)"
                           R"( "omero": {"channels": [{"label": "DAPI"}, {"label": "GFP"}]}})");
  options.frame = 1;
  options.channel.reset();
  check_refused(image, options, "holds 2 channels ('DAPI', 'GFP')");
  options.channel = 1;
  check_volume(image, "OME-Zarr", options);
  CHECK(noted(read_info(image, options), "no spacing given, 1 mm assumed"));
}

TEST_CASE_FIXTURE(
    ZarrFolder,
    "missing Zarr chunks have the fill value, and an array without any chunk is refused") {
  const auto write_metadata = [this](const std::string& dtype, const std::string& fill) {
    write(array / ".zarray",
          R"({"zarr_format": 2, "shape": [2, 3, 4], "chunks": [1, 2, 3], "dtype": ")" + dtype +
              R"(", "compressor": null, "fill_value": )" + fill + R"(, "order": "C"})");
  };
  write_metadata("<i2", "-7");
  check_refused(array, "the array has no chunk");
  write(array / "1.1.1", std::string("\1\0\2\0\3\0\4\0\5\0\6\0", 12));
  const auto samples = read_samples(array);
  std::vector<double> expected(24, -7);
  expected[23] = 1;  // the rest of the chunk lies outside
  CHECK(samples == expected);
  write_metadata("<f2", "\"NaN\"");
  CHECK(std::isnan(read_samples(array)[0]));
  write_metadata("<i2", "\"words\"");
  check_refused(array, "the fill value '\"words\"' is not a sample");
}

TEST_CASE_FIXTURE(ZarrFolder, "64-bit labels in Zarr keep all their bits") {
  const std::vector<std::uint64_t> ids = {720575940621039145, 720575940621039146};
  write_array(array, {1, 1, 2}, bytes_of(ids), "<u8");
  const auto reader = open_volume(array);
  CHECK(reader->info().type == SampleType::u64);
  std::uint64_t slice[2];
  reader->read_slice(slice);
  CHECK(slice[0] == ids[0]);
  CHECK(slice[1] == ids[1]);
}

TEST_CASE_FIXTURE(ZarrFolder, "Zarr axes are named by the array, by xarray or by --axes") {
  write_array(array, {4, 3, 5, 1}, u8);
  check_volume(array, "Zarr");
  CHECK(noted(read_info(array), "axes of size 1 are dropped"));
  write_array(array, {4, 3, 5}, u8);
  write(array / ".zattrs", R"({"_ARRAY_DIMENSIONS": ["x", "y", "z"]})");
  CHECK(read_info(array).dims == Dims{4, 3, 5});
  VolumeOptions options = with_axes("zyx");
  check_volume(array, "Zarr", options);
  options.axes = "xzy";
  const auto samples = read_samples(array, options);
  CHECK(samples[1] == sample_at(15, SampleType::u8));     // the next chunk along x
  CHECK(samples[4] == sample_at(1, SampleType::u8));      // along y
  CHECK(samples[4 * 5] == sample_at(5, SampleType::u8));  // along z
}

TEST_CASE_FIXTURE(ZarrFolder,
                  "xarray's coordinates place a Zarr array, and its fill value becomes NaN") {
  const fs::path group = path() / "v.zarr";
  write(group / ".zgroup", R"({"zarr_format": 2})");
  write_array(group / "density", {4, 3, 5}, u8);
  write(group / "density/.zattrs", R"({"_ARRAY_DIMENSIONS": ["z", "y", "x"]})");
  write_array(group / "z", {4}, std::string("\2\5\10\13", 4));
  write(group / "z/.zattrs", R"({"_ARRAY_DIMENSIONS": ["z"], "units": "um"})");
  write_array(group / "y", {3}, std::string("\7\5\3", 3));
  write(group / "y/.zattrs", R"({"units": "mm"})");
  write_array(group / "x", {4}, std::string("\1\2\3\4", 4));  // of another array
  const VolumeInfo info = read_info(group);
  check_grid(info, {1, -2, 0.003}, {0, 7, 0.002});
  CHECK(noted(info, "no spacing of axis 1 given"));

  std::string json = contents(group / "density/.zarray");
  const std::string none = R"("fill_value": 0)";
  json.replace(json.find(none), none.size(), R"("fill_value": 8)");
  write(group / "density/.zarray", json);
  const auto samples = read_samples(group);
  CHECK(samples[1] == 4);
  CHECK(std::isnan(samples[2]));
  write_array(group / "z", {4}, std::string("\2\5\10\20", 4));
  check_refused(group, "the coordinates of the axis 'z' are uneven, from 2 to 16");
}

TEST_CASE("reading a Zarr array continues in the middle of a chunk after a skip") {
  const auto reader = open_volume(files / "i16-big-chunks.zarr");
  reader->skip_slice();
  std::int16_t slice[15];
  reader->read_slice(slice);
  for (int i = 0; i < 15; ++i) CHECK(slice[i] == sample_at(15 + i, SampleType::i16));
  reader->skip_slice();
  reader->read_slice(slice);
  for (int i = 0; i < 15; ++i) CHECK(slice[i] == sample_at(45 + i, SampleType::i16));
  CHECK_THROWS_WITH_AS(reader->skip_slice(), doctest::Contains("all 4 slices"), VolumeError);
}

TEST_CASE_FIXTURE(ZarrFolder, "a Zarr group is read like its only array or image") {
  const fs::path group = path() / "group.zarr";
  write(group / ".zgroup", R"({"zarr_format": 2})");
  write(group / "OME/.zgroup", R"({"zarr_format": 2})");
  check_refused(group, "the group holds no array");
  write_image(group / "0", zyx_axes, dataset("0", "[2000, 750, 500]"));
  write_array(group / "0/0", {4, 3, 5}, u8);
  check_volume(group, "OME-Zarr");
  check_volume(group / ".zgroup", "OME-Zarr");
  write_array(group / "1", {4, 3, 5}, u8);
  check_refused(group, "holds several images or arrays: 0, 1; choose one by its folder");
}

TEST_CASE_FIXTURE(ZarrFolder, "a zip of a Zarr folder is read like the folder") {
  for (const std::string inside : {"", "image.zarr/"}) {
    const auto file =
        write("image.zarr.zip", zip(members_of(files / "i16-big-chunks.zarr", inside)));
    check_volume(file, SampleType::i16, "OME-Zarr, zip");
  }
}

TEST_CASE_FIXTURE(ZarrFolder, "an unsupported Zarr compressor or filter is refused by name") {
  const auto refusal_of = [&](const std::string& members) {
    write(array / ".zarray",
          R"({"zarr_format": 2, "shape": [4, 3, 5], "chunks": [4, 3, 5], "fill_value": 0, )" +
              members + "}");
    write(array / "0.0.0", u8);
    return refusal(array);
  };
  check_refusal(refusal_of(R"("dtype": "|u1", "compressor": {"id": "lzma"})"),
                "packed by 'lzma', which is not supported");
  check_refusal(
      refusal_of(R"("dtype": "|u1", "compressor": null, "filters": [{"id": "packbits"}])"),
      "went through the filter");
  check_refusal(refusal_of(R"("dtype": "<c8", "compressor": null)"), "samples of type '<c8'");
  check_refusal(refusal_of(R"("dtype": [["r", "|u1"]], "compressor": null)"), "samples of type");
  check_refusal(refusal_of(R"("dtype": "|u1", "compressor": {"id": "zlib"})"),
                "the chunk is damaged");
  check_refusal(refusal_of(R"("dtype": "|u1", "compressor": {"id": "blosc"})"),
                "it is not packed by Blosc");
  check_refusal(refusal_of(R"("dtype": "<u2", "compressor": null)"),
                "its size differs from other chunks");
  write(array / ".zarray", "not JSON");
  check_refused(array, "not a JSON object");
}

TEST_CASE_FIXTURE(ZarrFolder, "Zarr chunks truncated at any byte are refused") {
  for (const std::string name : {"i16-big-chunks.zarr/0/0/0/0", "i16-big-zlib.zarr/0/0/0/0",
                                 "i16-big-zstd.zarr/0/0/0/0", "i16-big-gzip.zarr/0/0/0/0"}) {
    const fs::path original = files / name;
    const fs::path copied = fs::path(name).begin()->string();
    fs::copy(files / copied, path() / copied, fs::copy_options::recursive);
    const std::string bytes = contents(original);
    for (std::size_t size = 0; size < bytes.size(); size += 5) {
      INFO(name, " cut at ", size);
      write(path() / name, bytes.substr(0, size));
      CHECK_THROWS_AS(read_samples(path() / copied), VolumeError);
    }
  }
}

// ---- version 3 ----

std::uint32_t crc32c(const std::string& bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0x82f63b78 : 0);
  }
  return ~crc;
}

std::string array_json(const std::string& grid, const std::string& codecs,
                       const std::string& keys = R"({"name": "default"})") {
  return R"({"zarr_format": 3, "node_type": "array", "shape": [4, 3, 5], "data_type": "uint8",)"
         R"( "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": )" +
         grid + R"(}}, "chunk_key_encoding": )" + keys + R"(, "fill_value": 255, "codecs": )" +
         codecs + "}";
}

const std::string bytes_codec = R"({"name": "bytes", "configuration": {"endian": "little"}})";

// A shard of 2 x 1 x 1 chunks of 2 x 3 x 5 samples: slices 0 and 1, and slices from 2 on.
std::string shard(bool has_first, bool has_index_at_start, bool has_checksum) {
  const std::string first = has_first ? u8.substr(0, 30) : "", second = u8.substr(30);
  const std::size_t index_bytes = 32 + (has_checksum ? 4 : 0);
  const std::uint64_t begin = has_index_at_start ? index_bytes : 0, missing = ~std::uint64_t{0};
  std::string index;
  for (const std::uint64_t number :
       {has_first ? begin : missing, has_first ? std::uint64_t{30} : missing,
        std::uint64_t{begin + first.size()}, std::uint64_t{30}})
    index += bytes_of(number);
  if (has_checksum) index += bytes_of(crc32c(index));
  return has_index_at_start ? index + first + second : first + second + index;
}

std::string shard_codec(bool has_index_at_start, bool has_checksum) {
  return R"([{"name": "sharding_indexed", "configuration": {"chunk_shape": [2, 3, 5], "codecs": [)" +
         bytes_codec + R"(], "index_codecs": [)" + bytes_codec +
         (has_checksum ? R"(, {"name": "crc32c"})" : "") + R"(], "index_location": ")" +
         (has_index_at_start ? "start" : "end") + R"("}}])";
}

TEST_CASE_FIXTURE(ZarrFolder, "Zarr shards are read with the index at the start or the end") {
  for (const bool has_index_at_start : {false, true})
    for (const bool has_checksum : {false, true}) {
      write(array / "zarr.json",
            array_json("[4, 3, 5]", shard_codec(has_index_at_start, has_checksum)));
      write(array / "c/0/0/0", shard(true, has_index_at_start, has_checksum));
      check_volume(array, "Zarr");
      write(array / "c/0/0/0", shard(false, has_index_at_start, has_checksum));
      const auto samples = read_samples(array);
      CHECK(samples[29] == 255);
      CHECK(samples[30] == sample_at(30, SampleType::u8));
    }
}

TEST_CASE_FIXTURE(ZarrFolder,
                  "xarray's fill value may be base64, and _Unsigned in Zarr determines the sign") {
  const auto write_with = [this](const std::string& attributes) {
    const std::string json = array_json("[4, 3, 5]", "[" + bytes_codec + "]");
    write(array / "zarr.json",
          json.substr(0, json.size() - 1) + R"(, "attributes": )" + attributes + "}");
  };
  write(array / "c/0/0/0", u8);
  for (const std::string eight : {R"("AAAAAAAAIEA=")", "8"}) {
    write_with(R"({"_FillValue": )" + eight + "}");
    const auto samples = read_samples(array);
    CHECK(samples[1] == 4);
    CHECK(std::isnan(samples[2]));
    CHECK(samples[3] == 12);
  }
  write_with(R"({"_FillValue": "AAAAAAAAIE?="})");
  CHECK(read_samples(array)[2] == 8);
  write_with(R"({"_Unsigned": "false"})");
  CHECK(read_samples(array)[59] == sample_at(59, SampleType::u8) - 256);
}

TEST_CASE_FIXTURE(ZarrFolder, "a Zarr shard with a wrong index or checksum is refused") {
  write(array / "zarr.json", array_json("[4, 3, 5]", shard_codec(false, true)));
  std::string bytes = shard(true, false, true);
  for (std::size_t size = 0; size < bytes.size(); size += 9) {
    INFO("cut to the last ", size);
    write(array / "c/0/0/0", bytes.substr(bytes.size() - size));
    CHECK_THROWS_AS(read_samples(array), VolumeError);
  }
  bytes[70] = static_cast<char>(bytes[70] ^ 1);
  write(array / "c/0/0/0", bytes);
  check_refused(array, "its checksum is wrong");
}

TEST_CASE_FIXTURE(
    ZarrFolder,
    "checksums of Zarr chunks are verified, and version 3 arrays with version 2 keys are read") {
  const std::string keys = R"({"name": "v2", "configuration": {"separator": "."}})";
  write(array / "zarr.json",
        array_json("[4, 3, 5]", "[" + bytes_codec + R"(, {"name": "crc32c"}])", keys));
  write(array / "0.0.0", u8 + bytes_of(crc32c(u8)));
  check_volume(array, "Zarr");
  write(array / "0.0.0", u8 + bytes_of(crc32c(u8) + 1));
  check_refused(array, "its checksum is wrong");
}

TEST_CASE_FIXTURE(ZarrFolder, "unsupported codecs of Zarr version 3 are refused by name") {
  write(array / "c/0/0/0", u8);
  write(array / "zarr.json",
        array_json("[4, 3, 5]", "[" + bytes_codec + R"(, {"name": "pcodec"}])"));
  check_refused(array, "packed by 'pcodec'");
  write(array / "zarr.json",
        array_json("[4, 3, 5]", "[" + bytes_codec + R"(, {"name": "gzip"}, {"name": "zstd"}])"));
  check_refused(array, "packed twice");
  write(array / "zarr.json", array_json("[4, 3]", "[" + bytes_codec + "]"));
  check_refused(array, "sizes of chunks do not fit the axes of the array");
}

TEST_CASE_FIXTURE(ZarrFolder, "a small Zarr array that claims large slices or chunks is refused") {
  const auto refusal_of = [&](const std::string& shape, const std::string& chunks) {
    write(array / ".zarray", R"({"zarr_format": 2, "dtype": "<f8", "compressor": {"id": "zstd"},)"
                             R"( "fill_value": 0, "shape": )" +
                                 shape + R"(, "chunks": )" + chunks + "}");
    write(array / "0.0.0", u8);
    return refusal(array);
  };
  check_refusal(refusal_of("[1, 32766, 32766]", "[1, 1024, 1024]"), "cannot be in files of");
  check_refusal(refusal_of("[1, 3000, 3000]", "[1, 1, 1]"), "needs 9000000 chunks");
  check_refusal(refusal_of("[1, 3, 5]", "[1, 3000, 5000]"), "cannot be in 60");
  check_refusal(refusal_of("[1, 3, 5]", "[1024, 1024, 1024]"), "more than 2 GiB");
}

TEST_CASE_FIXTURE(ZarrFolder,
                  "the Zarr filters shuffle, delta, quantize and bitround are decoded") {
  const auto values_of = [&](const std::string& filters, const std::string& samples,
                             const std::string& dtype) {
    write_array(array, {1, 2, 2}, samples, dtype);
    std::string json = contents(array / ".zarray");
    json.replace(json.find("null}"), 4, "[" + filters + "]");
    write(array / ".zarray", json);
    return read_samples(array);
  };
  CHECK(values_of(R"({"id": "shuffle", "elementsize": 2})", std::string("\1\2\3\4\0\1\0\1", 8),
                  "<u2") == std::vector<double>{1, 258, 3, 260});
  CHECK(values_of(R"({"id": "delta", "dtype": "|u1"})", "\5\1\377\2", "|u1") ==
        std::vector<double>{5, 6, 5, 7});
  CHECK(values_of(R"({"id": "quantize", "digits": 1, "dtype": "<f4"})",
                  std::string("\0\0\x80\x3f", 4) + std::string(12, '\0'), "<f4")[0] == 1);
  CHECK(values_of(R"({"id": "bitround", "keepbits": 3})", "\5\1\7\2", "|u1") ==
        std::vector<double>{5, 1, 7, 2});
  CHECK(values_of(R"({"id": "delta", "dtype": "|u1"}, {"id": "shuffle", "elementsize": 2})",
                  std::string("\1\3\2\4", 4), "|u1") == std::vector<double>{1, 3, 6, 10});
}

TEST_CASE_FIXTURE(ZarrFolder, "labels of OME-Zarr have their names and colours") {
  const fs::path nuclei = path() / "nuclei";
  write_image(nuclei, zyx_axes, dataset("0", "[1, 1, 1]"));
  std::string json = contents(nuclei / ".zattrs");
  json.insert(1, R"("image-label": {"colors": [{"label-value": 3, "rgba": [255, 0, 0, 255]},
    {"label-value": 4, "rgba": [1, 2]}], "properties": [{"label-value": 3, "name": "left"},
    {"label-value": 700, "class": "right"}]}, )");
  write(nuclei / ".zattrs", json);
  write_array(nuclei / "0", {4, 3, 5}, u8);
  const auto labels = read_info(nuclei).labels;
  REQUIRE(labels.size() == 2);
  CHECK(labels[0].name == "left");
  REQUIRE(labels[0].colour);
  CHECK(*labels[0].colour == discmc::command::Srgb{255, 0, 0});
  CHECK(labels[1].name == "right");
  CHECK(labels[1].values == std::vector{discmc::meshing::LabelValue(700)});
}

TEST_CASE_FIXTURE(ZarrFolder,
                  "--labels on an OME-Zarr image notes the folder with the image's labels") {
  const fs::path scan = path() / "scan";
  write_image(scan, zyx_axes, dataset("0", "[1, 1, 1]"));
  write_array(scan / "0", {4, 3, 5}, u8);
  write(scan / "labels/.zgroup", R"({"zarr_format": 2})");
  VolumeOptions options;
  for (const bool holds_labels : {false, true}) {
    options.holds_labels = holds_labels;
    CHECK(noted(read_info(scan, options), "its labels lie in ") == holds_labels);
  }
}

}  // namespace
