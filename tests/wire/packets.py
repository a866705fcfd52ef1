"""Frames, packets, headers and trailers of a stream. Section numbers are those of lib/WIRE.md."""

import struct
import zlib
from dataclasses import dataclass

HEADER, RECORDS, TRAILER, SLICE_TRAILER, APPLICATION, SLICE_APPLICATION, REGIONS = 1, 2, 3, 4, 5, 6, 7


class WrongVersion(Exception):
    pass


class Damaged(Exception):
    """A frame or a payload that no encoder wrote."""


def unstuffed(frame):
    """Section 1: the packet of a frame, whose final zero byte is the last one."""
    frame, at = bytearray(frame), 0
    while at < len(frame) - 1:
        distance = frame[at]
        frame[at] = 0
        at += distance
        if distance == 0 or at >= len(frame):
            raise Damaged("distance")
    return bytes(frame[1:-1])


def checked(packet):
    """Section 2: the packet without its CRC, and the CRC."""
    if not 11 <= len(packet) <= 254:
        raise Damaged("length")
    crc = struct.unpack("<I", packet[-4:])[0]
    if zlib.crc32(packet[:-4]) != crc:
        raise Damaged("CRC")
    return packet[:-4], crc


def is_of_slices(kind):
    return kind in (SLICE_TRAILER, SLICE_APPLICATION) or 16 <= kind <= 31


@dataclass
class Packet:
    kind: int
    number: int
    pieces: int  # 0 in a packet of slices
    payload: bytes
    scan: int
    channel: int
    further_surfaces: int
    crc: int

    @property
    def channels(self):
        return range(self.channel, self.channel + self.further_surfaces + 1)

    @property
    def name(self):
        return self.scan, self.channel, self.further_surfaces


def parsed(body, crc):
    """Section 2, or the longer number of section 14."""
    kind = body[0]
    if is_of_slices(kind):
        number, pieces = int.from_bytes(body[1:4], "little"), 0
    else:
        number, pieces = struct.unpack("<BH", body[1:4])
    scan, channel = struct.unpack("<HB", body[-3:])
    return Packet(kind, number, pieces, body[4:-3], scan, channel & 63, channel >> 6, crc)


def packets(stream):
    """The packets of a stream, each with the offset of its frame; None for a damaged one."""
    at = 0
    while at < len(stream):
        end = stream.find(b"\0", at) + 1 or len(stream)
        if end > at + 1 or stream[at] != 0:  # no empty frame
            try:
                if stream[end - 1] != 0:
                    raise Damaged("end of the stream")
                packet = parsed(*checked(unstuffed(stream[at:end])))
                if packet.kind in (HEADER, TRAILER, SLICE_TRAILER):
                    (Header if packet.kind == HEADER else Trailer).parsed(packet)
                yield at, packet
            except Damaged:
                yield at, None
        at = end


@dataclass
class Header:
    """Section 3."""
    width: int
    height: int
    depth: int
    spacing_nm: tuple
    thresholds: list
    is_open: bool
    has_slices: bool
    levels: int  # of fractions, 0 for none
    packets: int
    pieces: int

    @classmethod
    def parsed(cls, packet):
        p = packet.payload
        further = packet.further_surfaces
        if p[:3] != b"DMC" or len(p) < 41 + 4 * further:
            raise Damaged("header")
        if p[3] != 1:
            raise WrongVersion(p[3])
        width, height, depth, x, y, z = struct.unpack("<HHIiii", p[4:24])
        flags, before, pieces = struct.unpack("<BIQ", p[28:41])
        if flags & 2 and flags >> 2 & 3 == 3:
            raise Damaged("levels")
        levels = (0, 2, 4)[flags >> 2 & 3] if flags & 2 else 0
        thresholds = list(struct.unpack("<i", p[24:28])) + list(
            struct.unpack(f"<{further}i", p[41:41 + 4 * further]))
        return cls(width, height, depth, (x, y, z), thresholds, bool(flags & 1), bool(flags & 2),
                   levels, before, pieces)


TOTALS = ("active_cells", "facets", "classic_triangles", "regions", "rings", "links", "fragments",
          "skipped_rows")


@dataclass
class Trailer:
    """Section 4, or the trailer of section 14."""
    slices: int
    is_abandoned: bool
    totals: dict
    digest: int

    @classmethod
    def parsed(cls, packet):
        if len(packet.payload) < (73 if packet.kind == TRAILER else 25):
            raise Damaged("trailer")
        if packet.kind == TRAILER:
            slices, reason, *totals, digest = struct.unpack("<IB8QI", packet.payload[:73])
            return cls(slices, reason != 0, dict(zip(TOTALS, totals)), digest)
        slices, reason, rows, skipped, digest = struct.unpack("<IBQQI", packet.payload[:25])
        return cls(slices, reason != 0, {"rows": rows, "skipped_rows": skipped}, digest)


def digest_after(digest, crc):
    """Section 4."""
    return ((digest << 1 | digest >> 31) & 0xFFFFFFFF) ^ crc
