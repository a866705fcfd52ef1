"""DICOM by pydicom, of the kinds whose slices lie elsewhere than a file each says: of many frames, of
one position for all of them, in a mosaic, in several times, tilted; and segmentations."""
import math
import struct

import numpy
from pydicom.dataset import Dataset, FileDataset, FileMetaDataset
from pydicom.sequence import Sequence
from pydicom.uid import (CTImageStorage, EnhancedMRImageStorage, ExplicitVRBigEndian,
                         ExplicitVRLittleEndian, ImplicitVRLittleEndian, MRImageStorage,
                         NuclearMedicineImageStorage, RTDoseStorage, SegmentationStorage)

from cases import Case, body, dims, generator, origin, place_of, rotation, samples, spacing

TYPES = ["u1", "i2", "u2", "i4", "u4"]


def decimal(number):
    """At most 16 characters, as in the standard."""
    return f"{number:.9g}"


def decimals(numbers):
    return [decimal(number) for number in numbers]


class Scan:
    """A volume, by x, y and z, and its placement: along the normal of its slices."""

    def __init__(self, random, types=TYPES):
        self.random = random
        self.values, self.iso = samples(random, dims(random), str(random.choice(types)))
        self.directions, self.step, self.at = rotation(random), spacing(random), origin(random)
        self.directions[:, 2] = numpy.cross(self.directions[:, 0], self.directions[:, 1])
        self.place = place_of(self.directions, self.step, self.at)

    @property
    def depth(self):
        return self.values.shape[2]

    def position(self, z):
        return decimals(self.place[:3, :3] @ [0, 0, z] + self.place[:3, 3])

    def case(self, folder, scale=1, options=()):
        return Case(str(folder), scale * self.values.astype(float), self.place, "lps", options, scale * self.iso)


def file(scan, storage, modality, syntax=None):
    syntax = syntax or [ExplicitVRLittleEndian, ImplicitVRLittleEndian, ExplicitVRBigEndian][
        scan.random.integers(3)]
    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID = storage
    meta.MediaStorageSOPInstanceUID = f"1.2.826.0.1.{scan.random.integers(1 << 40)}"
    meta.TransferSyntaxUID = syntax
    data = FileDataset(None, Dataset(), file_meta=meta, preamble=b"\0" * 128)
    data.is_little_endian = syntax != ExplicitVRBigEndian
    data.is_implicit_VR = syntax == ImplicitVRLittleEndian
    data.SOPClassUID, data.SOPInstanceUID = storage, meta.MediaStorageSOPInstanceUID
    data.StudyInstanceUID = data.SeriesInstanceUID = "1.2.826.0.1"
    data.Modality, data.ImageType = modality, ["ORIGINAL", "PRIMARY", "AXIAL"]
    return data


def add_pixels(data, pixels):
    """pixels: rows of one slice or several."""
    data.SamplesPerPixel, data.PhotometricInterpretation = 1, "MONOCHROME2"
    data.Rows, data.Columns = pixels.shape[-2:]
    data.BitsAllocated = data.BitsStored = 8 * pixels.itemsize
    data.HighBit = data.BitsStored - 1
    data.PixelRepresentation = int(pixels.dtype.kind == "i")
    order = "<" if data.is_little_endian else ">"
    data.PixelData = pixels.astype(pixels.dtype.newbyteorder(order)).tobytes()
    data.PixelData += b"\0" * (len(data.PixelData) % 2)
    data["PixelData"].VR = "OB" if pixels.itemsize == 1 else "OW"


def add_place(data, scan, position=None):
    data.PixelSpacing = decimals(scan.step[[1, 0]])
    data.ImageOrientationPatient = decimals(scan.directions[:, :2].T.ravel())
    data.ImagePositionPatient = position or scan.position(0)


def save(data, path):
    data.save_as(path, write_like_original=False)


def write_frames(scan, folder, data, sequence=None):
    """All slices in one file. sequence: their order, if not ascending."""
    order = numpy.arange(scan.depth) if sequence is None else sequence
    data.NumberOfFrames = str(scan.depth)
    add_pixels(data, scan.values.T[order])
    save(data, folder / "volume.dcm")


def one_position(scan, storage, modality):
    data = file(scan, storage, modality)
    add_place(data, scan)
    data.SpacingBetweenSlices = decimal(scan.step[2])
    return data


@generator("DICOM of one position for all frames, by pydicom")
def cone_beam(random, folder):
    scan = Scan(random)
    write_frames(scan, folder, one_position(scan, CTImageStorage, "CT"))
    return scan.case(folder)


@generator("DICOM doses, by pydicom")
def dose(random, folder):
    scan = Scan(random, ["u2", "u4"])
    # Required if offsets are positions.
    scan.directions, scan.step[2] = numpy.eye(3), round(scan.step[2], 1)
    scan.place = place_of(scan.directions, scan.step, scan.at)
    data = one_position(scan, RTDoseStorage, "RTDOSE")
    first = random.choice([0.0, scan.at[2]])
    data.GridFrameOffsetVector = decimals(first + z * scan.step[2] for z in range(scan.depth))
    data.DoseGridScaling, data.DoseUnits = "0.125", "GY"
    write_frames(scan, folder, data)
    return scan.case(folder, 0.125)


@generator("DICOM of nuclear medicine, by pydicom")
def nuclear(random, folder):
    scan = Scan(random)
    goes_back = random.random() < 0.5
    data = file(scan, NuclearMedicineImageStorage, "NM")
    data.ImageType = ["ORIGINAL", "PRIMARY", "RECON TOMO", "EMISSION"]
    data.PixelSpacing = decimals(scan.step[[1, 0]])
    data.SpacingBetweenSlices = decimal(-scan.step[2] if goes_back else scan.step[2])
    detector = Dataset()
    add_place(detector, scan, scan.position(scan.depth - 1 if goes_back else 0))
    data.DetectorInformationSequence = Sequence([detector])
    write_frames(scan, folder, data, numpy.arange(scan.depth)[::-1] if goes_back else None)
    return scan.case(folder)


@generator("DICOM of frames in any order, by pydicom")
def enhanced(random, folder):
    scan = Scan(random)
    data = file(scan, EnhancedMRImageStorage, "MR")
    order = random.permutation(scan.depth)
    groups = []
    for z in order:
        told, group = Dataset(), Dataset()
        add_place(told, scan, scan.position(z))
        group.PlanePositionSequence = Sequence([told])
        group.PlaneOrientationSequence = Sequence([told])
        group.PixelMeasuresSequence = Sequence([told])
        groups.append(group)
    data.PerFrameFunctionalGroupsSequence = Sequence(groups)
    write_frames(scan, folder, data, order)
    return scan.case(folder)


def csa_header(slices, normal):
    """Like Siemens: six items per element; those after the last value are empty."""
    elements = {"EchoLinePosition": ["64"], "NumberOfImagesInMosaic": [str(slices)],
                "SliceNormalVector": [f"{component:.8f}" for component in normal]}
    header = b"SV10\4\3\2\1" + struct.pack("<II", len(elements), 77)
    for name, values in elements.items():
        header += name.encode().ljust(64, b"\0") + struct.pack("<I4sIII", len(values), b"FD", 4, 6, 77)
        for value in values + [""] * (6 - len(values)):
            text = value.encode() + b"\0" if value else b""
            header += struct.pack("<IIII", len(text), len(text), 77, len(text)) + text + b"\0" * (-len(text) % 4)
    return header


@generator("DICOM mosaics, by pydicom")
def mosaic(random, folder):
    scan = Scan(random, ["u2"])
    width, height, depth = scan.values.shape
    goes_back = random.random() < 0.5
    across = math.ceil(math.sqrt(depth))
    picture = numpy.zeros((across * height, across * width), scan.values.dtype)
    for number in range(depth):
        top, left = number // across * height, number % across * width
        z = depth - 1 - number if goes_back else number
        picture[top:top + height, left:left + width] = scan.values[:, :, z].T
    data = file(scan, MRImageStorage, "MR", ExplicitVRLittleEndian)
    data.ImageType = ["ORIGINAL", "PRIMARY", "M", "ND", "MOSAIC"]
    # The position of a picture as large as the mosaic, around the first slice.
    aside = (across - 1) / 2
    first = [-aside * width, -aside * height, depth - 1 if goes_back else 0]
    add_place(data, scan, decimals(scan.place[:3, :3] @ first + scan.place[:3, 3]))
    data.SpacingBetweenSlices = decimal(scan.step[2])
    normal = scan.directions[:, 2] * (-1 if goes_back else 1)
    data.add_new(0x00290010, "LO", "SIEMENS CSA HEADER")
    data.add_new(0x00291010, "OB", csa_header(depth, normal))
    add_pixels(data, picture)
    save(data, folder / "volume.dcm")
    return scan.case(folder)


def write_slices(scan, folder, time, blank=False):
    for z in range(scan.depth):
        data = file(scan, CTImageStorage, "CT")
        add_place(data, scan, scan.position(z))
        data.TemporalPositionIdentifier = str(time)
        data.InstanceNumber = str(scan.random.integers(1 << 20))
        pixels = scan.values[:, :, z].T
        add_pixels(data, 0 * pixels if blank else pixels)
        save(data, folder / f"{scan.random.integers(1 << 40)}")


@generator("DICOM of two times, by pydicom")
def times(random, folder):
    scan = Scan(random)
    write_slices(scan, folder, 1, blank=True)
    write_slices(scan, folder, 2)
    return scan.case(folder, options=("--frame", "1") if random.random() < 0.5 else ("--series", "2"))


@generator("DICOM of a tilted gantry, by pydicom")
def tilted(random, folder):
    scan = Scan(random)
    scan.place[:3, 2] += random.uniform(-0.5, 0.5) * scan.step[2] * scan.directions[:, random.integers(2)]
    write_slices(scan, folder, 1)
    return scan.case(folder)


@generator("DICOM segmentations, by pydicom")
def segmentation(random, folder):
    scan = Scan(random, ["u1"])
    scan.values, scan.iso = body(random, scan.values.shape).astype("u1"), 0.5
    data = file(scan, SegmentationStorage, "SEG")
    segment, shared, told = Dataset(), Dataset(), Dataset()
    segment.SegmentNumber, segment.SegmentLabel = 1, "Body"
    data.SegmentSequence = Sequence([segment])
    add_place(told, scan)
    told.SpacingBetweenSlices = decimal(scan.step[2])
    shared.PixelMeasuresSequence = shared.PlaneOrientationSequence = Sequence([told])
    data.SharedFunctionalGroupsSequence = Sequence([shared])
    # Empty slices in the middle are often omitted.
    order = [z for z in random.permutation(scan.depth)
             if scan.values[:, :, z].any() or z in (0, scan.depth - 1)]
    groups = []
    for z in order:
        position, number, group = Dataset(), Dataset(), Dataset()
        position.ImagePositionPatient = scan.position(z)
        number.ReferencedSegmentNumber = 1
        group.PlanePositionSequence = Sequence([position])
        group.SegmentIdentificationSequence = Sequence([number])
        groups.append(group)
    data.PerFrameFunctionalGroupsSequence = Sequence(groups)
    data.NumberOfFrames = str(len(order))
    data.SegmentationType = str(random.choice(["BINARY", "FRACTIONAL"]))
    pixels = scan.values.T[order]
    if data.SegmentationType == "BINARY":
        add_pixels(data, pixels)
        data.BitsAllocated = data.BitsStored = 1
        data.HighBit = 0
        data.PixelData = numpy.packbits(pixels.ravel(), bitorder="little").tobytes()
        data.PixelData += b"\0" * (len(data.PixelData) % 2)
        data["PixelData"].VR = "OB"
    else:
        data.MaximumFractionalValue, data.SegmentationFractionalType = 200, "PROBABILITY"
        add_pixels(data, 200 * pixels - pixels * random.integers(0, 101, pixels.shape).astype("u1"))
    save(data, folder / "volume.dcm")
    return scan.case(folder)
