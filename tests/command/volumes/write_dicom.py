#!/usr/bin/env python3
"""write_dicom.py FOLDER: writes the DICOM files of dicom_test.cpp, with pydicom, GDCM, DCMTK and Pillow.

On Debian: python3-pydicom, python3-numpy, python3-pil, libgdcm-tools and dcmtk. The volume is 8 by 6 by 5 voxels of
0.5, 0.75 and 2.5 mm; the test knows its values by the same formula.
"""
import io
import pathlib
import subprocess
import sys

import numpy
import PIL.Image
from pydicom.dataset import Dataset, FileDataset, FileMetaDataset
from pydicom.encaps import encapsulate
from pydicom.sequence import Sequence
from pydicom.uid import (CTImageStorage, DeflatedExplicitVRLittleEndian, EnhancedCTImageStorage,
                         ExplicitVRBigEndian, ExplicitVRLittleEndian, ImplicitVRLittleEndian,
                         JPEG2000Lossless)

WIDTH, HEIGHT, DEPTH = 8, 6, 5
BASIC_TEXT = "1.2.840.10008.5.1.4.1.1.88.11"
PARAMETRIC_MAP = "1.2.840.10008.5.1.4.1.1.30"
SERIES = "1.2.826.0.1.3680043.10.1.1"

x, y, z = numpy.meshgrid(range(WIDTH), range(HEIGHT), range(DEPTH), indexing="ij")
volume = (x * 7919 + y * 1047 + z * 12997) % 4001 - 2000  # [x, y, z]


def slice_of(values, k):
    """One slice, as rows along x."""
    return numpy.ascontiguousarray(values[:, :, k].T)


def dataset(storage, syntax, instance):
    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID = storage
    meta.MediaStorageSOPInstanceUID = instance
    meta.TransferSyntaxUID = syntax
    data = FileDataset("", {}, file_meta=meta, preamble=b"\0" * 128)
    data.is_little_endian = syntax != ExplicitVRBigEndian
    data.is_implicit_VR = syntax == ImplicitVRLittleEndian
    data.SOPClassUID = storage
    data.SOPInstanceUID = instance
    data.StudyInstanceUID = "1.2.826.0.1.3680043.10.1"
    data.SeriesInstanceUID = SERIES
    data.SeriesNumber = "4"
    data.SeriesDescription = "Head 2.5"
    data.Modality = "CT"
    return data


def add_pixels(data, samples, bits=None):
    """samples: one or more slices."""
    width = samples.dtype.itemsize * 8
    data.SamplesPerPixel = 1
    data.PhotometricInterpretation = "MONOCHROME2"
    data.Rows, data.Columns = HEIGHT, WIDTH
    data.BitsAllocated = width
    data.BitsStored = bits or width
    data.HighBit = (bits or width) - 1
    data.PixelRepresentation = 1 if samples.dtype.kind == "i" else 0
    order = "<" if data.is_little_endian else ">"
    data.PixelData = samples.astype(samples.dtype.newbyteorder(order)).tobytes()
    data["PixelData"].VR = "OB" if width == 8 else "OW"


def position(k):
    """A UID of fixed length, so that the test can replace it."""
    return ["-10.000", "-20.000", f"{100 + 2.5 * k:07.3f}"]


ORIENTATION = ["1.000", "0.000", "0.000", "0.000", "1.000", "0.000"]


def save(data, path):
    path.parent.mkdir(parents=True, exist_ok=True)
    data.save_as(path, write_like_original=False)


def write_series(folder, samples, slopes=None, bits=None):
    """One file per slice. Neither names nor instance numbers have the order of the slices."""
    for k, name in enumerate(["IM3", "IM0", "IM4", "IM1", "IM2"]):
        data = dataset(CTImageStorage, ExplicitVRLittleEndian, f"{SERIES}.{k + 1}")
        data.InstanceNumber = str((k * 3 + 1) % 5)
        data.ImagePositionPatient = position(k)
        data.ImageOrientationPatient = ORIENTATION
        data.PixelSpacing = ["0.75", "0.5"]
        data.SliceThickness = "9"
        data.RescaleSlope = slopes[k] if slopes else "0.5"
        data.RescaleIntercept = "-1024"
        add_pixels(data, slice_of(samples, k), bits)
        save(data, folder / name)


def jpeg2000(samples):
    """One slice as a lossless code stream."""
    picture = PIL.Image.fromarray(samples.astype("<u2"))
    stream = io.BytesIO()
    picture.save(stream, "JPEG2000", irreversible=False, num_resolutions=2, no_jp2=True)
    return stream.getvalue()


def write_frames(path, samples, syntax=ExplicitVRLittleEndian, storage=EnhancedCTImageStorage,
                 bits=None):
    """One file with all slices, ordered only by their positions."""
    order = [2, 0, 4, 1, 3]
    data = dataset(storage, syntax, f"{SERIES}.9")
    data.NumberOfFrames = str(DEPTH)
    measures, orientation, shared = Dataset(), Dataset(), Dataset()
    measures.PixelSpacing = ["0.75", "0.5"]
    measures.SliceThickness = "9"
    orientation.ImageOrientationPatient = ORIENTATION
    shared.PixelMeasuresSequence = Sequence([measures])
    shared.PlaneOrientationSequence = Sequence([orientation])
    data.SharedFunctionalGroupsSequence = Sequence([shared])
    frames = []
    for k in order:
        place, values, frame = Dataset(), Dataset(), Dataset()
        place.ImagePositionPatient = position(k)
        values.RescaleSlope, values.RescaleIntercept = "0.5", "-1024"
        values.RescaleType = "HU"
        frame.PlanePositionSequence = Sequence([place])
        frame.PixelValueTransformationSequence = Sequence([values])
        frames.append(frame)
    data.PerFrameFunctionalGroupsSequence = Sequence(frames)
    pixels = numpy.stack([slice_of(samples, k) for k in order])
    if pixels.dtype.kind == "f":
        data.SamplesPerPixel = 1
        data.PhotometricInterpretation = "MONOCHROME2"
        data.Rows, data.Columns = HEIGHT, WIDTH
        data.BitsAllocated = 32
        data.FloatPixelData = pixels.astype("<f4").tobytes()
    else:
        add_pixels(data, pixels, bits)
    if syntax == JPEG2000Lossless:
        data.PixelData = encapsulate([jpeg2000(frame) for frame in pixels])
        data["PixelData"].VR = "OB"
        data["PixelData"].is_undefined_length = True
    save(data, path)


def main(folder):
    i16 = volume.astype(numpy.int16)
    u8 = (volume % 251).astype(numpy.uint8)
    write_series(folder / "series", i16)
    # Values in twelve bits, with other bits above them.
    packed = (volume & 0xFFF | (x % 16) << 12).astype(numpy.uint16)
    write_series(folder / "packed", packed.view(numpy.int16), bits=12)
    write_series(folder / "scaled", i16, slopes=["1", "0.25", "2", "0.5", "1"])
    write_frames(folder / "little.dcm", i16)
    write_frames(folder / "implicit.dcm", i16, ImplicitVRLittleEndian)
    write_frames(folder / "big.dcm", i16, ExplicitVRBigEndian)
    write_frames(folder / "u16.dcm", (volume + 2000).astype(numpy.uint16))
    write_frames(folder / "u8.dcm", u8)
    write_frames(folder / "i32.dcm", (volume * 70000).astype(numpy.int32))
    write_frames(folder / "f32.dcm", (volume / 4).astype(numpy.float32), storage=PARAMETRIC_MAP)
    write_frames(folder / "u16-j2k.dcm", (volume + 2000).astype(numpy.uint16), JPEG2000Lossless)
    for kind in ["rle", "jpeg", "jpegls"]:
        for name in ["u16", "u8"]:
            subprocess.run(["gdcmconv", "--" + kind, folder / f"{name}.dcm",
                            folder / f"{name}-{kind}.dcm"], check=True)
    write_frames(folder / "deflated.dcm", i16, DeflatedExplicitVRLittleEndian)
    # Smooth, so that compression loses little.
    smooth = x + 2 * y + 4 * z
    for name, samples, bits, process in [("u8-lossy", (5 * smooth).astype(numpy.uint8), 8, "+eb"),
                                         ("u12-lossy", (80 * smooth).astype(numpy.uint16), 12, "+ee")]:
        write_frames(folder / f"{name}.dcm", samples, bits=bits)
        subprocess.run(["dcmcjpeg", process, folder / f"{name}.dcm", folder / f"{name}.dcm"], check=True)
    report = dataset(BASIC_TEXT, ExplicitVRLittleEndian, f"{SERIES}.99")
    report.Modality = "SR"
    save(report, folder / "report.dcm")
    colour = dataset(CTImageStorage, ExplicitVRLittleEndian, f"{SERIES}.98")
    add_pixels(colour, slice_of(u8, 0))
    colour.SamplesPerPixel = 3
    colour.PhotometricInterpretation = "RGB"
    colour.PlanarConfiguration = 0
    colour.PixelData = colour.PixelData * 3
    save(colour, folder / "colour.dcm")


main(pathlib.Path(sys.argv[1]))
