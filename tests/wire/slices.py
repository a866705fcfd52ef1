"""Section 14 of lib/WIRE.md: codes, rows, voxels and contexts of a stream of slices."""

from packets import Damaged
from range_coder import RangeDecoder, Truncated
from tables import KEY_SLICES, OTHER_SLICES

# How a row came.
CODED, OFF, REPEATED, LOST = "coded", "off", "repeated", "lost"
END_OF_CODE = 0
NOTE, RUNS, VOXELS = 0, 1, 17


class Surface:
    """The contexts of a surface, and its rows: lists of bits, with an off voxel at either end."""

    def __init__(self, width):
        self.off = [0] * (width + 2)
        self.rows = []
        self.p = []

    def reset(self, table):
        self.p = [32] + [256 * t + 128 for t in table]
        self.p += self.p[VOXELS:]  # from 273 on

    def bit(self, coder, context):
        p = self.p[context]
        bit = coder.decision(p, 16)
        self.p[context] = p + (65535 - p >> 4) if bit else p - (p >> 4)
        return bit


class SliceRows:
    """Decodes codes to rows; `kinds` has how each row came, and `surfaces` their voxels."""

    def __init__(self, header):
        self.width, self.height = header.width, header.height
        self.surfaces = [Surface(self.width) for _ in header.thresholds]
        self.kinds = []
        self.key_slice = None  # the last one
        self.cut_row = None  # the rows of the surfaces so far, if a cut interrupted them

    def begin_key_slice(self):
        self.key_slice = len(self.kinds) // self.height
        self.reset(KEY_SLICES)

    def reset(self, table):
        for surface in self.surfaces:
            surface.reset(table)

    def lose(self, rows):
        self.cut_row = None
        for _ in range(rows):
            self.add(LOST, [surface.off for surface in self.surfaces])

    def add(self, kind, rows):
        self.kinds.append(kind)
        for surface, row in zip(self.surfaces, rows):
            surface.rows.append(row)

    def decode(self, data, cut, is_complete):
        """Adds the rows of a code; of the beginning of a code as many as its bytes contain."""
        try:
            coder = RangeDecoder(data, is_complete)
            while True:
                if self.cut_row is None and not self.note(coder):
                    return
                if self.cut_row is not None and not self.voxels(coder, cut):
                    return
        except Truncated:
            self.cut_row = None

    def note(self, coder):
        """Skips a row or begins one; False at the end of the code."""
        note = 0
        if self.surfaces[0].bit(coder, NOTE):
            note = even(coder, 3)
            if note == END_OF_CODE:
                return False
        z, y = divmod(len(self.kinds), self.height)
        if y == 0 and self.key_slice is not None and z == self.key_slice + 1:
            self.reset(OTHER_SLICES)
        if note == 0:
            self.cut_row = [[0]]
        elif note == 1:
            self.add(OFF, [surface.off for surface in self.surfaces])
        elif note == 2 and not (y == 0 and z == self.key_slice):
            self.add(REPEATED, [surface.rows[-1] for surface in self.surfaces])
        else:
            raise Damaged("note")
        return True

    def voxels(self, coder, cut):
        """The voxels of each surface, or the rest of them; False at the cut."""
        for i, surface in enumerate(self.surfaces):
            if i == len(self.cut_row):
                self.cut_row.append([0])
            number = len(self.kinds) * len(self.surfaces) + i
            row = self.cut_row[i]
            if len(row) == self.width + 2:
                continue
            neighbours = self.neighbours(surface)
            while len(row) <= self.width:
                if cut == (number % 2 ** 32, self.width + 1 - len(row)):
                    return False
                self.run_or_voxel(coder, i, row, neighbours)
            row.append(0)
        self.add(CODED, self.cut_row)
        self.cut_row = None
        return True

    def neighbours(self, surface):
        """`neighbours` of each voxel of the next row for v = 0; for v = 1 each bit is the other."""
        z, y = divmod(len(self.kinds), self.height)

        def row(slices, rows):
            at = y - rows
            return surface.rows[(z - slices) * self.height + at] if 0 <= at < self.height else surface.off

        if z == self.key_slice:
            places = [(row(0, 1), -1), (row(0, 1), 0), (row(0, 1), 1),
                      (row(0, 2), -1), (row(0, 2), 0), (row(0, 2), 1), (row(0, 3), 0), (row(0, 1), 0)]
        else:
            places = [(row(0, 1), -1), (row(0, 1), 0), (row(0, 1), 1),
                      (row(1, 0), -1), (row(1, 0), 0), (row(1, 0), 1), (row(1, -1), 0), (row(1, 1), 0)]
        return [None] + [sum(r[x + dx] << bit for bit, (r, dx) in enumerate(places))
                         for x in range(1, self.width + 1)]

    def run_or_voxel(self, coder, i, row, neighbours):
        v, x = row[-1], len(row)
        surface, same = self.surfaces[i], 255 if v else 0
        n = 0
        while x + n <= self.width and neighbours[x + n] == same:
            n += 1
        if n >= 2:
            length, ends = min(n.bit_length(), 8), int(x + n > self.width)
            if surface.bit(coder, RUNS + 2 * (length - 1) + ends):
                row += [v] * n
                return
            m = even(coder, (n - 1).bit_length())
            if m >= n:
                raise Damaged("run")
            row += [v] * m + [1 - v]
            return
        context = neighbours[x] ^ same
        if i > 0 and self.cut_row[0][x] != v:
            context += 256
        row.append(v ^ surface.bit(coder, VOXELS + context))


def even(coder, bits):
    value = 0
    for _ in range(bits):
        value = 2 * value + coder.decision(128, 8)
    return value
