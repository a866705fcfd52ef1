"""NIfTI and MGH by nibabel: written, and read back for the expected results; packed by Python."""
import bz2
import lzma
import pathlib

import nibabel
import numpy

from cases import FROM_RAS, Case, dims, generator, random_place, samples

TYPES = ["u1", "i1", "u2", "i2", "u4", "i4", "u8", "i8", "f4", "f8"]
MILLIMETRES = {"mm": 1, "micron": 1e-3, "meter": 1e3}


def oblique(random, place):
    """An affine matrix that is no rotation, as after registration."""
    place = place.copy()
    place[:3, :3] = (numpy.eye(3) + random.uniform(-0.2, 0.2, (3, 3))) @ place[:3, :3]
    return place


def read(file):
    """The expected result, as nibabel reads the file."""
    image = nibabel.load(file)
    unit = MILLIMETRES[image.header.get_xyzt_units()[0]]
    place = numpy.diag([unit, unit, unit, 1]) @ image.affine
    return Case(str(file), numpy.asarray(image.dataobj, dtype=numpy.float64), FROM_RAS @ place, "lps")


def packed(random, file):
    """The name of the same file, packed."""
    suffix, pack = [(".bz2", bz2.compress), (".xz", lzma.compress)][random.integers(2)]
    result = pathlib.Path(str(file) + suffix)
    result.write_bytes(pack(file.read_bytes()))
    file.unlink()
    return str(result)


@generator("NIfTI, by nibabel")
def nifti(random, folder):
    dtype = numpy.dtype(str(random.choice(TYPES))).newbyteorder(str(random.choice(["<", ">"])))
    stored, iso = samples(random, dims(random), dtype.newbyteorder("="))
    kind, names = [(nibabel.Nifti1Image, [".nii", ".nii.gz"]),
                   (nibabel.Nifti2Image, [".nii", ".nii.gz"]),
                   (nibabel.Nifti1Pair, [".hdr", ".img", ".img.gz"])][random.integers(3)]
    file = folder / ("volume" + str(random.choice(names)))
    place = random_place(random)
    image = kind(stored, None, dtype=dtype)
    header = image.header
    header.set_data_dtype(dtype)
    header = header.as_byteswapped(dtype.str[0])
    image = kind(stored, place, header, dtype=dtype)
    sform, qform = [(1, 0), (0, 1), (2, 1), (4, 2), (3, 3)][random.integers(5)]
    image.set_qform(place, qform)
    image.set_sform(oblique(random, place) if random.random() < 0.3 else place, sform)
    image.header.set_xyzt_units(str(random.choice(list(MILLIMETRES))))
    slope, intercept = 1.0, 0.0
    if random.random() < 0.4:
        # Few bits, because discmc reads the decimal number behind a float, and nibabel the float.
        slope, intercept = float(random.integers(1, 200)) / 64, float(random.integers(-1024, 9))
        image.header.set_slope_inter(slope, intercept)
    nibabel.save(image, file)
    case = read(file)
    case.iso = float(slope * iso + intercept)
    if file.suffix == ".nii" and random.random() < 0.3:
        case.file = packed(random, file)
    return case


@generator("MGH, by nibabel")
def mgh(random, folder):
    stored, iso = samples(random, dims(random), str(random.choice(["u1", "i2", "i4", "f4"])))
    file = folder / str(random.choice(["volume.mgh", "volume.mgz"]))
    nibabel.save(nibabel.MGHImage(stored, random_place(random)), file)
    image = nibabel.load(file)
    return Case(str(file), numpy.asarray(image.dataobj), FROM_RAS @ image.affine, "lps", iso=iso)
