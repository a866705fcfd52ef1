// Files and folders that users of other programs reported, because they were misread, or refused
// without a remedy.
#include "command.hpp"

namespace {

using namespace volume_files;
using command_tests::check_failure;
using command_tests::Workshop;

TEST_CASE_FIXTURE(
    Folder, "unsupported formats are recognized by their first bytes and refused with a remedy") {
  const std::pair<std::string, std::string> cases[] = {
      {"HSF-OCT-103", "this is Heidelberg OCT"},
      {"FOCTFDA", "this is Topcon OCT"},
      {"KRETZFILE 1.0", "SlicerHeart"},
      {"VOX ....", "this is MagicaVoxel"},
      {"#binvox 1", "this is binvox"},
      {" BDV....", "this is OpenVDB"},
      {"<?xml version=\"1.0\"?><GIFTI>", "this is GIFTI"},
      {"<?xml version=\"1.0\"?><SpimData>", "this is BigDataViewer"},
      {"<!DOCTYPE html><html>", "this is a web page"},
      {"version https://git-lfs.github.com/spec/v1", "git lfs pull"},
      {"NSI Reconstruction", "this is North Star Imaging"},
      {"CTDATA-HEADER_V1", "itk-ioscanco"},
      {std::string("CDF\1\0\0\0\0minc_version", 20), "mnc2nii"}};
  for (const auto& each : cases) {
    const auto& [head, part] = each;
    INFO(each.first);
    check_refused(write("v.vol", head + "...."), part);
  }
  // The name does not override the contents of the file.
  check_refused(write("v.nc", "CDF\1...."), "nccopy");
  check_refused("https://example.org/v.nrrd", "this is an address");
}

TEST_CASE_FIXTURE(Folder, "samples with a describing text file are read with their spacing") {
  write("v.vol", stored(SampleType::u16));
  const auto vgi = write("v.vgi",
                         "{volume1}\n[file1]\nSize = 5 3 4\nName = C:\\scans\\v.vol\n"
                         "Datatype = unsigned integer\nBitsPerElement = 16\n"
                         "{volumeprimitive12}\nresolution = 2 3 4\nunit = um\n");
  const auto pcr = write("v.pcr",
                         "[Volume]\nVolume_SizeX=5\nVolume_SizeY=3\nVolume_SizeZ=4\n"
                         "[Geometry]\nVoxelSizeRec = 0,05\n[VolumeData]\nFormat=5\n");
  const std::vector<double> values = samples_as(SampleType::u16);
  CHECK(read_samples(vgi) == values);
  CHECK(read_info(vgi).spacing_mm == Spacing{2e-3, 3e-3, 4e-3});
  CHECK(read_samples(pcr) == values);
  CHECK(read_info(pcr).spacing_mm == Spacing{0.05, 0.05, 0.05});
  check_refused(write("w.vgi", "Size = 5 3\nDatatype = float\nBitsPerElement = 32\n"), "the size");
  check_refused(write("x.vgi",
                      "Size = 5 3 4\nName = ..\nDatatype = float\n"
                      "BitsPerElement = 32\n"),
                "x.vgi");
  // Nikon's files of samples have names without an extension.
  const auto nikon = write("scan.xtekct",
                           "[XTekCT]\nName=head 1.5\nVoxelsX=5\nVoxelsY=3\nVoxelsZ=4\n"
                           "VoxelSizeX=2\nVoxelSizeY=3\nVoxelSizeZ=4\n");
  check_refused(nikon, "describes 'head 1.5.vol', of 5 x 3 x 4 voxels, which is not");
  write("head 1.5.vol", stored(SampleType::f32));
  CHECK(read_info(nikon).spacing_mm == Spacing{2, 3, 4});
}

TEST_CASE_FIXTURE(Folder, "a Gaussian cube is read along its axes, in angstrom") {
  std::string text =
      "density\nx outer\n 1 -10 5 2\n -2 0.2 0 0\n -3 0 0.3 0\n -4 0 0 0.4\n 6 6 0 0 0\n";
  std::vector<double> values(24);
  for (int x = 0; x < 2; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 4; ++z) {
        text += ' ' + std::to_string(100 * x + 10 * y + z);
        values[static_cast<std::size_t>((z * 3 + y) * 2 + x)] = 100 * x + 10 * y + z;
      }
  const auto reader = open_volume(write("v.cube", text));
  check_grid(reader->info(), {0.2, 0.3, 0.4}, {-10, 5, 2});
  CHECK(read_all(*reader) == values);
  check_refused(write("w.cube", "a\nb\n1 2\n"), "no count and three numbers");
  check_refused(write("x.cube", "a\nb\n99999999999 0 0 0\n2 1 0 0\n2 0 1 0\n2 0 0 1\n"),
                "atoms are too many");
}

std::string mask(const std::string& samples) {
  return Nifti().dims({3, 4, 3, 2}).file(samples);
}

// At the same position in space, with x from right to left or from left to right.
std::string placed_mask(const std::string& samples, bool is_reversed) {
  const float along = is_reversed ? -1 : 1, first = is_reversed ? 3 : 0;
  return Nifti()
      .dims({3, 4, 3, 2})
      .sform({along, 0, 0, first, 0, 1, 0, 0, 0, 0, 1, 0})
      .file(samples);
}

TEST_CASE_FIXTURE(Folder,
                  "masks whose axes run in other directions than the first mask's are turned") {
  std::string on(24, '\0'), reversed(24, '\0');
  for (const std::size_t row : {0U, 2U, 5U}) {
    on[4 * row + 1] = 1;
    reversed[4 * row + 2] = 1;
  }
  write("a.nii", placed_mask(on, false));
  write("b.nii", placed_mask(reversed, true));
  VolumeOptions options = with(&VolumeOptions::holds_labels, true);
  options.frame = 0;
  const auto values = read_samples(path(), options);
  options.frame = 1;
  const auto turned = open_volume(path(), options);
  CHECK(read_all(*turned) == values);
  write("b.nii", placed_mask(reversed, true).replace(292, 4, std::string("\0\0\x20\x41", 4)));
  check_refused(path(), options, "the mask lies elsewhere than 'a.nii'");
}

TEST_CASE_FIXTURE(Workshop,
                  "masks in a folder with a picture are read as labels, and the picture is noted") {
  std::string on(24, '\0');
  on[5] = 1;
  write("seg/liver.nii", mask(on));
  on[18] = 1;
  write("seg/spleen.nii", mask(on));
  write("seg/qc.jpg", "\xff\xd8\xff");
  check_parts(run("extract seg --labels all -o 'm-{name}.stl'"), 0,
              {"pictures beside the volumes are left out: 1, such as 'qc.jpg'"});
  CHECK(contains(shell("ls").out, "m-liver.stl"));
  // A shell replaces an unquoted pattern by the names of its files.
  CHECK(contains(done("extract seg/liver.nii seg/spleen.nii --labels all -o m.csv"), "spleen"));
  fails("extract seg/liver.nii m.stl --labels all", 2,
        {"'m.stl' is an unexpected argument; name the output with -o m.stl"});
}

TEST_CASE_FIXTURE(
    Folder, "a folder with one volume file is read as the volume, and several volumes are listed") {
  write("a/b/v.npy", npy("|u1", "4, 3, 5", u8));
  write("a/notes.txt", "...");
  CHECK(read_info(path()).dims == Dims{5, 3, 4});
  write("a/w.npy", npy("|u1", "4, 3, 5", u8));
  check_refused(path(), "several volumes in folders: 2, such as ", "a/b/v.npy");
  fs::remove_all(path() / "a");
  write("2dseq", "...");
  check_refused(path(), "the folder holds Bruker ParaVision, '2dseq'; convert it");
  fs::remove(path() / "2dseq");
  write("a/v.hdr", Nifti().pair().header());
  write("a/v.img", u8);
  CHECK(read_info(path()).dims == Dims{5, 3, 4});
}

TEST_CASE_FIXTURE(Workshop, "labels that no voxel has, and labels that --shrink loses, are noted") {
  std::string samples(4 * 4 * 4, '\1');
  samples[21] = 2;
  write("v.raw", samples);
  const std::string extract = "extract v.raw --dims 4,4,4 --type u8 ";
  check_parts(run(extract + "--label 1,7 -o v.stl"), 0, {"no voxel has label 7\n"});
  CHECK_FALSE(contains(run(extract + "--label 1,2 -o v.stl").error, "no voxel"));
  CHECK(contains(run(extract + "--labels all --shrink 2 -o v.glb").error,
                 "--shrink loses 2, the most frequent of no block"));
}

TEST_CASE_FIXTURE(Workshop,
                  "regions of nnU-Net's dataset.json are meshes of the union of their labels") {
  write("v.raw", std::string({1, 0, 2, 0, 3, 0, 0, 4}));
  write("t.json", R"({"labels": {"background": 0, "all": [1, 2, 3], "core": [2, 3], "x": 3}})");
  const auto result =
      run("extract v.raw --dims 8,1,1 --type u8 --labels all --label-table t.json -o '{name}.stl'");
  CHECK(result.code == 0);
  CHECK(contains(result.out, "  all.stl\n"));
  CHECK(contains(result.out, "  core.stl\n"));
  CHECK(contains(result.out, "  x.stl\n"));
  CHECK(contains(result.out, "  4.stl\n"));
  CHECK_FALSE(contains(result.out, "  1.stl\n"));
  done("extract v.raw --dims 8,1,1 --type u8 --label 1,2,3 -q -o u.stl");
  CHECK(read("all.stl") == read("u.stl"));
}

TEST_CASE_FIXTURE(Workshop,
                  "--labels refuses a file of several volumes, and the message advises --frame") {
  write("v.nii", Nifti().dims({4, 2, 2, 2, 3}).file(std::string(24, '\1')));
  fails("extract v.nii --labels all -o v.glb", 1,
        {"choose one with --frame N", "with --frame 0 to 2, each with --label 1"});
  write("f.nii", Nifti().dims({4, 2, 2, 2, 3}).type(16).file(std::string(96, '\0')));
  fails("extract f.nii --labels all -o v.glb", 1,
        {"if each is the probability of a label, extract them with --frame 0 to 2", "--iso 0.5"});
}

TEST_CASE_FIXTURE(Folder, "MetaImage frames tracked in different poses are refused as slices") {
  const auto sequence = [](const std::string& second) {
    return metaimage(metaimage_u8 + "Seq_Frame0000_ProbeToTrackerTransform = 1 0 0 0\n" +
                     "Seq_Frame0000_ProbeToTrackerTransformStatus = OK\n" +
                     "Seq_Frame0001_ProbeToTrackerTransform = " + second +
                     "\nElementDataFile = LOCAL\n") +
           u8;
  };
  check_refused(write("a.mha", sequence("0.9 0.1 0 0")), "VolumeReconstructor");
  CHECK(read_info(write("b.mha", sequence("1 0 0 0"))).dims[2] == 4);
}

TEST_CASE_FIXTURE(Folder, "the fourth space dimension of NRRD files by ITK is time") {
  const auto file =
      write("v.nrrd", nrrd(nrrd_u8 + "space dimension: 4\nkinds: domain domain domain domain\n"
                                     "space directions: (2,0,0,0) (0,3,0,0) (0,0,4,0) (0,0,0,1)\n"
                                     "space origin: (5,6,7,0)\n",
                           "2 2 2 2") +
                          "\n" + std::string("abcdefghABCDEFGH"));
  const auto reader = open_volume(file, of_frame(1));
  check_grid(reader->info(), {2, 3, 4}, {5, 6, 7});
  CHECK(read_all(*reader)[0] == 'A');
}

TEST_CASE_FIXTURE(Folder, "SPM's origin places an Analyze volume, with x from right to left") {
  Nifti header;
  header.pair().real(80, 2).real(84, 3).real(88, 4);
  header.integer(253, 2, 2).integer(255, 2, 3).integer(257, 2, 1);
  std::string bytes = header.header();
  bytes.replace(344, 4, 4, '\0');
  write("v.hdr", bytes);
  const VolumeInfo info = read_info(write("v.img", u8));
  REQUIRE(info.placement);
  CHECK(info.placement->space == Space::ras);
  CHECK(info.placement->origin_mm == Spacing{2, -6, 0});
  CHECK(info.placement->axes_mm[0] == Spacing{-2, 0, 0});
  CHECK(noted(info, "the origin is SPM's"));
}

TEST_CASE_FIXTURE(Workshop, "a single value of --spacing applies to all axes") {
  write("v.raw", std::string(8, '\1'));
  CHECK(contains(done("info v.raw --dims 2,2,2 --type u8 --spacing 0.0025"),
                 "spacing 0.0025 0.0025 0.0025\n"));
  fails("info v.raw --dims 2,2,2 --type u8 --spacing 1,2", 2,
        {"2 distances are given; give one for all axes, or X,Y,Z"});
}

TEST_CASE_FIXTURE(Workshop,
                  "a path into a zip opens only that file, and cannot lead out of the zip") {
  write("v.nrrd", nrrd(nrrd_u8) + "\n" + u8);
  if (shell("mkdir s && cp v.nrrd s/a.nrrd && cp v.nrrd s/b.nrrd && "
            "python3 -m zipfile -c s.mrb s")
          .code != 0)
    return;
  CHECK(contains(done("info s.mrb/s/b.nrrd"), "dimensions 5 3 4\n"));
  fails("extract s.mrb --iso 1 -o v.stl", 1, {"several volumes: 2", "s.mrb/s/a.nrrd"});
  fails("extract s.mrb/s/../../v.nrrd --iso 1 -o v.stl", 1, {"leads out"});
}

}  // namespace
