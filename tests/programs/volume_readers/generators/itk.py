"""NRRD, MetaImage, NIfTI and VTK by ITK: volumes that it writes, and headers that it reads."""
import gzip
import json
import os
import subprocess
import zlib

import numpy

from cases import (Case, dims, generator, origin, place_of, random_place, rotation, samples,
                   spacing)

PROGRAM = os.environ.get("ITK_IMAGE", "itk_image")
TYPES = {"u1": "unsigned_char", "i1": "char", "u2": "unsigned_short", "i2": "short",
         "u4": "unsigned_int", "i4": "int", "f4": "float", "f8": "double"}


def written(random, folder, name, types=tuple(TYPES), compressed=None, directions=None):
    """Volumes written by ITK. directions: any, if not given."""
    dtype = str(random.choice(types))
    values, iso = samples(random, dims(random), dtype)
    raw = folder / "volume.samples"
    values.ravel(order="F").tofile(raw)
    if compressed is None:
        compressed = bool(random.integers(2))
    if directions is None:
        directions = rotation(random)
    at, step = origin(random), spacing(random)
    numbers = [*values.shape, *step, *at, *directions.T.ravel()]
    subprocess.run([PROGRAM, "write", raw, folder / name, TYPES[dtype], str(int(compressed)),
                    *map(repr, map(float, numbers))], check=True)
    raw.unlink()
    return Case(str(folder / name), values, place_of(directions, step, at), "lps", iso=iso)


def read(folder, file):
    """Volumes read by ITK."""
    raw = folder / "read.samples"
    done = subprocess.run([PROGRAM, "read", file, raw], check=True, stdout=subprocess.PIPE, text=True)
    told = json.loads(done.stdout)
    dtype = next(key for key, name in TYPES.items() if name == told["type"])
    shape = [int(size) for size in told["dims"]]
    values = numpy.fromfile(raw, dtype).reshape(shape, order="F")
    directions = numpy.reshape(told["directions"], (3, 3)).T
    return Case(str(file), values, place_of(directions, told["spacing"], told["origin"]), "lps")


@generator("NRRD, written by ITK")
def nrrd(random, folder):
    return written(random, folder, str(random.choice(["volume.nrrd", "volume.nhdr"])))


@generator("MetaImage, written by ITK")
def metaimage(random, folder):
    return written(random, folder, str(random.choice(["volume.mha", "volume.mhd"])))


@generator("NIfTI, written by ITK")
def nifti(random, folder):
    return written(random, folder, str(random.choice(["volume.nii", "volume.nii.gz"])))


@generator("VTK, written by ITK")
def vtk(random, folder):
    case = written(random, folder, "volume.vtk", compressed=False, directions=numpy.eye(3))
    case.space = "scanner"
    return case


# ---- headers of other writers, which ITK reads ----

NRRD_TYPES = {"u1": ["uchar", "uint8", "unsigned char"], "i1": ["signed char", "int8_t"],
              "u2": ["ushort", "uint16_t"], "i2": ["short", "signed short"],
              "u4": ["uint", "unsigned int"], "i4": ["int", "int32"], "f4": ["float"],
              "f8": ["double"]}
META_TYPES = {"u1": "MET_UCHAR", "i1": "MET_CHAR", "u2": "MET_USHORT", "i2": "MET_SHORT",
              "u4": "MET_UINT", "i4": "MET_INT", "f4": "MET_FLOAT", "f8": "MET_DOUBLE"}


def stored(random, values):
    """The samples as bytes, and their order."""
    order = str(random.choice(["<", ">"]))
    return values.ravel(order="F").astype(values.dtype.newbyteorder(order)).tobytes(), order


def text_of(values):
    return " ".join(repr(each) for each in values.ravel(order="F").tolist()).encode() + b"\n"


def vector(numbers):
    return "(" + ",".join(repr(float(each)) for each in numbers) + ")"


@generator("NRRD, read by ITK")
def nrrd_header(random, folder):
    dtype = str(random.choice(list(NRRD_TYPES)))
    values, iso = samples(random, dims(random), dtype)
    bytes_, order = stored(random, values)
    encoding = str(random.choice(["raw", "gzip", "ascii"]))
    fields = [f"type: {random.choice(NRRD_TYPES[dtype])}", "dimension: 3",
              "sizes: " + " ".join(map(str, values.shape)), f"encoding: {encoding}",
              f"endian: {'little' if order == '<' else 'big'}"]
    place = random_place(random)
    # Programs disagree about LAS, which is left-handed.
    space = str(random.choice(["left-posterior-superior", "LPS", "right-anterior-superior", "RAS"]))
    fields += [f"space: {space}", f"space origin: {vector(place[:3, 3])}",
               "space directions: " + " ".join(vector(place[:3, axis]) for axis in range(3)),
               "kinds: domain domain domain"]
    if random.random() < 0.5:
        fields.append('space units: "mm" "mm" "mm"')
    is_detached = bool(random.integers(2))
    if encoding == "ascii":
        bytes_ = text_of(values)
    elif is_detached and encoding == "raw" and random.random() < 0.5:
        skipped = int(random.integers(1, 100))
        bytes_ = b"x" * skipped + bytes_
        fields.append(f"byte skip: {random.choice([skipped, -1])}")
    if encoding == "gzip":
        bytes_ = gzip.compress(bytes_)
    if is_detached:
        (folder / "volume.samples").write_bytes(bytes_)
        fields.append("data file: volume.samples")
    # The fields may have any order, except those on which the lengths of others depend.
    tail = fields[3:]
    random.shuffle(tail)
    tail.sort(key=lambda field: not field.startswith("space:"))
    header = "\n".join(["NRRD0005", "# any comment", *fields[:3], *tail]).encode() + b"\n"
    file = folder / ("volume.nhdr" if is_detached else "volume.nrrd")
    file.write_bytes(header if is_detached else header + b"\n" + bytes_)
    case = read(folder, file)
    case.iso = iso
    return case


@generator("MetaImage, read by ITK")
def metaimage_header(random, folder):
    dtype = str(random.choice(list(META_TYPES)))
    values, iso = samples(random, dims(random), dtype)
    bytes_, order = stored(random, values)
    kind = str(random.choice(["binary", "compressed", "text"]))
    if kind == "text":  # ITK swaps the bytes of text as well, if it swaps
        bytes_, order = text_of(values), "<"
    directions = rotation(random)
    fields = ["NDims = 3", f"{random.choice(['Offset', 'Position', 'Origin'])} = "
              + " ".join(repr(float(each)) for each in origin(random)),
              f"{random.choice(['TransformMatrix', 'Rotation', 'Orientation'])} = "
              + " ".join(repr(float(each)) for each in directions.T.ravel()),
              f"ElementSpacing = {' '.join(repr(float(each)) for each in spacing(random))}",
              f"BinaryData = {kind != 'text'}",
              f"{random.choice(['BinaryDataByteOrderMSB', 'ElementByteOrderMSB'])} = {order == '>'}",
              f"ElementType = {META_TYPES[dtype]}", "CenterOfRotation = 0 0 0"]
    if kind == "compressed":
        bytes_ = zlib.compress(bytes_)
        fields += ["CompressedData = True", f"CompressedDataSize = {len(bytes_)}"]
    is_detached = bool(random.integers(2))
    fields[1:] = random.permutation(fields[1:]).tolist()
    fields = ["ObjectType = Image", *fields, "DimSize = " + " ".join(map(str, values.shape)),
              f"ElementDataFile = {'volume.samples' if is_detached else 'LOCAL'}"]
    header = "\n".join(fields).encode() + b"\n"
    file = folder / ("volume.mhd" if is_detached else "volume.mha")
    if is_detached:
        (folder / "volume.samples").write_bytes(bytes_)
    file.write_bytes(header if is_detached else header + bytes_)
    case = read(folder, file)
    case.iso = iso
    return case
