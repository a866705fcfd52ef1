"""Sections 7 to 9 of lib/WIRE.md: the records of a packet."""

from dataclasses import dataclass, field
from math import hypot

from packets import Damaged
from range_coder import RangeDecoder
from tables import DIRECTIONS, context, normal

REGION, REGION_WITH_HOLES, FRAGMENT, FRAGMENT_BACKWARDS, LAYER, PART, END, SKIPPED, EXTENSION = range(9)
NO_INCIDENCE = 13


@dataclass
class Run:
    direction: int
    length: int
    normal: tuple = None  # U and V, if it has one

    def unit_normal(self):
        """Section 9."""
        u, v = self.normal
        height = 127 - abs(u) - abs(v)
        if height < 0:
            u, v = (127 - abs(v)) * (-1 if u < 0 else 1), (127 - abs(u)) * (-1 if v < 0 else 1)
        size = hypot(u, v, height)
        return u / size, v / size, height / size


@dataclass
class Chain:
    """A ring, or the chain of a fragment."""
    start: tuple
    runs: list = field(default_factory=list)


@dataclass
class Region:
    incidence: int
    rings: list  # the outer ring first


@dataclass
class Fragment:
    incidence: int
    chain: Chain
    came: int


@dataclass
class Part:
    is_of_fragment: bool
    continues: bool
    is_last: bool
    begins_ring: bool
    incidence: int
    chain: Chain
    came: int = None


@dataclass
class Layer:
    slice: int


@dataclass
class Skipped:
    slice: int
    row: int
    is_repeated: bool


def wrapped(n):
    """Signed coordinates of 32 bits."""
    return (n + 2 ** 31) % 2 ** 32 - 2 ** 31


def moved(vertex, vector, times=1):
    return tuple(wrapped(v + times * d) for v, d in zip(vertex, vector))


class Records:
    """The records of one packet; each packet decodes alone."""

    def __init__(self, payload, coder=RangeDecoder):
        self.coder = coder(payload)
        self.vertex, self.axis = (0, 0, 0), 0
        self.incidence = NO_INCIDENCE
        self.layer = 0
        self.fragments = 0

    def __iter__(self):
        normals = None
        while True:
            kind = self.symbol(0, 9, self.fragments)
            if kind == END:
                return
            if kind == EXTENSION:
                normals = self.extension() or normals
            else:
                record = self.record(kind)
                if normals:
                    set_normals(record, *normals)
                normals = None
                yield record
            if kind in (FRAGMENT, FRAGMENT_BACKWARDS):
                self.fragments = 2
            else:
                self.fragments = min(self.fragments, 1)

    def record(self, kind):
        if kind in (REGION, REGION_WITH_HOLES):
            return self.region(kind)
        if kind in (FRAGMENT, FRAGMENT_BACKWARDS):
            return self.fragment(kind == FRAGMENT_BACKWARDS)
        if kind == PART:
            return self.part()
        if kind == LAYER:
            self.layer = (self.layer + self.plain()) % 2 ** 32
            return Layer(self.layer)
        return Skipped(self.plain(), self.plain(), bool(self.coder.raw(1)))

    # Sections 7 and 8: symbols, numbers and contexts.

    def symbol(self, first, symbols, number=0):
        return self.coder.symbol(context(first + number * symbols, symbols))

    def number(self, first, number=0):
        s = self.symbol(first, 11, number)
        if s < 3:
            return s + 1
        k = s - 1 if s < 10 else self.coder.raw(5) + 1
        return 2 ** k + self.coder.raw(k)

    def signed(self, first, number=0):
        m = self.number(first, number) - 1
        return m // 2 if m % 2 == 0 else -(m + 1) // 2

    def plain(self):
        return self.number(339) - 1

    @property
    def directions(self):
        return DIRECTIONS[self.incidence]

    @property
    def n(self):
        return len(self.directions)

    def of_class(self, *firsts):
        """The first number of a context in the block of a class."""
        return firsts[self.n // 2 - 2]

    def kind_of_run(self, d):
        return 3 if self.n == 8 and d % 2 == 0 else self.n // 2 - 2

    def level(self, d):
        return int(self.directions[d][2] == 0)

    # Section 9: vertices and incidences.

    def coded_vertex(self):
        """Also returns its position."""
        place = self.symbol(27, 13)
        dx = dy = dz = 0
        if place < 8:
            dx = place
        elif place == 8:
            dx = 7 + self.number(72, 0)
        elif place == 9:
            dx = -self.number(72, 1)
        elif place in (10, 11):
            dx, dy = self.signed(72, place - 8), 1 if place == 10 else -1
        else:
            dz = self.signed(138)
            dy = self.signed(127)
            dx = self.signed(72, 4)
        axis = self.symbol(40, 4, self.axis + (4 if place else 0))
        self.vertex = tuple(wrapped(2 * (v // 2 + d) + (axis in (i, 3)))
                            for i, (v, d) in enumerate(zip(self.vertex, (dx, dy, dz))))
        self.axis = axis
        return place

    def coded_vertex_and_incidence(self):
        previous_axis, previous = self.axis, normal(self.incidence)
        place = self.coded_vertex()
        axis = self.axis
        if axis == 3:
            self.set_incidence(self.coder.raw(5))
            return
        sign = previous[previous_axis] if place == 0 and previous_axis != 3 else 0
        if sign == 0:
            sign = self.coder.raw(1) * 2 - 1
        a, b = (previous[other] for other in range(3) if other != axis)
        before = 1 + a + 3 * (1 + b)
        s = self.symbol(149, 10, before if sign > 0 else 8 - before)
        if s == 9:
            self.set_incidence(self.coder.raw(5))
            return
        heading = s if sign > 0 else 8 - s
        components = [heading % 3 - 1, heading // 3 - 1]
        components.insert(axis, sign)
        self.set_incidence(13 + sum(c * 3 ** i for i, c in enumerate(components)))

    def set_incidence(self, code):
        if code not in DIRECTIONS:
            raise Damaged("incidence")
        self.incidence = code

    # Section 9: regions.

    def region(self, kind):
        self.coded_vertex_and_incidence()
        rings = 2 + self.plain() if kind == REGION_WITH_HOLES else 1
        chains = [self.ring()]
        while len(chains) < rings:
            self.coded_vertex()
            chains.append(self.ring())
        if 4 * rings + sum(len(ring.runs) for ring in chains) > 96:
            raise Damaged("a region that is too long")
        return Region(self.incidence, chains)

    def ring(self):
        n = self.n
        c = self.symbol(self.of_class(390, 442, 527), self.of_class(2, 9, 28))
        f = self.symbol(self.of_class(350, 392, 451), 4)
        if f == 3:
            f = self.coder.raw(3)
        if f >= n:
            raise Damaged("first direction")
        d = (self.first_backwards() + f) % n
        ring = Chain(self.vertex)
        if c == 0:
            ring.runs = self.runs(d, 2)
            self.close_by_one(ring)
        else:
            self.corners(ring, d, c)
        if any(not 1 <= run.length <= 65535 for run in ring.runs):
            raise Damaged("length")
        return ring

    def first_backwards(self):
        """b: the first direction of the second half that leads backwards, else 0."""
        for d in range(self.n // 2, self.n):
            if tuple(reversed(self.directions[d])) < (0, 0, 0):
                return d
        return 0

    def corners(self, ring, d, c):
        m = self.n // 2 - 1
        turns = [1 + (c - 1) % m, 1 + (c - 1) // m % m, 1 + (c - 1) // m ** 2]
        directions = [d]
        for turn in turns:
            directions.append((directions[-1] + turn) % self.n)
        if sum(turns) == self.n:
            directions.pop()
            lengths = [self.number(239, self.kind_of_run(d))]
        else:
            t = self.symbol(self.of_class(354, 396, 455), 16)
            lengths = [1 + t // 4, 1 + t % 4]
            for i in range(2):
                if lengths[i] == 4:
                    lengths[i] = 3 + self.number(283, self.kind_of_run(directions[i]))
        ring.runs = [Run(d, length) for d, length in zip(directions, lengths)]
        self.close_by_two(ring, *directions[-2:])

    def way_back(self, ring):
        """w: minus the sum of all runs."""
        w = (0, 0, 0)
        for run in ring.runs:
            w = tuple(c - run.length * v for c, v in zip(w, self.directions[run.direction]))
        return w

    def close_by_one(self, ring):
        w = self.way_back(ring)
        for d, v in enumerate(self.directions):
            p = max(a // b for a, b in zip(w, v) if b)
            if p > 0 and tuple(p * c for c in v) == w:
                ring.runs.append(Run(d, p))
                return
        raise Damaged("the ring is not closed")

    def close_by_two(self, ring, d, e):
        w, u, v = self.way_back(ring), self.directions[d], self.directions[e]
        for i, j in ((0, 1), (0, 2), (1, 2)):
            determinant = u[i] * v[j] - u[j] * v[i]
            if determinant:
                p = (w[i] * v[j] - w[j] * v[i]) // determinant
                q = (u[i] * w[j] - u[j] * w[i]) // determinant
                break
        if tuple(p * a + q * b for a, b in zip(u, v)) != w:
            raise Damaged("the ring is not closed")
        ring.runs += [Run(d, p), Run(e, q)]

    def runs(self, d, chain, sense=1):
        """`chain` is 0 for fragments and parts, 1 for fragments coded backwards, 2 for rings."""
        runs = [Run(d, self.number(239, self.kind_of_run(d)))]
        while self.symbol(327, 2, 2 * chain + self.level(d)) == 0:
            s = self.symbol(self.of_class(382, 430, 495), 2 * self.n, d % 2 if self.n == 8 else 0)
            d = (d + sense * (s // 2)) % self.n
            longer = 283, self.kind_of_run(d)
            runs.append(Run(d, 1 if s % 2 == 0 else 1 + self.number(*longer)))
        return runs

    # Section 9: fragments and parts.

    def cut_turn(self, d):
        return self.symbol(self.of_class(370, 412, 471), self.n, self.level(d))

    def first_direction(self):
        return self.symbol(self.of_class(378, 424, 487), self.n)

    def fragment(self, is_backwards):
        self.coded_vertex_and_incidence()
        if not is_backwards:
            came = self.first_direction()
            d = (came + self.cut_turn(came)) % self.n
            return Fragment(self.incidence, Chain(self.vertex, self.runs(d, 0)), came)
        runs = self.runs(self.first_direction(), 1, -1)
        came = (runs[-1].direction - self.cut_turn(runs[-1].direction)) % self.n
        start = moved(self.vertex, self.directions[runs[0].direction])
        for run in runs:
            start = moved(start, self.directions[run.direction], -run.length)
        return Fragment(self.incidence, Chain(start, runs[::-1]), came)

    def part(self):
        flags = self.coder.raw(4)
        part = Part(*(bool(flags & bit) for bit in (8, 4, 2, 1)), None, None)
        self.set_incidence(self.coder.raw(5))
        part.incidence = self.incidence
        if part.begins_ring:
            self.coded_vertex()
        if part.is_of_fragment and not part.continues:
            part.came = self.first_direction()
            d = (part.came + self.cut_turn(part.came)) % self.n
        else:
            d = self.first_direction()
        part.chain = Chain(self.vertex if part.begins_ring else None, self.runs(d, 0))
        return part

    def extension(self):
        """The normals of an extension of the types 1 to 9, else None."""
        type_, count = self.coder.raw(8), self.coder.raw(8)
        if not 1 <= type_ <= 9:
            for _ in range(count):
                self.coder.raw(8)
            return None
        return self.normals(type_ - 1, 8 * count)

    def normals(self, bits, left):
        """Yields U and V of each normal, None for no normal, and reads the unused bits."""
        u, v = self.coder.raw(8), self.coder.raw(8)
        left -= 16
        normals = [(u, v)]
        while bits and left >= 2 * bits:
            u, v = (u + self.difference(bits)) % 256, (v + self.difference(bits)) % 256
            normals.append((u, v))
            left -= 2 * bits
        while left:
            n = min(left, 8)
            self.coder.raw(n)
            left -= n
        return [(u - 128, v - 128) if u else None for u, v in normals], bits

    def difference(self, bits):
        n = self.coder.raw(bits)
        return n // 2 if n % 2 == 0 else 255 - (n - 1) // 2


def set_normals(record, normals, bits):
    """Section 9: the normals of the runs of a record, in the order of its chains."""
    chains = record.rings if isinstance(record, Region) else [record.chain]
    runs = [run for chain in chains for run in chain.runs]
    if bits == 0:
        normals = normals * len(runs)
    for run, normal in zip(runs, normals):
        run.normal = normal
