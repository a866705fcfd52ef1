#!/usr/bin/env python3
"""write_dicom_head.py VOLUME.nrrd FOLDER: a volume as DICOM, a folder a way of storing it.

For scripts/check/dicom. On Debian: python3-pydicom, python3-numpy, python3-pil, libgdcm-tools.
"""
import gzip
import io
import pathlib
import random
import subprocess
import sys

import numpy
import PIL.Image
from pydicom.dataset import Dataset, FileDataset, FileMetaDataset
from pydicom.encaps import encapsulate
from pydicom.sequence import Sequence
from pydicom.uid import (CTImageStorage, EnhancedCTImageStorage, ExplicitVRLittleEndian,
                         JPEG2000Lossless, generate_uid)

TYPES = {"short": "<i2", "int16": "<i2", "ushort": "<u2", "uint16": "<u2", "uchar": "u1",
         "uint8": "u1"}


def read_nrrd(path):
    """Returns samples [z, y, x] and the spacing."""
    head, body = path.read_bytes().split(b"\n\n", 1)
    fields = dict(line.split(": ", 1) for line in head.decode().splitlines() if ": " in line)
    body = gzip.decompress(body) if fields["encoding"] in ("gzip", "gz") else body
    samples = numpy.frombuffer(body, TYPES[fields["type"]])
    if fields.get("endian") == "big":
        samples = samples.byteswap()
    sizes = [int(size) for size in fields["sizes"].split()]
    if "spacings" in fields:
        spacing = [float(word) for word in fields["spacings"].split()]
    else:
        vectors = fields["space directions"].split()
        spacing = [abs(float(v.strip("()").split(",")[i])) for i, v in enumerate(vectors)]
    return samples.reshape(sizes[::-1]), spacing


def dataset(storage, syntax, series):
    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID = storage
    meta.MediaStorageSOPInstanceUID = generate_uid()
    meta.TransferSyntaxUID = syntax
    data = FileDataset("", {}, file_meta=meta, preamble=b"\0" * 128)
    data.is_little_endian, data.is_implicit_VR = True, False
    data.SOPClassUID = storage
    data.SOPInstanceUID = meta.MediaStorageSOPInstanceUID
    data.SeriesInstanceUID = series
    data.Modality = "CT"
    return data


def add_pixels(data, samples):
    data.SamplesPerPixel = 1
    data.PhotometricInterpretation = "MONOCHROME2"
    data.Rows, data.Columns = samples.shape[-2:]
    bits = samples.dtype.itemsize * 8
    data.BitsAllocated, data.BitsStored, data.HighBit = bits, bits, bits - 1
    data.PixelRepresentation = 1 if samples.dtype.kind == "i" else 0
    data.PixelData = samples.tobytes()
    data["PixelData"].VR = "OW"


def write_slices(folder, samples, spacing):
    folder.mkdir(parents=True)
    series = generate_uid()
    names = random.Random(1).sample(range(len(samples)), len(samples))
    for k, name in enumerate(names):
        data = dataset(CTImageStorage, ExplicitVRLittleEndian, series)
        data.ImagePositionPatient = [0, 0, round(k * spacing[2], 6)]
        data.ImageOrientationPatient = [1, 0, 0, 0, 1, 0]
        data.PixelSpacing = [spacing[1], spacing[0]]
        add_pixels(data, samples[k])
        data.save_as(folder / f"IM{name:05}", write_like_original=False)


def jpeg2000(samples):
    stream = io.BytesIO()
    PIL.Image.fromarray(samples.view("<u2")).save(stream, "JPEG2000", irreversible=False,
                                                  no_jp2=True)
    return stream.getvalue()


def write_frames(path, samples, spacing, syntax):
    path.parent.mkdir(parents=True)
    data = dataset(EnhancedCTImageStorage, syntax, generate_uid())
    data.NumberOfFrames = len(samples)
    measures, orientation, shared = Dataset(), Dataset(), Dataset()
    measures.PixelSpacing = [spacing[1], spacing[0]]
    orientation.ImageOrientationPatient = [1, 0, 0, 0, 1, 0]
    shared.PixelMeasuresSequence = Sequence([measures])
    shared.PlaneOrientationSequence = Sequence([orientation])
    data.SharedFunctionalGroupsSequence = Sequence([shared])
    frames = []
    for k in reversed(range(len(samples))):
        place, frame = Dataset(), Dataset()
        place.ImagePositionPatient = [0, 0, round(k * spacing[2], 6)]
        frame.PlanePositionSequence = Sequence([place])
        frames.append(frame)
    data.PerFrameFunctionalGroupsSequence = Sequence(frames)
    add_pixels(data, samples[::-1].copy())
    if syntax == JPEG2000Lossless:
        data.PixelData = encapsulate([jpeg2000(frame.copy()) for frame in samples[::-1]])
        data["PixelData"].VR = "OB"
        data["PixelData"].is_undefined_length = True
    data.save_as(path, write_like_original=False)


def main(volume, folder):
    samples, spacing = read_nrrd(volume)
    write_slices(folder / "slices", samples, spacing)
    for kind in ["rle", "jpeg", "jpegls"]:
        (folder / kind).mkdir()
        for file in (folder / "slices").iterdir():
            subprocess.run(["gdcmconv", "--" + kind, file, folder / kind / file.name], check=True)
    write_frames(folder / "frames/head.dcm", samples, spacing, ExplicitVRLittleEndian)
    write_frames(folder / "frames-jpeg2000/head.dcm", samples, spacing, JPEG2000Lossless)


main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
