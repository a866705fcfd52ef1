"""Section 15 of lib/WIRE.md: the fractions of the edges between voxels."""

from collections import deque

from packets import Damaged

FX, FY, FZ, COUNT, FZ_AFTER_COUNT = range(1, 6)  # the parts of a row, as in a cut
AFTER_COUNT = 448  # the first tree of an Fz after a count


class Fractions:
    """The contexts of a surface, and the fractions of its rows: Fx, Fy and Fz, each with a 0 at either end."""

    def __init__(self, levels, width, height):
        self.levels, self.height = levels, height
        self.none = [0] * (width + 2)
        self.rows = []
        self.most = 8 * (width + height)
        self.queue = deque()  # the number of the row, the axis, x and the fraction
        self.full_slice = None
        self.below = self.below_above = (self.none, self.none)

    def begin_row(self, number, y):
        """Dequeues Fx and Fy of this row in the slice before."""
        self.below_above = self.below if y else (self.none, self.none)
        self.below = tuple(list(self.none) for _ in range(2))
        while self.queue and self.queue[0][0] == number - self.height:
            _, axis, x, fraction = self.queue.popleft()
            self.below[axis][x] = fraction

    def join_queue(self, number, axis, x, fraction):
        if len(self.queue) == self.most:
            self.full_slice = number // self.height
        if self.full_slice != number // self.height:
            self.queue.append((number, axis, x, fraction))

    def reset(self):
        self.queue.clear()
        self.full_slice = None
        self.counts = [32768] * 16
        self.trees = [32768] * (453 * (self.levels - 1))

    def value(self, coder, tree):
        first = tree * (self.levels - 1)
        h = coder.learnt_quickly(self.trees, first)
        if self.levels == 2:
            return 4 * h + 2
        return 4 * h + 2 * coder.learnt_quickly(self.trees, first + 1 + h) + 1


def row_of_fractions(rows, surface, row, f):
    """Decodes Fx, Fy and Fz of a row. Yields the part and the second number of each position for a cut."""
    edges = Edges(rows, surface, row, f)
    is_counted = edges.is_key and edges.z > 0
    for x in range(1, rows.width + 1):
        for axis in (0, 1) if is_counted else (0, 1, 2):
            if edges.has(axis, x):
                yield FX + axis, rows.width + 1 - x
                u = surface.fractions.value(rows.coder, edges.tree(axis, x))
                f[axis][x] = u if row[x] else 8 - u
                if axis < 2:
                    surface.fractions.join_queue(len(rows.kinds), axis, x, f[axis][x])
    if is_counted:
        yield from counted(rows, surface.fractions, edges, f[2])


def counted(rows, fractions, edges, fz):
    ones = 0
    yield COUNT, ones
    while rows.coder.learnt_quickly(fractions.counts, ones):
        ones += 1
        if ones == 16:
            raise Damaged("count")
        yield COUNT, ones
    left = 2 ** (ones - 1) + rows.coder.raw_bits(ones - 1) if ones else 0
    places = [x for x in range(1, rows.width + 1) if edges.has(2, x)]
    if left > rows.width or not edges.is_before_lost and left != len(places):
        raise Damaged("count")
    last = 0
    while left:
        yield FZ_AFTER_COUNT, left
        last = fractions.value(rows.coder, AFTER_COUNT + (last + 1) // 2)
        if not edges.is_before_lost:
            fz[places[-left]] = last
        left -= 1


class Edges:
    """The edges whose upper ends are in a row, and their trees. x is 1 for the first voxel."""

    def __init__(self, rows, surface, row, f):
        number = len(rows.kinds)
        before = number - rows.height
        self.z, y = divmod(number, rows.height)
        self.is_key = self.z == rows.key_slice
        self.row, self.f = row, f
        self.above = self.above_before = self.before = surface.off
        self.f_above = [surface.fractions.none] * 3
        self.has_above = self.has_before = self.is_before_lost = False
        if y > 0:
            self.above, self.has_above = surface.rows[-1], rows.is_coded(-1)
            fx, fy, fz = surface.fractions.rows[-1]
            self.f_above = fx, fy, surface.fractions.none if self.is_key else fz
        if self.z > 0:
            self.before, self.has_before = surface.rows[before], rows.is_coded(before)
            self.is_before_lost = rows.is_lost(before)
        if self.z > 0 and y > 0:
            self.above_before = surface.rows[before - 1]
        self.below, self.below_above = surface.fractions.below, surface.fractions.below_above
        self.known_before, self.known_above_before = self.before, self.above_before
        if self.is_key:
            self.known_before = self.known_above_before = surface.off

    def has(self, axis, x):
        if axis == 0:
            return x > 1 and self.row[x] != self.row[x - 1]
        if axis == 1:
            return self.has_above and self.row[x] != self.above[x]
        return self.has_before and self.row[x] != self.before[x]

    def tree(self, axis, x):
        s = self.row[x]
        number = self.number_beside(axis, x, s)
        line = 0
        if number is not None:
            number = number if s else 8 - number
            line = 1 if number < -1 else 6 if number > 9 else 1 + 3 * (number + 4) // 8
        lower, upper = (third(distances) for distances in self.distances(axis, x))
        off, on = (lower, upper) if s else (upper, lower)
        return ((line * 4 + off) * 4 + on) * 4 + self.forward(axis, x, s)

    def number_beside(self, axis, x, s):
        if axis == 0:
            edges = [(self.above[x - 1], self.above[x], self.f_above[0][x]),
                     (self.known_before[x - 1], self.known_before[x], self.below[0][x]),
                     (self.known_above_before[x - 1], self.known_above_before[x], self.below_above[0][x])]
        elif axis == 1:
            edges = [(self.above[x - 1], self.row[x - 1], self.f[1][x - 1]),
                     (self.known_above_before[x], self.known_before[x], self.below[1][x]),
                     (self.known_above_before[x - 1], self.known_before[x - 1], self.below[1][x - 1])]
        else:
            edges = [(self.before[x - 1], self.row[x - 1], self.f[2][x - 1]),
                     (self.above_before[x], self.above[x], self.f_above[2][x]),
                     (self.above_before[x - 1], self.above[x - 1], self.f_above[2][x - 1])]
        a, b, c = (beside(*edge, s) for edge in edges)
        if a is None or b is None:
            return b if a is None else a
        return (a + b) // 2 if c is None else a + b - c

    def distances(self, axis, x):
        """The values of the lower end and of the upper end."""
        def back(*fractions):
            return [8 - f for f in fractions if f]

        def forth(fraction):
            return [fraction] if fraction else []

        if axis == 0:
            return back(*(f[x - 1] for f in self.f)), []
        if axis == 1:
            return back(*(f[x] for f in self.f_above)) + forth(self.f_above[0][x + 1]), back(self.f[0][x])
        return back(*(f[x] for f in self.below)) + forth(self.below[0][x + 1]), back(self.f[0][x], self.f[1][x])

    def forward(self, axis, x, s):
        if axis == 0:
            return 0
        lower, upper = (self.above if axis == 1 else self.before)[x + 1], self.row[x + 1]
        if lower == upper:
            return 1 if (upper == s) == bool(s) else 3
        return 2 if upper == s else 0


def beside(lower, upper, fraction, s):
    if lower == upper:
        return -4 if lower == s else 12
    return fraction if upper == s and fraction else None


def third(distances):
    n, total = len(distances), sum(distances)
    return 1 + (3 * total >= 8 * n) + (3 * total >= 16 * n) if n else 0
