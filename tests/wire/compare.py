#!/usr/bin/env python3
"""Compares the decoder of this folder, written from lib/WIRE.md alone, with the command, stream by stream.

Usage: compare.py COMMAND ENCODER, the paths of discmc and of encode_fractions
"""

import json
import random
import subprocess
import sys
import tempfile
import unittest
from math import gcd, hypot
from pathlib import Path

import streams
from joiner import joined, vertices
from packets import RECORDS, WrongVersion
from range_coder import RangeEncoder
from receiver import decoded
from records import Fragment, Layer, Region, Skipped
from slices import OFF, REPEATED
from tables import normal

PROJECT = Path(__file__).resolve().parents[2]
COMMAND, ENCODER = "discmc", "encode_fractions"


def discmc(*arguments, codes=(0, 3)):
    """The output of the command. Code 3 means that a stream is incomplete."""
    done = subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode not in codes:
        raise AssertionError(f"discmc {arguments} returned {done.returncode}: {done.stderr}")
    return done.stdout if done.returncode in (0, 3) else done.stderr


def links(normal_, rings):
    """A polygon as its links: the command divides rings that touch themselves."""
    found = []
    for ring in rings:
        for a, b in zip(ring, ring[1:] + ring[:1]):
            run = [q - p for p, q in zip(a, b)]
            length = gcd(*run) if sum(map(bool, run)) > 1 else gcd(*run) // 2
            step = [c // length for c in run]
            found += [(*(p + i * s for p, s in zip(a, step)), *step) for i in range(length)]
    return tuple(normal_), tuple(sorted(found))


def polygons_of_command(file, folder, *options, verb="decode"):
    out = folder / "polygons.jsonl"
    discmc(verb, file, "-o", out, *options)
    polygons = map(json.loads, out.read_text().splitlines())
    return sorted(links(p["normal"], p["rings"]) for p in polygons)


def facts_of_command(file, *options):
    lines = discmc("info", file, *options).splitlines()
    return dict(line.split(" ", 1) for line in lines if " " in line)


def regions_of(stream):
    """All regions, and the numbers of chains and holes without a region."""
    whole = [e for e in stream.events if isinstance(e, Region)]
    of_fragments, unmatched = joined([e for e in stream.events if isinstance(e, Fragment)])
    return whole + of_fragments, unmatched


def polygons_of(regions):
    return sorted(links(normal(r.incidence), [vertices(ring, r.incidence)[:-1] for ring in r.rings])
                  for r in regions)


def facts_of(stream, regions, unmatched):
    """What `discmc info` prints."""
    header, is_whole = stream.header, stream.trailer is not None
    losses = [stream.lost("packets"), len(stream.damaged), stream.lost("pieces") + unmatched, stream.lost("rows")]
    facts = {
        "dimensions": f"{header.width} {header.height}",
        "wire": "slices" if header.has_slices else "regions",
        "threshold": header.thresholds[0],
        "border": "open" if header.is_open else "closed",
        "lost_packets": losses[0],
        "damaged_packets": losses[1],
        "lost_pieces": losses[2],
        "lost_rows": losses[3],
        "repeated_packets": stream.repeated,
        "foreign_packets": stream.foreign,
        "mixed": "yes" if stream.is_mixed else "no",
        "complete": "yes" if is_whole and not stream.is_mixed and not any(losses) else "no",
    }
    if is_whole:
        facts["abandoned"] = "yes" if stream.trailer.is_abandoned else "no"
        facts["skipped_rows"] = stream.trailer.totals["skipped_rows"]
    if header.has_slices:
        return facts
    rings = [ring for region in regions for ring in region.rings]
    facts |= {
        "regions": len(regions),
        "links": sum(run.length for ring in rings for run in ring.runs),
        "normals": sum(run.normal is not None for ring in rings for run in ring.runs),
    }
    return facts


def write_volume(path, width, height, bits):
    """A NRRD file with its missing last voxels off."""
    depth = -(-len(bits) // (width * height))
    header = (f"NRRD0004\ntype: uint8\ndimension: 3\nsizes: {width} {height} {depth}\n"
              "spacings: 1 1 1\nspace units: \"mm\" \"mm\" \"mm\"\nspace dimension: 3\nencoding: raw\n\n")
    path.write_bytes(header.encode() + bytes(bits).ljust(width * height * depth, b"\0"))


class Compare(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.folder = Path(cls.scratch.name)

    def extracted(self, name, *options):
        volume, out = self.folder / f"{name}.nrrd", self.folder / "extracted.dmc"
        if not volume.exists():
            width, height, samples = streams.VOLUMES[name]
            write_volume(volume, width, height, samples())
        discmc("extract", volume, "-q", "-o", out, *options)
        return out.read_bytes()

    def compare(self, data, channel=None):
        """Returns the decoded stream."""
        file = self.folder / "stream.dmc"
        file.write_bytes(data)
        options = [] if channel is None else ["--stream-channel", channel]
        stream = decoded(data, channel)
        regions, unmatched = regions_of(stream)
        expected = facts_of_command(file, *options)
        expected["dimensions"] = expected["dimensions"].rsplit(" ", 1)[0]
        for name, value in facts_of(stream, regions, unmatched).items():
            self.assertEqual(str(value), expected[name], name)
        if stream.rows:
            self.compare_rows(stream, file)
        else:
            self.assertEqual(polygons_of(regions), polygons_of_command(file, self.folder, *options))
        return stream

    def compare_rows(self, stream, file):
        """The surface of the decoded voxels is that of the command."""
        header, volume = stream.header, self.folder / "decoded.nrrd"
        for i, surface in enumerate(stream.rows.surfaces):
            bits = [voxel for row in surface.rows for voxel in row[1:-1]]
            write_volume(volume, header.width, header.height, bits)
            mine = polygons_of_command(volume, self.folder, "--iso", 1, "-q", "--allow-empty",
                                       "--border", "open" if header.is_open else "closed", verb="extract")
            theirs = polygons_of_command(file, self.folder, "--stream-channel", stream.channel + i)
            if stream.trailer:
                self.assertEqual(mine, theirs)
            else:  # without a trailer, the surface of the last slices is missing
                self.assertLessEqual(set(theirs), set(mine))

    def test_polygons_equal_those_of_the_command(self):
        for name, options in streams.POLYGONS:
            with self.subTest(volume=name, options=options):
                stream = self.compare(self.extracted(name, *options))
                self.compare_layers(stream)

    def compare_layers(self, stream):
        """Section 9: when a layer mark for slice k arrives, no region below z = 2k is missing."""
        layer = None
        for event in stream.events:
            if isinstance(event, Region) and layer is not None:
                top = max(v[2] for ring in event.rings for v in vertices(ring, event.incidence))
                self.assertGreaterEqual(top, 2 * layer)
            if isinstance(event, Layer):
                layer = event.slice

    def test_normals_equal_those_of_the_command(self):
        data = self.extracted("ball", "--iso", 100, "--normals", "gradient")
        stream, points = self.compare(data), {}
        for region in regions_of(stream)[0]:
            for ring in region.rings:
                for vertex, run in zip(vertices(ring, region.incidence), ring.runs):
                    if run.normal:
                        points[tuple(c / 2 for c in vertex)] = run.unit_normal()
        mesh = self.folder / "mesh.obj"
        discmc("decode", self.folder / "stream.dmc", "--normals", "gradient", "--space", "voxel", "-o", mesh)
        lines = [line.split() for line in mesh.read_text().splitlines()]
        at = [tuple(map(float, line[1:])) for line in lines if line[:1] == ["v"]]
        normals = [tuple(map(float, line[1:])) for line in lines if line[:1] == ["vn"]]
        self.assertEqual(len(at), len(normals))
        self.assertGreater(len(points), 100)
        theirs = dict(zip(at, normals))
        for point, direction in points.items():
            self.assertLess(hypot(*(a - b for a, b in zip(direction, theirs[point]))), 1e-3, point)

    def test_each_channel_of_a_link_is_decoded_alone(self):
        data = self.extracted("ball", "--iso", 100, "--iso", 50)
        for channel in (0, 1):
            with self.subTest(channel=channel):
                self.assertGreater(self.compare(data, channel).foreign, 0)

    def test_slices_have_the_thresholded_samples(self):
        for name, options, thresholds in streams.SLICES:
            with self.subTest(volume=name, options=options):
                stream = self.compare(self.extracted(name, *options))
                samples = streams.VOLUMES[name][2]()
                for threshold, surface in zip(thresholds, stream.rows.surfaces):
                    bits = [voxel for row in surface.rows for voxel in row[1:-1]]
                    self.assertEqual(bits, [int(s >= threshold) for s in samples])

    def encoded_fractions(self, name, is_open, levels, interval, thresholds):
        width, height, samples = streams.VOLUMES[name]
        arguments = width, height, is_open, levels, interval, *thresholds
        return subprocess.run([ENCODER, *map(str, arguments)], input=bytes(samples()), capture_output=True,
                              check=True).stdout

    def test_fractions_are_those_of_the_samples(self):
        for case in streams.FRACTIONS:
            name, _, levels, _, thresholds = case
            with self.subTest(case=case):
                stream = self.compare(self.encoded_fractions(*case))
                width, height, samples = streams.VOLUMES[name]
                for threshold, surface in zip(thresholds, stream.rows.surfaces):
                    self.compare_fractions(surface.fractions, samples(), threshold, levels, (1, width, width * height))

    def test_fractions_are_lost_with_their_rows(self):
        """Section 15: a key slice after a loss has a count of fractions whose places are unknown."""
        frames = streams.frames(self.encoded_fractions("noise", 0, 4, 2, (128,)))
        for lost in range(1, len(frames) - 1):
            with self.subTest(lost=lost):
                stream = self.compare(b"".join(frames[:lost] + frames[lost + 1:]))
                self.assertGreater(stream.lost("rows"), 0)

    def compare_fractions(self, fractions, samples, threshold, levels, steps):
        for axis, step in enumerate(steps):
            mine = [f for row in fractions.rows for f in row[axis][1:-1]]
            next_step = steps[axis + 1] if axis < 2 else len(samples)
            theirs = [streams.fraction_of(samples, i - step, i, threshold, levels, axis == 2)
                      if i % next_step >= step else 0 for i in range(len(samples))]
            self.assertEqual(mine, theirs, "xyz"[axis])

    def test_recorded_streams_have_no_losses(self):
        files = sorted((PROJECT / "tests/support/golden").glob("*.dmc"))
        self.assertGreater(len(files), 7)
        for file in files:
            with self.subTest(file=file.name):
                stream = self.compare(file.read_bytes())
                self.assertEqual(stream.losses, [])
                if stream.rows:
                    skipped = sum(kind in (OFF, REPEATED) for kind in stream.rows.kinds)
                else:
                    skipped = sum(isinstance(e, Skipped) for e in stream.events)
                self.assertEqual(skipped, stream.trailer.totals["skipped_rows"])

    def test_streams_of_the_document_are_decoded(self):
        """Sections 13 and 14."""
        for kind in ("hex", "slices"):
            with self.subTest(kind=kind):
                self.compare(streams.of_document(PROJECT / "lib/WIRE.md", kind))

    def test_the_symbols_of_a_payload_give_its_bytes(self):
        """Section 6."""
        data = self.extracted("noise", "--iso", 60, "--memory", "4K", "--normals", "gradient")
        payloads = [bytes(body[4:-3]) for body in streams.bodies(data) if body[0] == RECORDS]
        self.assertGreater(len(payloads), 10)
        for payload in payloads:
            self.assertEqual(RangeEncoder.encoded(streams.calls_of(payload)), payload)

    def test_damaged_streams_have_the_losses_of_the_command(self):
        for name, options, seeds in streams.DAMAGED:
            data = self.extracted(name, *options)
            for seed in range(seeds):
                with self.subTest(volume=name, options=options, seed=seed):
                    self.compare(streams.damaged(data, random.Random(seed)))

    def test_rows_before_a_lost_packet_remain(self):
        """Section 14: of a code whose packet is lost, the rows before the loss remain."""
        for name in ("slices_long", "slices_noise"):
            frames = streams.frames((PROJECT / f"tests/support/golden/{name}.dmc").read_bytes())
            for lost in range(2, len(frames) - 1, 2):
                with self.subTest(file=name, lost=lost):
                    data, file = b"".join(frames[:lost] + frames[lost + 1:]), self.folder / "stream.dmc"
                    file.write_bytes(data)
                    stream = decoded(data)
                    self.assertEqual(str(stream.lost("rows")), facts_of_command(file)["lost_rows"])

    def test_streams_of_a_later_version_are_decoded(self):
        """Section 11: longer headers and trailers, a new kind of packet, an unknown extension."""
        for options in ((), ("--wire", "slices")):
            with self.subTest(options=options):
                stream = self.compare(streams.of_later_version(self.extracted("ball", "--iso", 100, *options)))
                self.assertFalse(stream.is_mixed)

    def test_a_payload_that_no_encoder_wrote_is_damaged(self):
        data = streams.with_wrong_payload(self.extracted("noise", "--iso", 128))
        self.assertEqual(len(self.compare(data).damaged), 1)

    def test_inputs_that_are_no_streams_are_refused(self):
        """Inputs that are no streams: the command refuses them, the decoder finds no header that it supports."""
        for file in sorted((PROJECT / "fuzz/corpus/wire_decode").iterdir()):
            with self.subTest(file=file.name):
                message = discmc("info", file, codes=(1,))
                if "stream version" in message:
                    with self.assertRaises(WrongVersion):
                        decoded(file.read_bytes())
                else:
                    self.assertIsNone(decoded(file.read_bytes()).header)


if __name__ == "__main__":
    COMMAND, ENCODER = sys.argv.pop(1), sys.argv.pop(1)
    unittest.main()
