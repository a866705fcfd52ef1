import numpy as np
import pytest
from conftest import ball_of

import discmc

WIDTH, HEIGHT = 28, 26


@pytest.fixture
def images():
    return ball_of().clip(0, 255).astype(np.uint8)


def scanner(memory=1 << 16, **options):
    return discmc.Extractor(WIDTH, HEIGHT, 100, memory=memory, **options)


def encoded(images, **options):
    extractor = scanner(encode=True, **options)
    extractor.push(images)
    extractor.finish()
    return extractor.encoded()


def area_of(outlines):
    area = 0
    for normal, rings in outlines:
        for ring in rings:
            area += np.cross(ring, np.roll(ring, -1, 0)).sum(0) @ normal / np.linalg.norm(normal) / 2
    return area


@pytest.mark.parametrize("dtype", ["u1", "u2", "i2"])
@pytest.mark.parametrize("index_bits", [16, 32])
def test_polygons_come_while_the_scan_runs(images, dtype, index_bits):
    extractor = scanner(index_bits=index_bits)
    outlines, counts = [], []
    for image in images.astype(dtype):
        extractor.push(image)
        counts.append(len(outlines))
        outlines += extractor.polygons()
    extractor.finish()
    outlines += extractor.polygons()
    assert extractor.polygons() == []
    assert 0 < counts[12] < len(outlines) == extractor.statistics.regions
    assert extractor.slices == len(images) and extractor.rows == 0
    mesh = discmc.extract(images, 100)
    assert area_of(outlines) == pytest.approx(mesh.area)
    corners = np.concatenate([ring for _, rings in outlines for ring in rings])
    assert {tuple(point[::-1]) for point in corners} == {tuple(point) for point in mesh.vertices}


def test_memory_bounds_the_scan(images):
    least = discmc.Extractor.minimum_memory(WIDTH, HEIGHT)
    extractor = scanner(least)
    extractor.push(images)
    extractor.finish()
    assert extractor.statistics.fragments > 0 and extractor.bytes_used <= least
    assert scanner().statistics.slots > extractor.statistics.slots
    with pytest.raises(ValueError, match=f"{least - 1} bytes.*at least {least}"):
        scanner(least - 1)


def test_rows_may_be_parts_and_may_be_missing(images):
    extractor = scanner()
    extractor.push(images[0, 0, :5])
    extractor.push(images[0, 0, 5:])
    extractor.skip_row()
    extractor.skip_row(repeat=True)
    assert extractor.rows == 3 and extractor.statistics.skipped_rows == 2
    with pytest.raises(ValueError, match="incomplete"):
        extractor.finish()
    extractor.abandon()
    with pytest.raises(ValueError, match="has ended"):
        extractor.push(images[0])


def test_wrong_settings_are_refused(images):
    with pytest.raises(ValueError, match="1 to 32766"):
        discmc.Extractor(0, 5, 1, memory=1000)
    with pytest.raises(ValueError, match="index_bits is 8; expected 16 or 32"):
        scanner(index_bits=8)
    with pytest.raises(TypeError, match="float64.*uint8"):
        scanner().push(images.astype(float))
    with pytest.raises(ValueError, match="rows of .*the last axis along x"):
        scanner().push(np.zeros((WIDTH, HEIGHT), np.uint8))
    with pytest.raises(ValueError, match="encode=True"):
        scanner().encoded()
    with pytest.raises(ValueError, match="spacing is .*; give at most 2147"):
        scanner(encode=True, spacing=(5000, 1, 1))


def test_a_decoder_relaxes_without_samples(images):
    stream = encoded(images)
    (merged,) = discmc.Decoder().feed(stream)
    (relaxed,) = discmc.Decoder(relax=True, tolerance=0).feed(stream)
    assert relaxed.mesh.area < merged.mesh.area
    assert len(relaxed.mesh.vertices) > len(merged.mesh.vertices)
    with pytest.raises(ValueError, match="no fractions"):
        discmc.Decoder(interpolate=True).feed(stream)


@pytest.mark.parametrize("size", [1, 7, 1 << 20])
def test_a_decoder_receives_scan_after_scan(images, size):
    stream = encoded(images, spacing=(1, 2, 3), scan=5) + encoded(images[:, ::-1], scan=6)
    decoder = discmc.Decoder()
    scans = []
    for at in range(0, len(stream), size):
        scans += decoder.feed(stream[at : at + size])
    first, second = scans
    assert first.report.is_complete and second.report.is_complete
    assert (first.header.scan, second.header.scan) == (5, 6)
    assert first.header.spacing == (1, 2, 3) and first.header.level == 100
    expected = discmc.extract(images.T, 100, spacing=(1, 2, 3))
    assert first.mesh.volume == pytest.approx(expected.volume)
    assert first.mesh.bounds.tolist() == expected.bounds.tolist()
    assert decoder.finish() is None


def test_fragments_are_joined(images):
    stream = encoded(images, memory=discmc.Extractor.minimum_memory(WIDTH, HEIGHT))
    (scan,) = discmc.Decoder().feed(stream)
    assert scan.report.fragments > 0 and scan.mesh.is_closed
    assert scan.header.spacing == (0, 0, 0)
    assert scan.mesh.volume == pytest.approx(discmc.extract(images.T, 100).volume)


def test_a_decoder_gives_the_mesh_so_far_and_what_is_missing(images):
    stream = encoded(images)
    decoder = discmc.Decoder(polygons=True)
    assert decoder.header is None and len(decoder.mesh().faces) == 0
    decoder.feed(stream[: len(stream) // 2])
    assert 0 < decoder.polygon_count == len(decoder.polygons)
    assert not decoder.mesh().is_closed
    at = 3 * len(stream) // 4
    decoder.feed(stream[at:-30])
    scan = decoder.finish()
    assert not scan.report.is_complete and not scan.report.has_trailer
    assert scan.report.lost_packets > 0 and len(scan.mesh.faces) > 0
    assert decoder.finish() is None


def test_any_bytes_are_safe():
    noise = np.random.default_rng(1).integers(0, 256, 1 << 16, dtype=np.uint8)
    decoder = discmc.Decoder()
    assert decoder.feed(bytearray(noise)) == []
    assert decoder.report.damaged_packets > 0
    with pytest.raises(ValueError, match="polygons=True"):
        decoder.polygons
