// Unsupported formats: the message names the format, and a way to convert the file.
#include "command.hpp"

namespace {

using namespace volume_files;
using command_tests::Workshop;

TEST_CASE_FIXTURE(Folder, "an unsupported format is named with its converter") {
  struct Case {
    const char* file;
    const char* head;
    const char* refusal;
  };
  const Case cases[] = {
      {"a.czi", "",
       "this is Zeiss CZI, which is not supported; convert it, e.g. with: bioformats2raw"},
      {"no-name", "ZISRAWFILE", "this is Zeiss CZI"},
      {"a.lif", "", "bioformats2raw"},
      {"a.dtseries.nii", "",
       "this is CIFTI, which is not supported; convert its volume with: wb_command"},
      {"a.hdr", "ENVI\nsamples = 24\n", "this is ENVI"},
      {"a.xmf", "<?xml version=\"1.0\"?><Xdmf>", "this is XDMF"},
      {"a.dat", "GIF89a", "convert it, e.g. with: magick FILE OUT.png"},
      {"a.nd2", "", "bioformats2raw"},
      {"a.ims", "", "bioformats2raw"},
      {"a+orig.HEAD", "", "3dAFNItoNIFTI"},
      {"a+orig.BRIK.gz", "", "3dAFNItoNIFTI"},
      {"a.mnc", "", "mnc2nii"},
      {"a.PAR", "", "dcm2niix"},
      {"a.fits", "", "numpy.save"},
      {"a.mif.gz", "", "mrconvert"},
      {"no-name", "mrtrix image", "mrconvert"},
      {"a.hv", "", "medcon"},
      {"a.hdr", "!INTERFILE :=", "this is Interfile"},
      {"a.v", "MATRIX72v", "this is ECAT"},
      {"a.mat", "MATLAB 5.0 MAT-file", "-v7.3"},
      {"a.tar.gz", "", "unpack it"},
  };
  for (const Case& each : cases) {
    INFO(each.file);
    check_refused(write(each.file, std::string(each.head) + "..."), each.refusal,
                  "which is not supported");
  }
}

TEST_CASE_FIXTURE(Workshop, "info treats files of unsupported formats as volumes, not as streams") {
  for (const std::string name : {"a.czi", "a.nd2", "a+orig.HEAD", "a.mgz", "a.npz", "a.mrc"}) {
    INFO(name);
    write(name, "...");
    const auto result = run("info " + name);
    CHECK(result.code != 0);
    CHECK(contains(result.error, name));
    CHECK_FALSE(contains(result.error, "stream"));
  }
}

TEST_CASE_FIXTURE(
    Folder, "with --dims and --type, files of unsupported formats are read as headerless samples") {
  const VolumeOptions options = with(&VolumeOptions::layout, RawLayout{{5, 3, 4}, SampleType::u8});
  check_volume(write("a.isq", u8), "raw", options);
  check_volume(write("2dseq", u8), "raw", options);
}

}  // namespace
