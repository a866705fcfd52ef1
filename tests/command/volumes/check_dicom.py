#!/usr/bin/env python3
"""check_dicom.py DISCMC FOLDER [COUNT]: random volumes as DICOM of many kinds, by pydicom, and whether discmc finds them.

For scripts/check/dicom. On Debian: python3-pydicom, python3-numpy. Of every volume the extents, the sum of its values
and where they lie must be right: one voxel is bright, and its surface must be around where the affine map has it.
"""
import math
import pathlib
import random
import shutil
import struct
import subprocess
import sys

import numpy
from pydicom.dataset import Dataset, FileDataset, FileMetaDataset
from pydicom.sequence import Sequence
from pydicom.uid import (CTImageStorage, EnhancedMRImageStorage, ExplicitVRBigEndian,
                         ExplicitVRLittleEndian, ImplicitVRLittleEndian, MRImageStorage,
                         NuclearMedicineImageStorage, RTDoseStorage, generate_uid)

BRIGHT = 120


class Volume:
    """Samples [z, y, x], and the affine map from (x, y, z) to the patient."""

    def __init__(self, rng, kind):
        self.rng, self.kind = rng, kind
        shape = [rng.randint(3, 9) for _ in range(3)]
        self.type = rng.choice(["u1", "i2", "u2"] + (["i4", "u4"] if kind != "mosaic" else []))
        self.samples = numpy.array([rng.randint(0, 40) for _ in range(math.prod(shape))]).reshape(shape)
        self.bright = [rng.randint(1, size - 2) for size in shape[::-1]]
        self.samples[tuple(self.bright[::-1])] = BRIGHT
        row, column = self.directions()
        normal = numpy.cross(row, column)
        # Rounded positions tell no smaller ones.
        self.spacing = [round(rng.uniform(0.5 if kind == "rounded" else 0.3, 4), 2) for _ in range(3)]
        step = self.spacing[2] * normal
        if kind == "tilt":
            step = step + column * self.spacing[2] * rng.uniform(-0.4, 0.4)
        if kind in ("mosaic", "nuclear"):
            step = step * rng.choice([-1, 1])
        if kind == "dose":  # both ways of telling offsets need it
            row, column, step = numpy.array([1.0, 0, 0]), numpy.array([0, 1.0, 0]), numpy.array([0, 0, self.spacing[2]])
        self.row, self.column, self.step = row, column, step
        self.origin = numpy.array([round(rng.uniform(-300, 300), 1) for _ in range(3)])

    def directions(self):
        if self.rng.random() < 0.5:
            axes = numpy.eye(3)[self.rng.sample(range(3), 3)]
            return [axis * self.rng.choice([-1.0, 1.0]) for axis in axes[:2]]
        turn, _ = numpy.linalg.qr(numpy.array([[self.rng.gauss(0, 1) for _ in range(3)] for _ in range(3)]))
        return turn[0], turn[1]

    def at(self, x, y, z):
        return self.origin + x * self.spacing[0] * self.row + y * self.spacing[1] * self.column + z * self.step


def decimals(numbers):
    return [f"{number:.9f}"[:16] for number in numbers]


def dataset(volume, storage, modality):
    syntax = volume.rng.choice([ExplicitVRLittleEndian, ImplicitVRLittleEndian, ExplicitVRBigEndian])
    if volume.kind == "mosaic":
        syntax = ExplicitVRLittleEndian
    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID = storage
    meta.MediaStorageSOPInstanceUID = generate_uid()
    meta.TransferSyntaxUID = syntax
    data = FileDataset("", {}, file_meta=meta, preamble=b"\0" * 128)
    data.is_little_endian = syntax != ExplicitVRBigEndian
    data.is_implicit_VR = syntax == ImplicitVRLittleEndian
    data.SOPClassUID, data.SOPInstanceUID = storage, meta.MediaStorageSOPInstanceUID
    data.StudyInstanceUID = data.SeriesInstanceUID = "1.2.3"
    data.Modality = modality
    data.ImageType = ["ORIGINAL", "PRIMARY", "AXIAL"]
    return data


def add_pixels(data, volume, samples):
    data.SamplesPerPixel, data.PhotometricInterpretation = 1, "MONOCHROME2"
    data.Rows, data.Columns = samples.shape[-2:]
    kind = numpy.dtype(("<" if data.is_little_endian else ">") + volume.type)
    data.BitsAllocated = data.BitsStored = 8 * kind.itemsize
    data.HighBit = data.BitsStored - 1
    data.PixelRepresentation = int(volume.type[0] == "i")
    data.PixelData = samples.astype(kind).tobytes()
    data["PixelData"].VR = "OB" if kind.itemsize == 1 and not data.is_implicit_VR else "OW"
    if kind.itemsize == 1 and len(data.PixelData) % 2 == 1:
        data.PixelData += b"\0"


def measures(volume, target, position=None):
    target.PixelSpacing = decimals([volume.spacing[1], volume.spacing[0]])
    target.SpacingBetweenSlices = str(volume.spacing[2])
    target.ImageOrientationPatient = decimals([*volume.row, *volume.column])
    if position is not None:
        target.ImagePositionPatient = decimals(position)


def write_slices(volume, folder):
    """One or two times, in files in no order."""
    times = 2 if volume.kind == "times" else 1
    depth = len(volume.samples)
    for time in range(times):
        for z in range(depth):
            data = dataset(volume, CTImageStorage, "CT")
            position = volume.at(0, 0, z)
            if volume.kind == "rounded":
                position = numpy.round(position, 1)
            measures(volume, data, position)
            data.InstanceNumber = str(volume.rng.randint(1, 10**6))
            if times > 1:
                data.TemporalPositionIdentifier = str(time + 1)
            add_pixels(data, volume, volume.samples[z] if time == times - 1 else 0 * volume.samples[z])
            data.save_as(folder / f"{volume.rng.random()}", write_like_original=False)
    return ["--frame", "1"] if times > 1 else []


def write_enhanced(volume, folder):
    data = dataset(volume, EnhancedMRImageStorage, "MR")
    order = list(range(len(volume.samples)))
    volume.rng.shuffle(order)
    groups = []
    for z in order:
        place, orientation, pixels, group = Dataset(), Dataset(), Dataset(), Dataset()
        place.ImagePositionPatient = decimals(volume.at(0, 0, z))
        orientation.ImageOrientationPatient = decimals([*volume.row, *volume.column])
        pixels.PixelSpacing = decimals([volume.spacing[1], volume.spacing[0]])
        group.PlanePositionSequence = Sequence([place])
        group.PlaneOrientationSequence = Sequence([orientation])
        group.PixelMeasuresSequence = Sequence([pixels])
        groups.append(group)
    data.PerFrameFunctionalGroupsSequence = Sequence(groups)
    data.NumberOfFrames = str(len(order))
    add_pixels(data, volume, volume.samples[order])
    data.save_as(folder / "v.dcm", write_like_original=False)
    return []


def write_frames(volume, folder):
    """Cone beams, doses and nuclear medicine: one position for all frames."""
    storage, modality = {"cone": (CTImageStorage, "CT"), "dose": (RTDoseStorage, "RTDOSE"),
                         "nuclear": (NuclearMedicineImageStorage, "NM")}[volume.kind]
    data = dataset(volume, storage, modality)
    data.NumberOfFrames = str(len(volume.samples))
    measures(volume, data, volume.origin)
    if volume.kind == "dose":
        first = volume.rng.choice([0.0, volume.origin[2]])
        data.GridFrameOffsetVector = decimals(first + z * volume.spacing[2] for z in range(len(volume.samples)))
        data.DoseGridScaling, data.DoseUnits = "0.5", "GY"
    if volume.kind == "nuclear":
        detector = Dataset()
        detector.ImagePositionPatient, detector.ImageOrientationPatient = (data.ImagePositionPatient,
                                                                           data.ImageOrientationPatient)
        data.DetectorInformationSequence = Sequence([detector])
        del data.ImagePositionPatient, data.ImageOrientationPatient
        data.ImageType = ["ORIGINAL", "PRIMARY", "RECON TOMO", "EMISSION"]
        way = numpy.dot(volume.step, numpy.cross(volume.row, volume.column))
        data.SpacingBetweenSlices = str(math.copysign(volume.spacing[2], way))
    add_pixels(data, volume, volume.samples)
    data.save_as(folder / "v.dcm", write_like_original=False)
    return []


def csa_header(slices, normal):
    elements = [("EchoLinePosition", ["64"]), ("NumberOfImagesInMosaic", [str(slices)]),
                ("SliceNormalVector", [f"{component:.8f}" for component in normal])]
    header = b"SV10\4\3\2\1" + struct.pack("<II", len(elements), 77)
    for name, values in elements:
        header += name.encode().ljust(64, b"\0") + struct.pack("<I", len(values)) + b"FD\0\0" + struct.pack("<III", 4, 6, 77)
        for i in range(6):
            value = values[i].encode() + b"\0" if i < len(values) else b""
            header += struct.pack("<IIII", len(value), len(value), 77, len(value))
            header += value + b"\0" * (-len(value) % 4)
    return header


def write_mosaic(volume, folder):
    data = dataset(volume, MRImageStorage, "MR")
    depth, height, width = volume.samples.shape
    across = math.ceil(math.sqrt(depth))
    picture = numpy.zeros((across * height, across * width), int)
    for z, samples in enumerate(volume.samples):
        top, left = z // across * height, z % across * width
        picture[top:top + height, left:left + width] = samples
    # That of a picture as large as the mosaic, around the first slice.
    aside = (across - 1) / 2
    measures(volume, data, volume.at(-aside * width, -aside * height, 0))
    data.ImageType = ["ORIGINAL", "PRIMARY", "M", "ND", "MOSAIC"]
    data.add_new(0x00290010, "LO", "SIEMENS CSA HEADER")
    data.add_new(0x00291010, "OB", csa_header(depth, volume.step / volume.spacing[2]))
    add_pixels(data, volume, picture)
    data.save_as(folder / "v.dcm", write_like_original=False)
    return []


WRITERS = {"slices": write_slices, "tilt": write_slices, "times": write_slices, "rounded": write_slices,
           "enhanced": write_enhanced, "cone": write_frames, "dose": write_frames, "nuclear": write_frames,
           "mosaic": write_mosaic}


def run(discmc, *arguments):
    return subprocess.run([discmc, *map(str, arguments)], check=True, capture_output=True, text=True).stdout


def check(discmc, volume, folder):
    """Returns what is wrong, or nothing."""
    options = WRITERS[volume.kind](volume, folder)
    scale = 0.5 if volume.kind == "dose" else 1
    info = dict(line.split(" ", 1) for line in run(discmc, "info", folder, *options).splitlines() if " " in line)
    if [int(size) for size in info["dimensions"].split()] != list(volume.samples.shape[::-1]):
        return f"dimensions {info['dimensions']}"
    if abs(float(info["mean"]) - scale * volume.samples.mean()) > 1e-3:
        return f"mean {info['mean']}"
    run(discmc, "extract", folder, *options, "--iso", scale * (BRIGHT + 40) / 2, "--space", "lps", "-q", "-o", folder / "v.obj")
    vertices = numpy.array([line.split()[1:4] for line in (folder / "v.obj").read_text().splitlines()
                            if line.startswith("v ")], float)
    off = numpy.abs(vertices.mean(0) - volume.at(*volume.bright)).max()
    allowed = 0.15 if volume.kind == "rounded" else 0.03 * min(volume.spacing)
    return f"{off} mm off" if len(vertices) != 6 or off > allowed else ""


def main(discmc, folder, count=200):
    failed = 0
    for seed in range(int(count)):
        rng = random.Random(seed)
        volume = Volume(rng, rng.choice(list(WRITERS)))
        shutil.rmtree(folder, ignore_errors=True)
        pathlib.Path(folder).mkdir(parents=True)
        try:
            wrong = check(discmc, volume, pathlib.Path(folder))
        except subprocess.CalledProcessError as error:
            wrong = error.stderr
        if wrong:
            failed += 1
            print(f"FAILED  volume {seed}, {volume.kind}: {wrong}")
    print(f"{'FAILED ' if failed else 'ok     '} {int(count) - failed} of {count} random volumes")
    return 1 if failed else 0


sys.exit(main(*sys.argv[1:]))
