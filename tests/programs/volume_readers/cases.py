"""A volume in a file of another program, and random parts of such volumes."""
import dataclasses

import numpy


@dataclasses.dataclass
class Case:
    file: str  # file or folder, as passed to discmc
    values: numpy.ndarray  # by x, y and z; with the slope and intercept of the file
    place: numpy.ndarray  # 4 x 4: from the number of a voxel to millimetres
    # The meaning of the millimetres: "lps"; "scanner", with unknown directions; "voxel", relative to the first voxel.
    space: str = "voxel"
    options: tuple = ()  # of discmc
    iso: float = None  # separates the body from its surroundings


GENERATORS = {}  # by name: the format, and the program that writes or reads it


def generator(name):
    """Marks a function that writes a volume into a folder, by numbers of a random source, and returns
    its Case: generate(random, folder)."""
    def add(function):
        GENERATORS[name] = function
        return function
    return add


def dims(random, most=20):
    """Three different ones, so that a confused axis is detected."""
    return tuple(int(size) for size in random.permutation(numpy.arange(4, most))[:3])


def body(random, shape):
    """Which voxels are on: two boxes that make an L, which no flip and no exchange of axes leaves
    alike."""
    on = numpy.zeros(shape, bool)
    begin = [int(random.integers(0, size - 3)) for size in shape]
    end = [int(random.integers(first + 3, size + 1)) for first, size in zip(begin, shape)]
    on[begin[0]:end[0], begin[1]:begin[1] + 1, begin[2]:begin[2] + 2] = True
    on[begin[0]:begin[0] + 1, begin[1]:end[1], begin[2]:end[2]] = True
    return on


def samples(random, shape, dtype, limits=None):
    """Noise of the type, by x, y and z, and a number that is above all around the body and below all
    in it. limits: of whole numbers, if not those of the type."""
    dtype = numpy.dtype(dtype)
    on = body(random, shape)
    if dtype.kind == "f":
        low, high = sorted(random.normal(0, 10.0 ** random.integers(-3, 4), 2))
        min_inside, max_outside = 0.4 * low + 0.6 * high, 0.6 * low + 0.4 * high
        noise = numpy.where(on, random.uniform(min_inside, high, shape),
                            random.uniform(low, max_outside, shape)).astype(dtype)
    else:
        # double counts integers up to 2^53.
        least, most = limits or (max(numpy.iinfo(dtype).min, -2 ** 40),
                                 min(numpy.iinfo(dtype).max, 2 ** 40))
        middle = int(random.integers(least + 2, most - 2))
        noise = numpy.where(on, random.integers(middle, most, shape, endpoint=True),
                            random.integers(least, middle, shape)).astype(dtype)
    return noise, (float(noise[~on].max()) + float(noise[on].min())) / 2


def rotation(random):
    """A rotation, often one that only permutes and reverses axes. Its determinant may be -1."""
    if random.random() < 0.5:
        signs = random.choice([-1.0, 1.0], 3)
        return numpy.eye(3)[random.permutation(3)] * signs
    matrix, _ = numpy.linalg.qr(random.normal(size=(3, 3)))
    return matrix * random.choice([-1.0, 1.0])


def spacing(random):
    """Decimal digits, as written by programs."""
    return numpy.round(random.uniform(0.2, 4, 3), 3)


def origin(random):
    return numpy.round(random.uniform(-300, 300, 3), 2)


def place_of(directions, spacing_mm, origin_mm):
    """directions: the axes as columns."""
    place = numpy.eye(4)
    place[:3, :3] = numpy.asarray(directions) * numpy.asarray(spacing_mm)
    place[:3, 3] = origin_mm
    return place


def random_place(random):
    return place_of(rotation(random), spacing(random), origin(random))


FROM_RAS = numpy.diag([-1.0, -1.0, 1.0, 1.0])  # to LPS and back
