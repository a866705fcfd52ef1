"""Section 14 of lib/WIRE.md: codes, rows, voxels and contexts of a stream of slices."""

from crossings import Fractions, row_of_fractions
from packets import Damaged
from range_coder import RangeDecoder, Truncated
from tables import KEY_SLICES, OTHER_SLICES

# How a row came.
CODED, OFF, REPEATED, LOST = "coded", "off", "repeated", "lost"
END_OF_CODE = 0
NOTE, RUNS, VOXELS = 0, 1, 17
VOXEL = 0  # the part of a row before its fractions, as in a cut


class Surface:
    """The contexts of a surface, and its rows: lists of bits, with an off voxel at either end."""

    def __init__(self, width, height, levels):
        self.off = [0] * (width + 2)
        self.rows = []
        self.p = []
        self.fractions = Fractions(levels, width, height) if levels else None

    def reset(self, table):
        self.p = [32] + [256 * t + 128 for t in table]
        self.p += self.p[VOXELS:]  # from 273 on


class SliceRows:
    """Decodes codes to rows. `kinds` has the kind of each row, and `surfaces` their voxels."""

    def __init__(self, header):
        self.width, self.height = header.width, header.height
        self.surfaces = [Surface(self.width, self.height, header.levels) for _ in header.thresholds]
        self.kinds = []
        self.key_slice = None  # the last one
        self.coder = None
        self.steps = None  # of the row in progress, also while a cut interrupts it

    def begin_key_slice(self):
        self.key_slice = len(self.kinds) // self.height
        self.reset(KEY_SLICES)
        for surface in self.surfaces:
            if surface.fractions:
                surface.fractions.reset()

    def reset(self, table):
        for surface in self.surfaces:
            surface.reset(table)

    def is_coded(self, number):
        return self.kinds[number] == CODED

    def is_lost(self, number):
        return self.kinds[number] == LOST

    def lose(self, rows):
        for _ in range(rows):
            self.skip(LOST, [surface.off for surface in self.surfaces])

    def skip(self, kind, rows):
        self.add(kind, rows, [[[0] * (self.width + 2)] * 3 for _ in rows])

    def add(self, kind, rows, fractions):
        self.kinds.append(kind)
        for surface, row, f in zip(self.surfaces, rows, fractions):
            surface.rows.append(row)
            if surface.fractions:
                surface.fractions.rows.append(f)

    def decode(self, data, cut, is_complete):
        """Adds the rows of a code. If only its beginning is given, adds the rows that it contains."""
        try:
            self.coder = RangeDecoder(data, is_complete)
            while self.steps or self.note():
                for row, place in self.steps or ():
                    if cut == (row, place):
                        return
                self.steps = None
        except (Truncated, Damaged) as error:
            self.steps = None
            if isinstance(error, Damaged):
                raise

    def note(self):
        """Skips a row or begins one; False at the end of the code."""
        note = 0
        if self.coder.learnt(self.surfaces[0].p, NOTE):
            note = self.coder.raw_bits(3)
            if note == END_OF_CODE:
                return False
        z, y = divmod(len(self.kinds), self.height)
        if y == 0 and self.key_slice is not None and z == self.key_slice + 1:
            self.reset(OTHER_SLICES)
        for surface in self.surfaces:
            if surface.fractions:
                surface.fractions.begin_row(len(self.kinds), y)
        if note == 0:
            self.steps = self.row()
        elif note == 1:
            self.skip(OFF, [surface.off for surface in self.surfaces])
        elif note == 2 and not (y == 0 and z == self.key_slice):
            self.skip(REPEATED, [surface.rows[-1] for surface in self.surfaces])
        else:
            raise Damaged("note")
        return True

    def row(self):
        """Decodes a row of each surface. Yields both numbers of each position for a cut."""
        rows, fractions = [], []

        def place(part, second):
            number = (len(self.kinds) + 2 ** 24 * part) * len(self.surfaces) + len(rows) - 1
            return number % 2 ** 32, second

        for surface in self.surfaces:
            row = [0]
            rows.append(row)
            neighbours = self.neighbours(surface)
            while len(row) <= self.width:
                yield place(VOXEL, self.width + 1 - len(row))
                self.run_or_voxel(surface, rows, neighbours)
            row.append(0)
            f = [[0] * (self.width + 2) for _ in range(3)]
            if surface.fractions:
                for part, second in row_of_fractions(self, surface, row, f):
                    yield place(part, second)
            fractions.append(f)
        self.add(CODED, rows, fractions)

    def neighbours(self, surface):
        """`neighbours` of each voxel of the next row for v = 0; for v = 1 each bit is inverted."""
        z, y = divmod(len(self.kinds), self.height)

        def row(slices, rows):
            at = y - rows
            return surface.rows[(z - slices) * self.height + at] if 0 <= at < self.height else surface.off

        places = [(row(0, 1), -1), (row(0, 1), 0), (row(0, 1), 1)]
        if z == self.key_slice:
            places += [(row(0, 2), -1), (row(0, 2), 0), (row(0, 2), 1), (row(0, 3), 0), (row(0, 1), 0)]
        else:
            places += [(row(1, 0), -1), (row(1, 0), 0), (row(1, 0), 1), (row(1, -1), 0), (row(1, 1), 0)]
        return [None] + [sum(r[x + dx] << bit for bit, (r, dx) in enumerate(places))
                         for x in range(1, self.width + 1)]

    def run_or_voxel(self, surface, rows, neighbours):
        row = rows[-1]
        v, x = row[-1], len(row)
        same = 255 if v else 0
        n = 0
        while x + n <= self.width and neighbours[x + n] == same:
            n += 1
        if n >= 2:
            length, ends = min(n.bit_length(), 8), int(x + n > self.width)
            if self.coder.learnt(surface.p, RUNS + 2 * (length - 1) + ends):
                row += [v] * n
                return
            m = self.coder.raw_bits((n - 1).bit_length())
            if m >= n:
                raise Damaged("run")
            row += [v] * m + [1 - v]
            return
        context = neighbours[x] ^ same
        if len(rows) > 1 and rows[0][x] != v:
            context += 256
        row.append(v ^ self.coder.learnt(surface.p, VOXELS + context))
