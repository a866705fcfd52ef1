"""Sections 2 to 5 of lib/WIRE.md: from the bytes of a stream to its pieces or rows, and its losses."""

import struct
from dataclasses import dataclass, field

import packets as wire
from packets import Damaged, Header, Trailer, digest_after, is_of_slices, packets
from records import Chain, Fragment, Part, Records, Region
from slices import SliceRows


@dataclass
class Application:
    """Section 2."""
    kind: int
    slice: int
    row: int
    data: bytes


@dataclass
class Loss:
    """The losses before the packet whose frame is at this offset."""
    offset: int
    packets: int = 0
    pieces: int = 0
    rows: int = 0


@dataclass
class Stream:
    channel: int = None
    header: Header = None
    trailer: Trailer = None
    events: list = field(default_factory=list)  # regions, fragments, layers, skipped rows, application records
    rows: SliceRows = None
    damaged: list = field(default_factory=list)  # offsets of frames
    losses: list = field(default_factory=list)
    repeated: int = 0
    foreign: int = 0
    is_mixed: bool = False

    def lost(self, what):
        return sum(getattr(loss, what) for loss in self.losses)


def decoded(data, channel=None):
    """The stream of the first packet, or of the first packet of a channel."""
    stream, name, reader = Stream(), None, None
    for offset, packet in packets(data):
        if packet is None:
            stream.damaged.append(offset)
            continue
        if name is None and channel in (None, *packet.channels):
            name, stream.channel = packet.name, packet.channel
            reader = (SliceReader if has_slices(packet) else RecordReader)(stream)
        if packet.name != name:
            stream.foreign += 1
        elif stream.trailer:
            stream.repeated += 1
        else:
            reader.read(offset, packet)
    if reader and not stream.trailer:
        reader.interrupt()
    return stream


def has_slices(packet):
    if packet.kind == wire.HEADER:
        return Header.parsed(packet).has_slices
    return is_of_slices(packet.kind)


class Reader:
    """The common parts of both kinds of streams."""

    def __init__(self, stream):
        self.stream = stream
        self.next_number = 0
        self.is_first = True
        self.digest = 0

    def read(self, offset, packet):
        if packet.kind == wire.HEADER and self.stream.header is None:
            self.stream.header = Header.parsed(packet)  # even if it is late
        loss = self.loss_before(offset, packet)
        if loss is None:
            self.stream.repeated += 1
            return
        self.is_first = False
        try:
            if loss.packets or loss.pieces:
                self.stream.losses.append(loss)
                self.interrupt()
            self.take(offset, packet)
        except Damaged:
            self.stream.damaged.append(offset)
            self.interrupt()
        self.digest = digest_after(self.digest, packet.crc)

    def take_application(self, packet):
        self.stream.events.append(Application(*struct.unpack("<BII", packet.payload[:9]), packet.payload[9:]))

    def take_trailer(self, trailer):
        self.stream.trailer = trailer
        self.stream.is_mixed = not self.stream.lost("packets") and trailer.digest != self.digest


class RecordReader(Reader):
    """Section 5."""

    def __init__(self, stream):
        super().__init__(stream)
        self.passed = 0
        self.in_progress = None

    def loss_before(self, offset, packet):
        """Returns None if the packet is repeated or late."""
        if packet.kind == wire.HEADER:
            header = Header.parsed(packet)
            gap, missing = header.packets - self.next_number, header.pieces - self.passed
            is_late = gap < 0 or missing < 0
        elif packet.kind == wire.TRAILER:
            totals = Trailer.parsed(packet).totals
            gap = (packet.number - self.next_number) % 256
            missing = totals["regions"] + totals["fragments"] - self.passed
            is_late = False
        else:
            gap = (packet.number - self.next_number) % 256
            missing = (packet.pieces - self.passed) % 65536
            is_late = missing >= 32768 or gap >= 128 and missing == 0
        if is_late and not self.is_first:
            return None
        self.next_number += gap + 1
        self.passed += missing
        return Loss(offset, gap, missing)

    def interrupt(self):
        self.in_progress = None

    def take(self, offset, packet):
        if packet.kind == wire.APPLICATION:
            self.take_application(packet)
        elif packet.kind == wire.TRAILER:
            self.take_trailer(Trailer.parsed(packet))
        elif packet.kind in (wire.RECORDS, wire.REGIONS):
            payload = packet.payload[:-2] if packet.kind == wire.REGIONS else packet.payload
            for record in Records(payload):
                if isinstance(record, Part):
                    record = self.joined(offset, record)
                if record:
                    self.stream.events.append(record)
                    self.passed += isinstance(record, (Region, Fragment))

    def joined(self, offset, part):
        """Section 9: returns the region or fragment if this is its last part, else None."""
        if not part.continues:
            if part.is_of_fragment:
                self.in_progress = Fragment(part.incidence, Chain(part.chain.start), part.came)
            else:
                self.in_progress = Region(part.incidence, [])
        piece = self.in_progress
        if part.is_last:
            self.in_progress = None
        if piece is None:
            if part.is_last:
                self.passed += 1
                self.stream.losses.append(Loss(offset, pieces=1))
            return None
        if part.is_of_fragment:
            piece.chain.runs += part.chain.runs
        else:
            if part.begins_ring:
                piece.rings.append(Chain(part.chain.start))
            piece.rings[-1].runs += part.chain.runs
        return piece if part.is_last else None


class SliceReader(Reader):
    """Section 14."""

    def __init__(self, stream):
        super().__init__(stream)
        self.waits_for_key_slice = True
        self.code = None  # its bytes so far

    def loss_before(self, offset, packet):
        """Returns None if the packet is repeated or late."""
        is_header = packet.kind == wire.HEADER
        number = Header.parsed(packet).packets % 2 ** 24 if is_header else packet.number
        if not self.is_first and 1 <= (self.next_number - number) % 2 ** 24 <= 2 ** 23:
            return None
        gap = (number - self.next_number) % 2 ** 24
        self.next_number = (number + 1) % 2 ** 24
        return Loss(offset, packets=gap)

    def interrupt(self):
        """Decodes the received bytes of an incomplete code."""
        code, self.code = self.code, None
        self.waits_for_key_slice = True
        if code is not None:
            self.stream.rows.decode(code, None, False)

    def take(self, offset, packet):
        if self.stream.header and self.stream.rows is None:
            self.stream.rows = SliceRows(self.stream.header)
        if packet.kind == wire.SLICE_APPLICATION:
            self.take_application(packet)
        elif packet.kind == wire.SLICE_TRAILER:
            self.interrupt()
            trailer = Trailer.parsed(packet)
            if self.stream.rows:
                self.lose(offset, trailer.totals["rows"] - len(self.stream.rows.kinds))
            self.take_trailer(trailer)
        elif 16 <= packet.kind <= 31 and self.stream.rows:
            self.take_code(offset, packet)

    def take_code(self, offset, packet):
        is_key, begins, ends, is_cut = (bool(packet.kind & bit) for bit in (1, 2, 4, 8))
        rows, payload, cut = self.stream.rows, packet.payload, None
        if is_key:
            self.lose(offset, int.from_bytes(payload[:4], "little") * rows.height - len(rows.kinds))
            rows.begin_key_slice()
            self.waits_for_key_slice = False
            payload = payload[4:]
        if self.waits_for_key_slice:
            return
        if is_cut:
            cut = struct.unpack("<IH", payload[-6:])
            payload = payload[:-6]
        self.code = payload if begins else self.code + payload
        if ends:
            code, self.code = self.code, None
            rows.decode(code, cut, True)

    def lose(self, offset, rows):
        if rows < 0:
            raise Damaged("the number of rows")
        if rows > 0:
            self.stream.rows.lose(rows)
            self.stream.losses.append(Loss(offset, rows=rows))
