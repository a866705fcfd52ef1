"""Families of volumes for the command: u8 samples, 0 and 1, with the same structure at every size."""
import random


def rows(width, is_on):
    return bytes(1 if is_on(x) else 0 for x in range(width))


def plate(n, has_islands):
    """One slice with holes of 6 x 6 voxels, with a period of 8."""
    def row(y):
        is_rim = y in (0, n - 1)
        return rows(n, lambda x: is_rim or x in (0, n - 1) or x % 8 > 5 or y % 8 > 5 or
                    (has_islands and x % 8 // 2 == 1 and y % 8 // 2 == 1))
    of_phase = [row(y) for y in range(8, 16)]
    return (n, n, 1), row(0) + b''.join(of_phase[y % 8] for y in range(1, n - 1)) + row(n - 1)


def holes(n):
    return plate(n, False)


def islands(n):
    return plate(n, True)


def nested_rings(n):
    def row(y):
        near = min(y, n - 1 - y)
        return rows(n, lambda x: min(x, n - 1 - x, near) % 4 < 2)
    half = [row(y) for y in range((n + 1) // 2)]
    return (n, n, 1), b''.join(half + half[:n // 2][::-1])


def bodies(n):
    on, off = rows(n, lambda x: x % 4 < 2), bytes(n)
    return (n, n, 3), b''.join(on if y % 4 < 2 else off for _ in range(3) for y in range(n))


def cavities(n):
    on, some = b'\1' * n, rows(n, lambda x: x % 3 != 1)
    return (n, n, 3), b''.join(some if z == 1 and y % 3 == 1 and 0 < y < n - 1 else on
                               for z in range(3) for y in range(n))


def comb(n):
    teeth, joint = rows(n, lambda x: x % 2 == 0), b'\1' * n
    return (n, n, 2), (teeth * (n - 1) + joint) * 2


def noise(n):
    chance = random.Random(1)
    return (n, n, 2), bytes(chance.getrandbits(1) for _ in range(2 * n * n))


def nested_shells(n):
    def row(y, z):
        near = min(y, n - 1 - y, z, n - 1 - z)
        return rows(n, lambda x: min(x, n - 1 - x, near) % 4 < 2)
    return (n, n, n), b''.join(row(y, z) for z in range(n) for y in range(n))


def ball(n):
    def row(y, z):
        rest = n * n - (2 * y - n + 1) ** 2 - (2 * z - n + 1) ** 2
        return rows(n, lambda x: (2 * x - n + 1) ** 2 < rest - 8 * n)
    return (n, n, n), b''.join(row(y, z) for z in range(n) for y in range(n))


def long_columns(n):
    on, off = rows(16, lambda x: x % 4 < 2), bytes(16)
    return (16, 16, n), b''.join(on if y % 4 < 2 else off for y in range(16)) * n


def long_rows(n):
    return (n, 16, 4), b''.join((b'\1' if y % 4 < 2 and z % 2 == 0 else b'\0') * n
                                for z in range(4) for y in range(16))


def slope(n):
    return (n, 2, n), b''.join(rows(n, lambda x, z=z: z <= x < z + 10) * 2 for z in range(n))


def disc(n):
    """A disc of one slice. The corners of its polygon grow with its rim."""
    def row(y):
        rest = n * n - (2 * y - n + 1) ** 2
        return rows(n, lambda x: (2 * x - n + 1) ** 2 < rest)
    return (n, n, 1), b''.join(row(y) for y in range(n))


def spikes(n):
    """One polygon with n/2 teeth of different lengths, and a hole in every second tooth."""
    def row(y):
        return rows(n, lambda x: y < 4 or (x % 6 < 4 and y < 8 + (x // 6 * 37) % n and
                                           not (x % 6 in (1, 2) and y % 4 == 1)))
    return (n, n, 1), b''.join(row(y) for y in range(n))


def bodies_in_cavities(n):
    """Boxes of 6 x 6 x 6 voxels, each with a cavity that contains a voxel: as many bodies as cavities."""
    def row(y, z):
        def is_on(x):
            inside = [at % 6 - 1 for at in (x, y, z)]
            return not all(0 <= each < 3 for each in inside) or inside == [1, 1, 1]
        return rows(n, is_on)
    kinds = {(y, z): row(y, z) for y in range(6) for z in range(6)}
    return (n, n, 6), b''.join(kinds[y % 6, z] for z in range(6) for y in range(n))


def bodies_in_a_cavity(n):
    """Voxels in the only cavity of a box, all on one plane, below a ragged roof."""
    def row(y, z):
        is_wall = y in (0, n - 1) or z in (0, 5)
        return rows(n, lambda x: is_wall or x in (0, n - 1) or
                    (z == 2 and 2 < x < n - 3 and 2 < y < n - 3 and x % 3 == y % 3 == 0) or
                    (z == 4 and x % 2 == y % 2 == 0))
    return (n, n, 6), b''.join(row(y, z) for z in range(6) for y in range(n))
