"""Arrays without a place: NumPy and HDF5 (h5py)."""
import h5py
import numpy

from cases import Case, dims, generator, place_of, samples, spacing

TYPES = ["u1", "i1", "u2", "i2", "u4", "i4", "u8", "i8", "f4", "f8"]


def array(random):
    """By z, y and x, in any byte order."""
    dtype = str(random.choice(TYPES))
    values, iso = samples(random, dims(random), dtype)
    stored = numpy.ascontiguousarray(values.T)
    return values, stored.astype(stored.dtype.newbyteorder(str(random.choice(["<", ">"])))), iso


def case_of(file, values, step, iso):
    return Case(str(file), values, place_of(numpy.eye(3), step, (0, 0, 0)), "voxel", iso=iso)


@generator("NumPy")
def numpy_array(random, folder):
    values, stored, iso = array(random)
    file = folder / "volume.npy"
    # In Fortran order an array is by x, y and z.
    if random.random() < 0.5:
        stored = numpy.asfortranarray(stored.T)
    numpy.lib.format.write_array(open(file, "wb"), stored, version=[(1, 0), (2, 0), (3, 0)][
        random.integers(3)])
    return case_of(file, values, (1, 1, 1), iso)


@generator("HDF5, by h5py")
def hdf5_array(random, folder):
    values, stored, iso = array(random)
    file, name = folder / "volume.h5", "/" + "/".join(["entry", "data", "volume"][:random.integers(1, 4)])
    step = numpy.ones(3)
    options = [{}, {"chunks": True}, {"chunks": True, "compression": "gzip"},
               {"chunks": tuple(int(random.integers(1, size + 1)) for size in stored.shape),
                "compression": "gzip", "shuffle": True, "fletcher32": True}][random.integers(4)]
    with h5py.File(file, "w", libver=str(random.choice(["earliest", "latest"]))) as volume:
        if "chunks" not in options or random.random() < 0.7:
            dataset = volume.create_dataset(name, data=stored, **options)
        else:  # larger than it is now
            dataset = volume.create_dataset(name, data=stored, maxshape=(None,) * 3, **options)
        if random.random() < 0.5:
            step = spacing(random)
            dataset.attrs["element_size_um"] = 1000 * step[::-1]
        volume["note"] = "not a volume"
    return case_of(f"{file}:{name}" if random.random() < 0.5 else file, values, step, iso)
