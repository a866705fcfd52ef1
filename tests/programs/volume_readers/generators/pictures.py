"""TIFF by tifffile: plain, for ImageJ, and as OME."""
import numpy
import tifffile

from cases import Case, dims, generator, place_of, samples, spacing

COMPRESSIONS = [None, "zlib"]  # the others take imagecodecs


def written(random, file, types, step, **options):
    """step: the spacing to write."""
    values, iso = samples(random, dims(random), str(random.choice(types)))
    tifffile.imwrite(file, numpy.ascontiguousarray(values.T), photometric="minisblack", **options)
    return Case(str(file), values, place_of(numpy.eye(3), step, (0, 0, 0)), "voxel", iso=iso)


def layout(random):
    """The storage of samples in the file."""
    options = {"byteorder": str(random.choice(["<", ">"])), "bigtiff": bool(random.integers(2)),
               "compression": COMPRESSIONS[random.integers(2)]}
    if options["compression"] and random.random() < 0.5:
        options["predictor"] = True
    if random.random() < 0.3:
        options["tile"] = (16, 32)
    elif random.random() < 0.5:
        options["rowsperstrip"] = int(random.integers(1, 6))
    return options


@generator("TIFF, by tifffile")
def plain(random, folder):
    types = ["u1", "i1", "u2", "i2", "u4", "i4", "f4", "f8"]
    options = layout(random)
    if options.get("predictor"):
        types = ["u1", "u2"]
    return written(random, folder / "volume.tif", types, (1, 1, 1), metadata=None, **options)


@generator("TIFF of ImageJ, by tifffile")
def imagej(random, folder):
    step = spacing(random)
    step[1] = step[0] if random.random() < 0.5 else step[1]
    unit, millimetres = [("mm", 1), ("um", 1e-3), ("micron", 1e-3), ("\\u00B5m", 1e-3), ("cm", 10),
                         ("inch", 25.4), ("nm", 1e-6)][random.integers(7)]
    step = step / millimetres
    # TIFF stores fractions.
    fractions = [(int(round(1e6 / each)), 10 ** 6) if each < 100 else (10 ** 6, int(round(1e6 * each)))
                 for each in step[:2]]
    told = [fraction[1] / fraction[0] for fraction in fractions] + [step[2]]
    return written(random, folder / "volume.tif", ["u1", "u2", "f4"],
                   numpy.array(told) * millimetres, imagej=True, resolution=fractions,
                   metadata={"spacing": step[2], "unit": unit, "axes": "ZYX"})


@generator("OME-TIFF, by tifffile")
def ome(random, folder):
    step = spacing(random)
    unit, millimetres = [("mm", 1), ("\u00b5m", 1e-3), ("nm", 1e-6), ("cm", 10)][random.integers(4)]
    told = {f"PhysicalSize{axis}": float(size) / millimetres for axis, size in zip("XYZ", step)}
    told.update({f"PhysicalSize{axis}Unit": unit for axis in "XYZ"})
    return written(random, folder / "volume.ome.tif", ["u1", "i1", "u2", "i2", "f4", "f8"], step,
                   ome=True, metadata={"axes": "ZYX", **told}, **{
                       key: value for key, value in layout(random).items() if key != "predictor"})
