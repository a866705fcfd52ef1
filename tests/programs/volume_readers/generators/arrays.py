"""Arrays: NumPy, HDF5 by h5py, Zarr by zarr, MRC by mrcfile."""
import h5py
import mrcfile
import numcodecs
import numpy
import zarr

from cases import Case, dims, generator, origin, place_of, samples, spacing

TYPES = ["u1", "i1", "u2", "i2", "u4", "i4", "u8", "i8", "f2", "f4", "f8"]


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
    version = [(1, 0), (2, 0), (3, 0)][random.integers(3)]
    with open(file, "wb") as out:
        numpy.lib.format.write_array(out, stored, version=version)
    return case_of(file, values, (1, 1, 1), iso)


@generator("NumPy's archive")
def numpy_archive(random, folder):
    values, stored, iso = array(random)
    file = folder / "volume.npz"
    save = [numpy.savez, numpy.savez_compressed][random.integers(2)]
    save(file, affine=numpy.eye(4), volume=stored)
    return case_of(f"{file}:/volume" if random.random() < 0.5 else file, values, (1, 1, 1), iso)


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


def compressor(random):
    names = ["blosclz", "lz4", "lz4hc", "zlib", "zstd"]
    return [None, numcodecs.Zlib(), numcodecs.GZip(), numcodecs.Zstd(),
            numcodecs.Blosc(cname=str(random.choice(names)), shuffle=int(random.integers(3)))][
                random.integers(5)]


@generator("OME-Zarr 0.4, by zarr")
def ome_zarr(random, folder):
    values, stored, iso = array(random)
    step, at = spacing(random), origin(random)
    unit, millimetres = [("millimeter", 1), ("micrometer", 1e-3), ("nanometer", 1e-6),
                         ("meter", 1e3)][random.integers(4)]
    leading = int(random.integers(3))  # axes of channels and times, of one each
    store = zarr.DirectoryStore(folder / "volume.zarr",
                                dimension_separator=str(random.choice([".", "/"])))
    group = zarr.group(store)
    chunks = (1,) * leading + tuple(int(random.integers(2, size + 2)) for size in stored.shape)
    group.array("0", stored[(None,) * leading], chunks=chunks, compressor=compressor(random),
                order=str(random.choice(["C", "F"])), fill_value=0)
    axes = [{"name": "t", "type": "time"}, {"name": "c", "type": "channel"}][2 - leading:]
    axes += [{"name": axis, "type": "space", "unit": unit} for axis in "zyx"]
    ones, zeros = [1.0] * leading, [0.0] * leading
    transforms = [{"type": "scale", "scale": ones + (step[::-1] / millimetres).tolist()},
                  {"type": "translation", "translation": zeros + (at[::-1] / millimetres).tolist()}]
    group.attrs["multiscales"] = [{"version": "0.4", "axes": axes, "datasets": [
        {"path": "0", "coordinateTransformations": transforms}]}]
    case = case_of(folder / "volume.zarr", values, step, iso)
    case.place[:3, 3], case.space = at, "scanner"
    return case


@generator("MRC, by mrcfile")
def mrc(random, folder):
    values, iso = samples(random, dims(random), str(random.choice(["i1", "i2", "u2", "f2", "f4"])))
    file, step, at = folder / "volume.mrc", spacing(random), origin(random)
    with mrcfile.new(file) as volume:
        volume.set_data(numpy.ascontiguousarray(values.T))
        volume.set_volume()
        volume.voxel_size = tuple(step)  # angstroms, which are read as millimetres
        volume.header.origin = tuple(at)
    case = case_of(file, values, step, iso)
    case.place[:3, 3], case.space = at, "scanner"
    return case
