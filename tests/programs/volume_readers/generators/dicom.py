"""DICOM by pydicom: a series with one file per slice."""
import numpy
import pydicom
from pydicom.dataset import FileDataset, FileMetaDataset
from pydicom.uid import (CTImageStorage, ExplicitVRBigEndian, ExplicitVRLittleEndian,
                         ImplicitVRLittleEndian, RLELossless, generate_uid)

from cases import Case, dims, generator, origin, place_of, rotation, samples, spacing


def decimal(number):
    """At most 16 characters, as in the standard."""
    return f"{number:.9g}"


def file_of_slice(common, number, pixels, position, syntax):
    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID = CTImageStorage
    meta.MediaStorageSOPInstanceUID = generate_uid(entropy_srcs=[common.SeriesInstanceUID, str(number)])
    meta.TransferSyntaxUID = syntax
    file = FileDataset(None, common, file_meta=meta, preamble=b"\0" * 128)
    file.is_little_endian = syntax != ExplicitVRBigEndian
    file.is_implicit_VR = syntax == ImplicitVRLittleEndian
    file.SOPClassUID, file.SOPInstanceUID = CTImageStorage, meta.MediaStorageSOPInstanceUID
    file.InstanceNumber = number + 1
    file.ImagePositionPatient = [decimal(each) for each in position]
    order = "<" if file.is_little_endian else ">"
    file.PixelData = pixels.astype(pixels.dtype.newbyteorder(order)).tobytes()
    if len(file.PixelData) % 2:
        file.PixelData += b"\0"
    file["PixelData"].VR = "OB" if pixels.itemsize == 1 else "OW"
    return file


@generator("DICOM, by pydicom")
def series(random, folder):
    stored_bits = int(random.choice([8, 12, 16]))
    is_signed = stored_bits > 8 and bool(random.integers(2))
    dtype = ("i" if is_signed else "u") + ("1" if stored_bits == 8 else "2")
    end = 1 << stored_bits - int(is_signed)
    values, iso = samples(random, dims(random), dtype, (-end if is_signed else 0, end - 1))
    directions, step, at = rotation(random), spacing(random), origin(random)
    # Slices follow each other along the normal, so the axes become right-handed.
    directions[:, 2] = numpy.cross(directions[:, 0], directions[:, 1])
    common = pydicom.Dataset()
    common.Modality, common.PatientName, common.PatientID = "CT", "Nobody", "0"
    common.StudyInstanceUID = generate_uid(entropy_srcs=["study", str(random.integers(1 << 30))])
    common.SeriesInstanceUID = generate_uid(entropy_srcs=["series", str(random.integers(1 << 30))])
    common.FrameOfReferenceUID = common.StudyInstanceUID
    common.Rows, common.Columns = values.shape[1], values.shape[0]
    common.SamplesPerPixel, common.PhotometricInterpretation = 1, "MONOCHROME2"
    common.BitsAllocated = 8 if stored_bits == 8 else 16
    common.BitsStored, common.HighBit = stored_bits, stored_bits - 1
    common.PixelRepresentation = int(is_signed)
    common.PixelSpacing = [decimal(step[1]), decimal(step[0])]
    common.SliceThickness = decimal(step[2])
    common.ImageOrientationPatient = [decimal(each) for each in directions[:, :2].T.ravel()]
    slope, intercept = 1.0, 0.0
    if random.random() < 0.5:
        slope, intercept = float(decimal(random.uniform(0.1, 4))), float(random.integers(-1024, 100))
        common.RescaleSlope, common.RescaleIntercept = decimal(slope), decimal(intercept)
    syntax = [ImplicitVRLittleEndian, ExplicitVRLittleEndian, ExplicitVRBigEndian, RLELossless][
        random.integers(4)]
    names = random.permutation(values.shape[2])
    for number in range(values.shape[2]):
        position = at + number * step[2] * directions[:, 2]
        packed = ExplicitVRLittleEndian if syntax == RLELossless else syntax
        file = file_of_slice(common, number, values[:, :, number].T, position, packed)
        if syntax == RLELossless:
            file.compress(RLELossless)
        file.save_as(folder / f"{names[number]:03}.dcm", write_like_original=False)
    return Case(str(folder), slope * values + intercept, place_of(directions, step, at), "lps",
                iso=float(slope * iso + intercept))
