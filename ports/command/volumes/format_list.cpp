#include "format_list.hpp"

#include <algorithm>

#include "array_name.hpp"
#include "text/words.hpp"
#include "volumes/formats/dicom/files.hpp"
#include "volumes/formats/zarr/folder.hpp"

namespace discmc::command {
namespace {

using namespace std::string_view_literals;

std::unique_ptr<VolumeReader> open_dicom_file(const std::filesystem::path& file,
                                              const VolumeOptions& options) {
  return open_dicom(file, {file}, options);
}

std::unique_ptr<VolumeReader> open_picture_file(const std::filesystem::path& file,
                                                const VolumeOptions& options) {
  return open_pictures(file, {file}, options);
}

constexpr std::string_view to_zarr = "convert it, e.g. with: bioformats2raw FILE OUT.zarr";
constexpr std::string_view unpack = "unpack it, and give the folder or the file";

// The first one counts whose ending or magic fits.
const std::vector<VolumeFormat>& formats() {
  static const std::vector<VolumeFormat> list = {
      {"NRRD", {".nrrd", ".nhdr"}, {{0, "NRRD000"}}, open_nrrd, nullptr},
      {"MetaImage", {".mha", ".mhd"}, {{0, "ObjectType"}, {0, "NDims"}}, open_metaimage, nullptr},
      {"NIfTI",
       {".nii", ".hdr", ".img"},
       {{344, "n+1\0"sv}, {344, "ni1\0"sv}, {4, "n+2\0"sv}, {4, "ni2\0"sv}},
       open_nifti,
       nullptr},
      {"MGH", {".mgh", ".mgz"}, {}, open_mgh, nullptr},
      {"MRC", {".mrc", ".mrcs", ".map", ".ccp4"}, {{208, "MAP "}}, open_mrc, nullptr},
      {"VTK", {".vtk"}, {{0, "# vtk DataFile"}}, open_vtk, nullptr},
      {"VTK XML", {".vti"}, {{0, "<?xml"}, {0, "<VTKFile"}}, open_vti, nullptr},
      {"NumPy", {".npy"}, {{0, "\x93NUMPY"}}, open_numpy, nullptr},
      {"npz", {".npz"}, {}, nullptr, open_npz},
      {"InVesalius", {".inv3"}, {{257, "ustar"}}, open_invesalius, nullptr},
      {"DICOM", {".dcm", ".ima"}, {}, nullptr, open_dicom_file},
      {"PNG", {".png"}, {{0, "\x89PNG"}}, nullptr, open_picture_file},
      {"TIFF",
       {".tif", ".tiff"},
       {{0, "II*\0"sv}, {0, "MM\0*"sv}, {0, "II+\0"sv}, {0, "MM\0+"sv}},
       nullptr,
       open_picture_file},
      {"JPEG", {".jpg", ".jpeg"}, {{0, "\xff\xd8\xff"}}, nullptr, open_picture_file},
      {"BMP", {".bmp"}, {}, nullptr, open_picture_file},
      {"zip", {".zip"}, {{0, "PK\x03\x04"}}, nullptr, open_zip},
      {"HDF5",
       {".h5", ".hdf5", ".hdf", ".nxs", ".nc"},
       {{0, "\x89HDF"}, {0, "MATLAB 7.3"}},
       nullptr,
       open_hdf5},

      {"PDF", {".pdf"}, {{0, "%PDF"}}, nullptr, nullptr, "give the volume"},
      {"AFNI",
       {".head", ".brik"},
       {},
       nullptr,
       nullptr,
       "convert it, e.g. with: 3dAFNItoNIFTI FILE.HEAD"},
      {"MINC",
       {".mnc", ".mnc2"},
       {},
       nullptr,
       nullptr,
       "convert it, e.g. with: mnc2nii FILE.mnc OUT.nii"},
      {"NetCDF of version 3",
       {},
       {{0, "CDF\x01"}, {0, "CDF\x02"}},
       nullptr,
       nullptr,
       "convert it, e.g. with: nccopy -k nc4 FILE OUT.nc"},
      {"MRtrix",
       {".mif", ".mih"},
       {{0, "mrtrix image"}},
       nullptr,
       nullptr,
       "convert it, e.g. with: mrconvert FILE OUT.nii"},
      {"Interfile",
       {".hv", ".i33"},
       {{0, "!INTERFILE"}},
       nullptr,
       nullptr,
       "convert it, e.g. with: medcon -c nifti -f FILE"},
      {"ECAT",
       {},
       {{0, "MATRIX"}},
       nullptr,
       nullptr,
       "convert it, e.g. with: medcon -c nifti -f FILE"},
      {"Philips PAR/REC",
       {".par"},
       {},
       nullptr,
       nullptr,
       "convert it, e.g. with: dcm2niix FILE.PAR"},
      {"Bruker ParaVision",
       {"2dseq"},
       {},
       nullptr,
       nullptr,
       "convert it, e.g. with: brkraw tonii FOLDER"},
      {"MATLAB of version 5",
       {},
       {{0, "MATLAB 5.0"}},
       nullptr,
       nullptr,
       "save it in MATLAB with: save('FILE.mat', 'VARIABLE', '-v7.3')"},
      {"Imaris", {".ims"}, {}, nullptr, nullptr, to_zarr},
      {"Zeiss CZI", {".czi"}, {{0, "ZISRAWFILE"}}, nullptr, nullptr, to_zarr},
      {"Zeiss LSM", {".lsm"}, {}, nullptr, nullptr, to_zarr},
      {"Leica LIF", {".lif", ".xlef", ".lof"}, {}, nullptr, nullptr, to_zarr},
      {"Nikon ND2", {".nd2"}, {{0, "\xda\xce\xbe\x0a"}}, nullptr, nullptr, to_zarr},
      {"Olympus OIB, OIF or VSI", {".oib", ".oif", ".oir", ".vsi"}, {}, nullptr, nullptr, to_zarr},
      {"DeltaVision", {".dv", ".r3d"}, {}, nullptr, nullptr, to_zarr},
      {"MetaMorph STK", {".stk"}, {}, nullptr, nullptr, to_zarr},
      {"N5", {".n5"}, {}, nullptr, nullptr, "convert it to Zarr"},
      {"Scanco ISQ or AIM",
       {".isq", ".aim", ".rsq"},
       {{0, "CTDATA-HEADER_V1"}, {0, "AIMDATA_V030"}},
       nullptr,
       nullptr,
       "convert it, e.g. with ITK in Python: itk.imwrite(itk.imread('FILE'), 'OUT.nrrd')"},
      {"Zeiss TXM or XRM",
       {".txm", ".xrm", ".txrm"},
       {},
       nullptr,
       nullptr,
       "export it as TIFF or DICOM"},
      {"Amira mesh",
       {".am"},
       {{0, "# AmiraMesh"}, {0, "# Avizo"}},
       nullptr,
       nullptr,
       "export it, e.g. as NRRD"},
      {"FITS",
       {".fits", ".fit"},
       {{0, "SIMPLE  ="}},
       nullptr,
       nullptr,
       "convert it with Astropy in Python: numpy.save('OUT.npy', fits.getdata('FILE'))"},
      {"VGStudio",
       {".vgi", ".vgl"},
       {},
       nullptr,
       nullptr,
       "give the .vol file beside it, with the --dims and --type in the .vgi file"},
      {"GIPL", {".gipl"}, {}, nullptr, nullptr, "convert it, e.g. with: c3d FILE -o OUT.nii.gz"},
      {"tar", {".tar", ".tgz"}, {}, nullptr, nullptr, unpack},
      {"7z", {".7z"}, {{0, "7z\xbc\xaf\x27\x1c"}}, nullptr, nullptr, unpack},
      {"RAR", {".rar"}, {{0, "Rar!\x1a"}}, nullptr, nullptr, unpack},
  };
  return list;
}

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

template <class Fits>
const VolumeFormat* first_format(Fits fits) {
  const auto found = std::find_if(formats().begin(), formats().end(), fits);
  return found == formats().end() ? nullptr : &*found;
}

}  // namespace

const VolumeFormat* format_of_name(const std::filesystem::path& file) {
  const ArrayName parts = array_name(file);
  const std::string name = lower(without_packing(parts.file).filename().string());
  const bool is_npz = ends_with(name, ".npz");
  if (!parts.array.empty() && !is_npz)
    return first_format([](const VolumeFormat& format) { return format.open_file == open_hdf5; });
  return first_format([&name](const VolumeFormat& format) {
    return std::any_of(format.endings.begin(), format.endings.end(),
                       [&name](std::string_view ending) { return ends_with(name, ending); });
  });
}

const VolumeFormat* format_of_head(std::string_view head) {
  return first_format([head](const VolumeFormat& format) {
    if (format.open_file == open_dicom_file) return is_dicom_head(head);
    return std::any_of(format.magics.begin(), format.magics.end(), [head](const Magic& magic) {
      return head.size() >= magic.offset &&
             head.substr(magic.offset, magic.bytes.size()) == magic.bytes;
    });
  });
}

bool names_no_axes(const std::filesystem::path& file) {
  const VolumeFormat* const format = format_of_name(file);
  return is_zarr(file) ||
         (format != nullptr && (format->open_stream == open_numpy ||
                                format->open_file == open_npz || format->open_file == open_hdf5));
}

bool is_volume_head(std::string_view head) {
  return packing_of(head) || format_of_head(head) != nullptr;
}

}  // namespace discmc::command
