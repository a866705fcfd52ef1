#include "format_list.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "array_name.hpp"
#include "text/words.hpp"
#include "volumes/formats/dicom/files.hpp"

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

VolumeFormat unread(std::string_view name, std::vector<std::string_view> endings,
                    std::vector<Magic> magics, std::string_view remedy) {
  return {name, std::move(endings), std::move(magics), nullptr, nullptr, remedy};
}

constexpr std::string_view by_medcon = "convert it, e.g. with: medcon -c nifti -f FILE";
constexpr std::string_view by_oct_converter =
    "convert it with oct-converter in Python: numpy.save('OUT.npy', "
    "READER('FILE').read_oct_volume()[0].volume), whose READER is E2E, FDA or FDS";
constexpr std::string_view to_zarr = "convert it, e.g. with: bioformats2raw FILE OUT.zarr";
constexpr std::size_t anywhere = std::string_view::npos;
constexpr std::string_view unpack_it = "unpack it, and give the folder or the file";

// The first format whose ending or magic matches counts.
const std::vector<VolumeFormat>& formats() {
  static const std::vector<VolumeFormat> list = {
      {"NRRD", {".nrrd", ".nhdr"}, {{0, "NRRD000"}}, open_nrrd, nullptr},
      {"MetaImage", {".mha", ".mhd"}, {{0, "ObjectType"}, {0, "NDims"}}, open_metaimage, nullptr},
      unread("CIFTI",
             {".dscalar.nii", ".dtseries.nii", ".dlabel.nii", ".dconn.nii", ".pscalar.nii",
              ".ptseries.nii", ".plabel.nii", ".pconn.nii"},
             {},
             "convert its volume with: wb_command -cifti-separate FILE COLUMN -volume-all OUT.nii"),
      {"NIfTI",
       {".nii", ".hdr", ".img"},
       {{344, "n+1\0"sv}, {344, "ni1\0"sv}, {4, "n+2\0"sv}, {4, "ni2\0"sv}},
       open_nifti,
       nullptr},
      {"MGH", {".mgh", ".mgz"}, {}, open_mgh, nullptr},
      {"MRC", {".mrc", ".mrcs", ".map", ".ccp4"}, {{208, "MAP "}}, open_mrc, nullptr},
      {"VTK", {".vtk"}, {{0, "# vtk DataFile"}}, open_vtk, nullptr},
      unread("BigDataViewer", {}, {{anywhere, "<SpimData"}},
             "give an array of the .h5 beside it, such as FILE.h5:/t00000/s00/0/cells"),
      unread("GIFTI", {".gii"}, {{anywhere, "<GIFTI"}},
             "this is a surface; give the volume that it was made of"),
      {"VTK XML in pieces", {".pvti"}, {{anywhere, "<PImageData"}}, open_pvti, nullptr},
      {"VTK XML", {".vti", ".vtr"}, {{0, "<?xml"}, {0, "<VTKFile"}}, open_vti, nullptr},
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
      {"zip", {".zip", ".mrb"}, {{0, "PK\x03\x04"}}, nullptr, open_zip},
      {"HDF5",
       {".h5", ".hdf5", ".hdf", ".nxs", ".nc", ".vtkhdf", ".emd", ".cmap"},
       {{0, "\x89HDF"}, {0, "MATLAB 7.3"}},
       nullptr,
       open_hdf5},
      {"VGStudio", {".vgi"}, {{anywhere, "{volumeprimitive"}}, open_described, nullptr},
      {"Phoenix PCR", {".pcr"}, {{anywhere, "Volume_SizeX"}}, open_described, nullptr},
      {"Nikon XTekCT", {".xtekct"}, {{anywhere, "[XTekCT]"}}, open_described, nullptr},
      {"Gaussian cube", {".cube", ".cub"}, {}, open_cube, nullptr},

      unread("PDF", {".pdf"}, {{0, "%PDF"}}, "give the volume"),
      unread("AFNI", {".head", ".brik"}, {}, "convert it, e.g. with: 3dAFNItoNIFTI FILE.HEAD"),
      unread("MINC", {".mnc", ".mnc2"}, {{anywhere, "minc_version"}, {anywhere, "xspace\0\0"sv}},
             "convert it, e.g. with: mnc2nii FILE.mnc OUT.nii"),
      unread("NetCDF of version 3", {}, {{0, "CDF\x01"}, {0, "CDF\x02"}, {0, "CDF\x05"}},
             "convert it, e.g. with: nccopy -k nc4 FILE OUT.nc"),
      unread("MRtrix", {".mif", ".mih"}, {{0, "mrtrix image"}},
             "convert it, e.g. with: mrconvert FILE OUT.nii"),
      unread("ENVI", {}, {{0, "ENVI"}},
             "name the file of samples .raw, and give the layout with --dims and --type"),
      unread("Gatan DM3 or DM4", {".dm3", ".dm4"}, {}, to_zarr),
      unread("ICS", {".ics", ".ids"}, {{anywhere, "ics_version"}}, to_zarr),
      unread("Situs or X-PLOR", {".situs", ".sit", ".xplor", ".cns"}, {},
             "save it as .mrc in ChimeraX"),
      unread("XDMF", {".xdmf", ".xmf"}, {{anywhere, "<Xdmf"}},
             "give an array of the .h5 beside it, such as FILE.h5:/NAME"),
      unread("a picture of a kind that is not read",
             {".gif", ".webp", ".pgm", ".ppm", ".jp2", ".jxl", ".avif", ".heic"},
             {{0, "GIF8"}, {8, "WEBP"}, {4, "jP  \r\n"}},
             "convert it, e.g. with: magick FILE OUT.png"),
      unread("Interfile", {".hv", ".i33"}, {{0, "!INTERFILE"}}, by_medcon),
      unread("ECAT", {}, {{0, "MATRIX"}}, by_medcon),
      unread("Philips PAR/REC", {".par"}, {}, "convert it, e.g. with: dcm2niix FILE.PAR"),
      unread("Bruker ParaVision", {"2dseq"}, {}, "convert it, e.g. with: brkraw tonii FOLDER"),
      unread("MATLAB of version 5", {}, {{0, "MATLAB 5.0"}},
             "save it in MATLAB with: save('FILE.mat', 'VARIABLE', '-v7.3')"),
      unread("Imaris", {".ims"}, {}, to_zarr),
      unread("Zeiss CZI", {".czi"}, {{0, "ZISRAWFILE"}}, to_zarr),
      unread("Zeiss LSM", {".lsm"}, {}, to_zarr),
      unread("Leica LIF", {".lif", ".xlef", ".lof"}, {}, to_zarr),
      unread("Nikon ND2", {".nd2"}, {{0, "\xda\xce\xbe\x0a"}}, to_zarr),
      unread("Olympus OIB, OIF or VSI", {".oib", ".oif", ".oir", ".vsi"}, {}, to_zarr),
      unread("DeltaVision", {".dv", ".r3d"}, {}, to_zarr),
      unread("MetaMorph STK", {".stk"}, {}, to_zarr),
      unread("N5", {".n5"}, {{anywhere, "\"blockSize\""}}, "convert it to Zarr, e.g. with z5py"),
      unread("neuroglancer precomputed", {}, {{anywhere, "neuroglancer_multiscale"}},
             "read it with cloud-volume in Python: numpy.save('OUT.npy', "
             "CloudVolume('file://FOLDER')[:, :, :, 0])"),
      unread("WKW of webKnossos", {".wkw"}, {{0, "WKW"}},
             "convert it to Zarr, e.g. with: webknossos convert-zarr FOLDER OUT"),
      unread("Scanco ISQ or AIM", {".isq", ".aim", ".rsq"},
             {{0, "CTDATA-HEADER_V1"}, {0, "AIMDATA_V030"}},
             "convert it in Python, after: pip install itk itk-ioscanco; with: "
             "itk.imwrite(itk.imread('FILE'), 'OUT.nrrd')"),
      unread("Zeiss TXM or XRM", {".txm", ".xrm", ".txrm"}, {}, "export it as TIFF or DICOM"),
      unread("Amira mesh", {".am"}, {{0, "# AmiraMesh"}, {0, "# Avizo"}},
             "export it, e.g. as NRRD"),
      unread("FITS", {".fits", ".fit"}, {{0, "SIMPLE  ="}},
             "convert it with Astropy in Python: numpy.save('OUT.npy', fits.getdata('FILE'))"),
      unread("North Star Imaging", {".nsihdr", ".nsidat"}, {{0, "NSI Reconstruction"}},
             "export it as TIFF, and give its <Voxel Size> in mm as --spacing"),
      unread("Heidelberg OCT", {}, {{0, "HSF-OCT"}},
             "convert it in Python, after: pip install eyepie; with: numpy.save('OUT.npy', "
             "eyepy.import_heyex_vol('FILE').data)"),
      unread("Heidelberg E2E", {".e2e"}, {{0, "CMDb"}}, by_oct_converter),
      unread("Topcon OCT", {".fda", ".fds"}, {{0, "FOCT"}}, by_oct_converter),
      unread("Voluson (Kretz) ultrasound", {}, {{0, "KRETZFILE"}},
             "open it in 3D Slicer with the extension SlicerHeart, and save it as NRRD"),
      unread("a volume without a header", {".vol"}, {},
             "give the .vgi, .pcr or .xtekct file beside it, or its layout with --dims and --type"),
      unread("BrainVoyager", {".vmr", ".v16"}, {},
             "convert it with bvbabel in Python: numpy.save('OUT.npy', read_vmr('FILE')[1])"),
      unread("OpenDX", {".dx"}, {{0, "object 1 class"}},
             "convert it with GridDataFormats in Python: numpy.save('OUT.npy', Grid('FILE').grid)"),
      unread("XCrySDen", {".xsf"}, {}, "convert it to .cube, e.g. with ASE or VESTA"),
      unread("MagicaVoxel", {".vox"}, {{0, "VOX "}}, "export its slices as PNG in MagicaVoxel"),
      unread("binvox", {".binvox"}, {{0, "#binvox"}},
             "convert it with binvox_rw in Python: numpy.save('OUT.npy', "
             "read_as_3d_array(open('FILE', 'rb')).data)"),
      unread("OpenVDB", {".vdb"}, {{0, " BDV"}},
             "convert it with pyopenvdb in Python: grid.copyToArray(array), and numpy.save"),
      unread("a resin print", {".sl1", ".sl1s", ".ctb", ".cbddlp", ".photon"}, {},
             "export its layers as PNG, and give --spacing with the height of a layer"),
      unread("GIPL", {".gipl"}, {}, "convert it, e.g. with: c3d FILE -o OUT.nii.gz"),
      unread("a pointer of Git LFS", {}, {{0, "version https://git-lfs"}},
             "fetch the file itself with: git lfs pull"),
      unread("a MIME message, as DICOMweb sends", {}, {{anywhere, "Content-Type: "}},
             "fetch the files with a client that takes it apart, such as dicomweb_client"),
      unread("a web page", {".html", ".htm"}, {{anywhere, "<html"}, {0, "<!DOCTYPE"}},
             "download the file again, signed in where that is needed"),
      unread("tar", {".tar", ".tgz"}, {}, unpack_it),
      unread("7z", {".7z"}, {{0, "7z\xbc\xaf\x27\x1c"}}, unpack_it),
      unread("RAR", {".rar"}, {{0, "Rar!\x1a"}}, unpack_it),
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
      if (magic.offset == anywhere) return head.find(magic.bytes) != head.npos;
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

bool is_stream_name(const std::filesystem::path& file) {
  return lower(file.extension().string()) == ".dmc";
}

bool is_mesh_name(const std::filesystem::path& file) {
  constexpr std::string_view meshes[] = {".stl", ".ply", ".obj", ".glb", ".gltf", ".3mf", ".vtp"};
  const std::string extension = lower(file.extension().string());
  return std::find(std::begin(meshes), std::end(meshes), extension) != std::end(meshes);
}

}  // namespace discmc::command
