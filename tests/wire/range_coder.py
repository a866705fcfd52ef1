"""Section 6 of lib/WIRE.md: the range coder."""

from packets import Damaged

ALL = 0xFFFFFFFF


class Truncated(Exception):
    """The next packet has the next byte."""


class RangeDecoder:
    """After the end of bytes that are complete it reads zeros."""

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
        """`below` has n + 1 numbers, the last is 256."""
        unit = self.range >> 8
        s = max(s for s in range(len(below) - 1)
                if below[s] < below[s + 1] and self.code >= unit * below[s])
        self.code -= unit * below[s]
        self.range = unit * (below[s + 1] - below[s])
        self.refill()
        return s

    def even(self, n):
        if n > 8:  # section 7
            return self.even(8) << (n - 8) | self.even(n - 8)
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
