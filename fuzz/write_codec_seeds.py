#!/usr/bin/env python3
"""write_codec_seeds.py FOLDER: writes an input of volume_readers for each codec of DICOM and TIFF.

The inputs are dicom_CODEC, tiff_CODEC and, with RLE that contradicts itself, hostile_rle_FAULT. On Debian: python3-pydicom,
python3-numpy, python3-pil, dcmtk and libtiff6. LibTIFF has no encoder for three codecs; those files are
made here. OpenJPEG and the JPEG encoders may write other bytes in another version.
"""
import ctypes
import io
import pathlib
import struct
import subprocess
import sys
import tempfile

import numpy
import PIL.Image
from pydicom.dataset import FileDataset, FileMetaDataset
from pydicom.uid import (CTImageStorage, ExplicitVRBigEndian, ExplicitVRLittleEndian,
                         ImplicitVRLittleEndian, JPEG2000, JPEG2000Lossless, RLELossless)

WIDTH, HEIGHT = 8, 6
# Words of the pixels have the high byte first, all else the low one.
GE_BIG_ENDIAN_PIXELS = "1.2.840.113619.5.2"
DICOM, TIFF = 12, 14  # the places of v.dcm and v.tif in the names of volume_readers.cpp


def write_input(path, number, content, choice=0):
    """number: of the file's name. choice: not packed, no options. The last byte: an isovalue of 0."""
    path.write_bytes(bytes([number, choice, 128]) + content)


def encoded(samples, codec, **options):
    stream = io.BytesIO()
    PIL.Image.fromarray(samples).save(stream, codec, **options)
    return stream.getvalue()


# ---- DICOM ----

def dataset(samples, syntax=ExplicitVRLittleEndian):
    """samples: of one slice."""
    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID = CTImageStorage
    meta.MediaStorageSOPInstanceUID = "1.2.3"
    meta.TransferSyntaxUID = syntax
    data = FileDataset("", {}, file_meta=meta, preamble=b"\0" * 128)
    data.is_little_endian = syntax != ExplicitVRBigEndian
    data.is_implicit_VR = syntax == ImplicitVRLittleEndian
    data.SOPClassUID = CTImageStorage
    data.SOPInstanceUID = "1.2.3"
    data.StudyInstanceUID = "1.2"
    data.SeriesInstanceUID = "1.2.1"
    data.SamplesPerPixel = 1
    data.PhotometricInterpretation = "MONOCHROME2"
    data.Rows, data.Columns = samples.shape
    data.BitsAllocated = 8 * samples.dtype.itemsize
    data.BitsStored = 8 if samples.dtype.itemsize == 1 else 12
    data.HighBit = data.BitsStored - 1
    data.PixelRepresentation = 0
    order = "<" if data.is_little_endian else ">"
    data.PixelData = samples.astype(samples.dtype.newbyteorder(order)).tobytes()
    data["PixelData"].VR = "OB" if data.BitsAllocated == 8 else "OW"
    return data


def dicom_bytes(data):
    stream = io.BytesIO()
    data.save_as(stream, write_like_original=False)
    return stream.getvalue()


def encapsulated(samples, syntax, fragments):
    data = dataset(samples)
    data.file_meta.TransferSyntaxUID = syntax
    items = [b"", *fragments]  # before the fragments a table of offsets
    data.PixelData = b"".join(struct.pack("<HHI", 0xfffe, 0xe000, len(item) + len(item) % 2) + item +
                              b"\0" * (len(item) % 2) for item in items)
    data["PixelData"].VR = "OB"
    data["PixelData"].is_undefined_length = True
    return data


def write_dicom(folder, u8, u16):
    for name, syntax in [("implicit", ImplicitVRLittleEndian), ("little_endian", ExplicitVRLittleEndian),
                         ("big_endian", ExplicitVRBigEndian)]:
        write_input(folder / f"dicom_{name}", DICOM, dicom_bytes(dataset(u16, syntax)))
    ge = dicom_bytes(dataset(u16.byteswap(), ImplicitVRLittleEndian))
    write_input(folder / "dicom_ge", DICOM, ge.replace(
        ImplicitVRLittleEndian.encode() + b"\0", GE_BIG_ENDIAN_PIXELS.encode()))
    for name, samples, *command in [
            ("rle", u16, "dcmcrle"),
            ("jpeg_baseline", u8, "dcmcjpeg", "+eb"),
            ("jpeg_extended", u16, "dcmcjpeg", "+ee"),
            ("jpeg_spectral", u16, "dcmcjpeg", "+es"),
            ("jpeg_progressive", u16, "dcmcjpeg", "+ep"),
            ("jpeg_lossless", u16, "dcmcjpeg", "+el"),
            ("jpeg_lossless_sv1", u16, "dcmcjpeg", "+e1"),
            ("jpegls_lossless", u16, "dcmcjpls", "+el"),
            ("jpegls_lossy", u16, "dcmcjpls", "+en")]:
        with tempfile.TemporaryDirectory() as work:
            plain, packed = pathlib.Path(work, "plain"), pathlib.Path(work, "packed")
            plain.write_bytes(dicom_bytes(dataset(samples)))
            subprocess.run([*command, plain, packed], check=True)
            write_input(folder / f"dicom_{name}", DICOM, packed.read_bytes())
    for name, syntax, loses in [("lossless", JPEG2000Lossless, False), ("lossy", JPEG2000, True)]:
        stream = encoded(u16, "JPEG2000", irreversible=loses, num_resolutions=2, no_jp2=True)
        write_input(folder / f"dicom_jpeg2000_{name}", DICOM,
                    dicom_bytes(encapsulated(u16, syntax, [stream])))


def rle(segments, offsets=None, count=None):
    if offsets is None:
        offsets = [64 + sum(map(len, segments[:i])) for i in range(len(segments))]
    header = [len(segments) if count is None else count, *offsets]
    return struct.pack("<16I", *header, *[0] * (16 - len(header))) + b"".join(segments)


def write_hostile_rle(folder, u8, u16):
    run = bytes([257 - WIDTH * HEIGHT, 7])
    for name, fragments in {
            "empty_fragment": [b""],
            "no_header": [b"\1\0\0\0"],
            "offset_far": [rle([run], [0x20000000])],
            "offset_near": [rle([run], [64 + 256])],
            "offset_in_header": [rle([run], [0])],
            "offsets_out_of_order": [rle([run, run], [66, 64])],
            "no_segments": [rle([run], [], 0)],
            "many_segments": [rle([run], None, 16)],
            "max_segments": [rle([run], None, 0xffffffff)],
            "too_short": [rle([bytes([257 - 40, 7])])],
            "too_long": [rle([run + run])],
            "cut_run": [rle([bytes([128, 257 - WIDTH * HEIGHT])])],
            "cut_literals": [rle([bytes([47, 7])])],
            "fragments": [rle([run])[:30], rle([run])[30:]],
            "missing_frame": [rle([run])],
    }.items():
        data = encapsulated(u16 if name == "offsets_out_of_order" else u8, RLELossless, fragments)
        data.NumberOfFrames = 2 if name == "missing_frame" else 1
        write_input(folder / f"hostile_rle_{name}", DICOM, dicom_bytes(data))


# ---- TIFF ----

def write_by_libtiff(path, codec, samples, bits=8, photometric=1, components=1):
    """samples: the rows of the file, as bytes."""
    library = ctypes.CDLL("libtiff.so.6")
    library.TIFFOpen.restype = ctypes.c_void_p
    tiff = ctypes.c_void_p(library.TIFFOpen(str(path).encode(), b"wl"))
    for tag, value in [(256, WIDTH), (257, HEIGHT), (258, bits), (259, codec), (262, photometric), (277, components),
                       (278, HEIGHT), (284, 1)]:
        library.TIFFSetField(tiff, ctypes.c_uint32(tag), ctypes.c_int(value))
    if library.TIFFWriteEncodedStrip(tiff, 0, samples, ctypes.c_size_t(len(samples))) < 0:
        sys.exit(f"write_codec_seeds.py: LibTIFF cannot write codec {codec}")
    library.TIFFClose(tiff)


def tiff(codec, bits, strip, more=()):
    """A file of one strip, which is at byte 8. more: other tags with their values."""
    tags = sorted([(256, WIDTH), (257, HEIGHT), (258, bits), (259, codec), (262, 1), (273, 8), (277, 1),
                   (278, HEIGHT), (279, len(strip)), *more])
    strip += b"\0" * (len(strip) % 2)
    directory = b"".join(struct.pack("<HHII", tag, 4, 1, value) for tag, value in tags)
    return (b"II*\0" + struct.pack("<I", 8 + len(strip)) + strip + struct.pack("<H", len(tags)) + directory +
            b"\0\0\0\0")


def write_tiff(folder, u8):
    grey = u8.tobytes()
    bilevel = bytes(range(3, 3 + HEIGHT))
    codecs = {"none": 1, "lzw": 5, "jpeg": 7, "deflate": 8, "packbits": 32773, "pixar_log": 32909,
              "old_deflate": 32946, "lzma": 34925, "zstd": 50000, "lerc": 34887}
    bilevel_codecs = {"ccitt_rle": 2, "ccitt_g3": 3, "ccitt_g4": 4, "ccitt_rlew": 32771, "jbig": 34661}
    with tempfile.TemporaryDirectory() as work:
        path = pathlib.Path(work, "v.tif")
        for name, codec in codecs.items():
            write_by_libtiff(path, codec, grey)
            write_input(folder / f"tiff_{name}", TIFF, path.read_bytes())
        for name, codec in bilevel_codecs.items():
            write_by_libtiff(path, codec, bilevel, 1, 0)
            write_input(folder / f"tiff_{name}", TIFF, path.read_bytes())
        write_by_libtiff(path, 50001, grey * 3, 8, 2, 3)
        write_input(folder / "tiff_webp", TIFF, path.read_bytes(), choice=24)  # channel 0
    stream = encoded(u8, "JPEG")
    write_input(folder / "tiff_old_jpeg", TIFF,
                tiff(6, 8, stream, [(512, 1), (513, 8), (514, len(stream))]))
    write_input(folder / "tiff_thunder_scan", TIFF, tiff(32809, 4, bytes([0xc0 | 5] * WIDTH * HEIGHT)))
    write_input(folder / "tiff_next", TIFF, tiff(32766, 2, (b"\0" + b"\x1b" * (WIDTH // 4)) * HEIGHT))


def main(folder):
    x, y = numpy.meshgrid(range(WIDTH), range(HEIGHT))
    u8 = (20 * x + 10 * y).astype(numpy.uint8)
    u16 = (300 * x + 150 * y).astype(numpy.uint16)
    write_dicom(folder, u8, u16)
    write_hostile_rle(folder, u8, u16)
    write_tiff(folder, u8)


main(pathlib.Path(sys.argv[1]))
