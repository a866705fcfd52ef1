"""Volumes and streams for compare.py: small ones that reach every kind of packet and record."""

import random
import re
import struct
import zlib

from packets import HEADER, RECORDS, SLICE_TRAILER, TRAILER, digest_after, unstuffed
from range_coder import RangeEncoder, RecordingDecoder
from records import EXTENSION, Records
from tables import context


def noise(width, height, depth):
    rng = random.Random(width)
    return [rng.randrange(256) for _ in range(width * height * depth)]


def of_points(width, height, depth, sample):
    return [sample(x, y, z) for z in range(depth) for y in range(height) for x in range(width)]


def ball():
    return of_points(24, 20, 16, lambda x, y, z: max(0, 200 - 2 * ((x - 11) ** 2 + (y - 9) ** 2 + (z - 7) ** 2)))


def slab():
    """A plate with holes: one region of long runs, with holes."""
    return of_points(140, 30, 3, lambda x, y, z: 200 * (z == 1 and 1 < x < 138 and (x % 40 > 5 or y % 14 > 4)))


def comb():
    """Regions longer than a record, so they are sent in parts."""
    return of_points(90, 12, 3, lambda x, y, z: 200 * (z == 1 and (y < 3 or x % 3 > 0 and y < 9)))


# name -> width, height, function of the samples
VOLUMES = {
    "noise": (11, 9, lambda: noise(11, 9, 8)),
    "wide": (300, 5, lambda: noise(300, 5, 2)),
    "ball": (24, 20, ball),
    "slab": (140, 30, slab),
    "comb": (90, 12, comb),
}

POLYGONS = [
    ("noise", ("--iso", 128)),
    ("noise", ("--iso", 40, "--memory", "3K")),  # loose fragments, also of holes
    ("noise", ("--iso", 200, "--border", "open", "--scan", 4711)),
    ("noise", ("--iso", 60, "--memory", "4K", "--normals", "gradient")),
    ("ball", ("--iso", 1, "--slab", "2/2")),
    ("slab", ("--iso", 100)),
    ("comb", ("--iso", 100)),
    ("comb", ("--iso", 100, "--memory", "6100", "--normals", "gradient")),
]

SLICES = [
    ("noise", ("--wire", "slices", "--iso", 128, "--key-slices", 3), (128,)),
    ("wide", ("--wire", "slices", "--iso", 128, "--border", "open"), (128,)),
    ("ball", ("--wire", "slices", "--iso", 100, "--iso", 20, "--iso", 180, "--key-slices", 5), (100, 20, 180)),
    ("slab", ("--wire", "slices", "--iso", 100), (100,)),
]

# Rows that end at any bit of a word, dense and sparse, in slices of few rows.
for i, width in enumerate((1, 2, 3, 7, 8, 29, 30, 31, 32, 33, 59, 60, 61, 64, 97)):
    height, iso = (1, 2, 3, 4, 9)[i % 5], (20, 128, 215, 250)[i % 4]
    VOLUMES[f"width {width}"] = width, height, lambda width=width, height=height: noise(width, height, 3)
    SLICES.append((f"width {width}", ("--wire", "slices", "--iso", iso, "--key-slices", 1 + i % 3), (iso,)))

# volume, is open, levels, slices from one key slice to the next, thresholds
FRACTIONS = [
    ("noise", 0, 2, 0, (128,)),
    ("noise", 1, 4, 3, (128,)),
    ("wide", 0, 2, 1, (128, 90)),
    ("ball", 1, 4, 5, (100, 20, 150)),
]

DAMAGED = [
    ("noise", ("--iso", 128), 4),
    ("noise", ("--iso", 40, "--memory", "3K"), 4),
    ("comb", ("--iso", 100, "--normals", "gradient"), 4),
    ("noise", ("--wire", "slices", "--iso", 128, "--key-slices", 2), 4),
    ("wide", ("--wire", "slices", "--iso", 128, "--iso", 100, "--key-slices", 1), 4),
]


def frames(data):
    return [frame + b"\0" for frame in data.split(b"\0")[:-1]]


def bodies(data):
    """The packets without their CRC."""
    return [bytearray(unstuffed(frame)[:-4]) for frame in frames(data)]


def framed(body):
    """Section 1."""
    rest = bytes(body) + struct.pack("<I", zlib.crc32(body))
    return b"".join(bytes([len(block) + 1]) + block for block in rest.split(b"\0")) + b"\0"


def damaged(data, rng):
    """Drops, changes, repeats, delays and truncates frames. No frame follows the trailer."""
    out, delayed, rate = [], None, rng.choice((0.05, 0.2, 0.5))
    whole = frames(data)
    for frame in whole:
        kind = rng.choice("drop change repeat delay truncate zeros".split()) if rng.random() < rate else None
        if kind == "change":
            frame = bytearray(frame)
            frame[rng.randrange(len(frame))] ^= 1 << rng.randrange(8)
        elif kind == "truncate":
            frame = frame[:rng.randrange(len(frame))]
        elif kind == "zeros":
            frame = b"\0\0" + frame
        is_last = frame is whole[-1]
        if kind == "delay" and delayed is None and not is_last:
            delayed = frame
        elif kind != "drop":
            out += [frame, frame] if kind == "repeat" and not is_last else [frame]
        if delayed and not is_last and rng.random() < 0.4:
            out.append(delayed)
            delayed = None
    return b"".join(out)


def with_digest(data):
    """The stream with the digest of its packets in the trailer."""
    digest, out = 0, []
    for body in bodies(data):
        if body[0] in (TRAILER, SLICE_TRAILER):
            at = 4 + (69 if body[0] == TRAILER else 21)
            body[at:at + 4] = struct.pack("<I", digest)
        digest = digest_after(digest, zlib.crc32(body))
        out.append(framed(body))
    return b"".join(out)


def calls_of(payload):
    records = Records(payload, RecordingDecoder)
    for _ in records:
        pass
    return records.coder.calls


def with_extension(payload):
    """Section 9: an extension of an unknown type before the first record."""
    extension = [(RangeEncoder.raw, 8, value) for value in (200, 3, 1, 77, 254)]
    return RangeEncoder.encoded([(RangeEncoder.symbol, context(0, 9), EXTENSION), *extension, *calls_of(payload)])


def of_later_version(data):
    """Longer headers and trailers, an unknown extension, and a packet of an unknown kind before the last but one."""
    out = []
    packets = bodies(data)
    for i, body in enumerate(packets):
        if i == len(packets) - 2:
            out.append(bytearray([9, i]) + body[2:4] + b"new" + body[-3:])
        if i >= len(packets) - 2:
            body[1] += 1
        if i == len(packets) - 2 and body[0] == RECORDS:
            body[4:-3] = with_extension(bytes(body[4:-3]))
        if body[0] in (HEADER, TRAILER, SLICE_TRAILER):
            body[-3:-3] = b"longer"
        out.append(body)
    return with_digest(b"".join(map(framed, out)))


def with_wrong_payload(data):
    """A packet whose payload is invalid from its first record on, with a valid CRC."""
    packets = bodies(data)
    packets[3][4:-3] = b"\xFF" * (len(packets[3]) - 7)
    return with_digest(b"".join(map(framed, packets)))


def of_document(document, kind):
    """The bytes of a dump in lib/WIRE.md; the slices there have the header of section 13 with other numbers."""
    def dump(name):
        block = re.search(f"```{name}\n(.*?)```", document.read_text(), re.DOTALL).group(1)
        return bytes.fromhex(" ".join(line.split(";")[0] for line in block.splitlines()))

    if kind == "hex":
        return dump("hex")
    header = bodies(dump("hex"))[0]
    header[4 + 4:4 + 12] = struct.pack("<HHI", 4, 3, 2)
    header[4 + 28] = 2
    return framed(header) + dump("slices")


def fraction_of(samples, lower, upper, threshold, levels, is_along_z):
    """Section 15, encoders: the fraction of an edge between two voxels, 0 for none."""
    ends = samples[lower], samples[upper]
    if (ends[0] >= threshold) == (ends[1] >= threshold):
        return 0
    halves = [abs(2 * end - 2 * threshold + 1) for end in ends]  # twice the distances to threshold - 1/2
    if is_along_z:
        w = min(15, (halves[0] // 2).bit_length())
        halves[0] = 3 * 2 ** w // 2 if w else 1
    off, on = halves if ends[0] < threshold else halves[::-1]
    from_off = (2 * (levels * off // (off + on)) + 1) * 4 // levels
    return from_off if ends[0] < threshold else 8 - from_off
