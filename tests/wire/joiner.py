"""Section 9 of lib/WIRE.md: regions from loose fragments."""

from collections import defaultdict

from records import Chain, Region, moved
from tables import DIRECTIONS, normal


def vertices(chain, incidence):
    """Returns the starts of the runs, and the end of the last run."""
    at = [chain.start]
    for run in chain.runs:
        at.append(moved(at[-1], DIRECTIONS[incidence][run.direction], run.length))
    return at


def joined(fragments):
    """Returns the regions of all fragments, and the number of open chains and of holes without a region."""
    by_plane, unmatched = defaultdict(list), 0
    for incidence, ring in rings(fragments):
        if ring is None:
            unmatched += 1
            continue
        plane = sum(a * b for a, b in zip(normal(incidence), ring.start))
        by_plane[incidence, plane].append(ring)
    regions = []
    for (incidence, _), of_plane in by_plane.items():
        of_plane_regions = regions_of_plane(incidence, of_plane)
        unmatched += len(of_plane) - sum(len(region.rings) for region in of_plane_regions)
        regions += of_plane_regions
    return regions, unmatched


def rings(fragments):
    """(incidence, ring) of each ring; (incidence, None) of each chain that is not a ring."""
    waiting = {(f.incidence, f.chain.start, f.came): f for f in fragments}
    followed = {key: after(f) for key, f in waiting.items()}
    first_ones = waiting.keys() - set(followed.values())
    for at in first_ones:
        yield at[0], None
        while at in waiting:
            del waiting[at]
            at = followed[at]
    while waiting:
        first = at = next(iter(waiting))
        ring = Chain(first[1])
        while at in waiting:
            ring.runs += waiting.pop(at).chain.runs
            at = followed[at]
        yield first[0], ring


def after(fragment):
    """The end of a fragment, which the next one must match: incidence, start and `came`."""
    end = vertices(fragment.chain, fragment.incidence)[-1]
    return fragment.incidence, end, fragment.chain.runs[-1].direction


def regions_of_plane(incidence, of_plane):
    """Outer rings run counter-clockwise. A hole belongs to the smallest outer ring around it."""
    flat = {id(ring): flattened(ring, incidence) for ring in of_plane}
    area = {key: doubled_area(points) for key, points in flat.items()}
    outer = sorted((ring for ring in of_plane if area[id(ring)] > 0), key=lambda ring: area[id(ring)])
    regions = [Region(incidence, [ring]) for ring in outer]
    for hole in of_plane:
        if area[id(hole)] < 0:
            link = [sum(c) for c in zip(*flat[id(hole)][:2])]  # twice its middle
            home = [r for r in regions if contains(flat[id(r.rings[0])], link)]
            if home:
                home[0].rings.append(hole)
    return regions


def flattened(ring, incidence):
    """The ring along two axes that keep its orientation, with each run divided into links."""
    axis = max(range(3), key=lambda a: abs(normal(incidence)[a]))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    if normal(incidence)[axis] < 0:
        i, j = j, i
    points, at = [], ring.start
    for run in ring.runs:
        for _ in range(run.length):
            points.append((at[i], at[j]))
            at = moved(at, DIRECTIONS[incidence][run.direction])
    return points


def doubled_area(points):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(points, points[1:] + points[:1]))


def contains(points, doubled):
    """Counts the sides that a ray from the point along x crosses."""
    x, y = doubled
    inside = False
    for a, b in zip(points, points[1:] + points[:1]):
        (ax, ay), (bx, by) = sorted(((2 * a[0], 2 * a[1]), (2 * b[0], 2 * b[1])), key=lambda p: p[1])
        if ay <= y < by and (x - ax) * (by - ay) < (bx - ax) * (y - ay):
            inside = not inside
    return inside
