"""Section 6 of lib/WIRE.md: the range coder."""

from packets import Damaged

ALL = 0xFFFFFFFF


class Truncated(Exception):
    """The next byte is in the next packet."""


class RangeDecoder:
    """If the bytes are complete, reads zeros after their end."""

    def __init__(self, data, is_complete=True):
        self.data, self.at, self.is_complete = data, 0, is_complete
        self.range, self.code = ALL, 0
        for _ in range(4):
            self.code = self.code << 8 | self.next_byte()

    def next_byte(self):
        self.at += 1
        if self.at > len(self.data) and not self.is_complete:
            raise Truncated
        if self.at > len(self.data) + 4:
            raise Damaged("the payload is too short")
        return self.data[self.at - 1] if self.at <= len(self.data) else 0

    def refill(self):
        while self.range < 1 << 24:
            self.code = (self.code << 8 | self.next_byte()) & ALL
            self.range = self.range << 8 & ALL

    def symbol(self, below):
        """`below` has n + 1 numbers; the last is 256."""
        unit = self.range >> 8
        s = max(s for s in range(len(below) - 1)
                if below[s] < below[s + 1] and self.code >= unit * below[s])
        self.code -= unit * below[s]
        self.range = unit * (below[s + 1] - below[s])
        self.refill()
        return s

    def raw(self, n):
        if n > 8:  # section 7
            return self.raw(8) << (n - 8) | self.raw(n - 8)
        self.range >>= n
        v = min(self.code // self.range, (1 << n) - 1)
        self.code -= self.range * v
        self.refill()
        return v

    def decision(self, p, bits):
        """`p` is the probability of a 1, in units of 2^-bits: 8, or 16 for a context of section 14."""
        if not self.is_complete and len(self.data) - self.at < 4:  # section 14, losses
            raise Truncated
        bound = (self.range >> bits) * p
        bit = int(self.code < bound)
        if bit:
            self.range = bound
        else:
            self.code -= bound
            self.range -= bound
        self.refill()
        return bit

    def learnt(self, contexts, context):
        """Section 14: a decision whose probability adapts."""
        p = contexts[context]
        bit = self.decision(p, 16)
        contexts[context] = p + (65535 - p >> 4) if bit else p - (p >> 4)
        return bit

    def learnt_quickly(self, contexts, context):
        """Section 15: likewise for the contexts of fractions."""
        p = contexts[context]
        bit = self.decision(p, 16)
        q, n = divmod(p, 8)
        k = (n + 3) // 2
        q = q + (8191 - q >> k) if bit else q - (q >> k)
        contexts[context] = 8 * q + min(n + 1, 7)
        return bit

    def raw_bits(self, n):
        """Section 14: a number of several raw bits."""
        value = 0
        for _ in range(n):
            value = 2 * value + self.decision(128, 8)
        return value


class RecordingDecoder(RangeDecoder):
    """Records its calls for a RangeEncoder."""

    def __init__(self, data):
        self.calls = []
        super().__init__(data)

    def symbol(self, below):
        s = super().symbol(below)
        self.calls.append((RangeEncoder.symbol, below, s))
        return s

    def raw(self, n):
        v = super().raw(n)
        if n <= 8:
            self.calls.append((RangeEncoder.raw, n, v))
        return v


class RangeEncoder:
    """The encoder of section 6; its calls are those of the decoder, with the value last."""

    def __init__(self):
        self.range, self.low, self.bytes = ALL, 0, bytearray()

    def symbol(self, below, s):
        unit = self.range >> 8
        self.low += unit * below[s]
        self.range = unit * (below[s + 1] - below[s])
        self.make_room()

    def raw(self, n, v):
        self.range >>= n
        self.low += self.range * v
        self.make_room()

    def make_room(self):
        while self.range < 1 << 24:
            self.byte_out()
            self.range <<= 8

    def byte_out(self):
        self.carry()
        self.bytes.append(self.low >> 24)
        self.low = self.low << 8 & ALL

    def carry(self):
        if self.low > ALL:
            self.low &= ALL
            at = len(self.bytes) - 1
            while self.bytes[at] == 255:
                self.bytes[at] = 0
                at -= 1
            self.bytes[at] += 1

    @staticmethod
    def encoded(calls):
        encoder = RangeEncoder()
        for call, *arguments in calls:
            call(encoder, *arguments)
        return encoder.end()

    def end(self):
        multiple = 0
        for k in (0, 1):
            unit = 1 << 32 - 8 * k
            multiple = -(-self.low // unit) * unit
            if multiple < self.low + self.range:
                break
        self.low = multiple
        self.carry()
        if k:
            self.bytes.append(self.low >> 24)
        return bytes(self.bytes)
