import os
import signal
import sys
import threading
import time
from contextlib import contextmanager

import numpy as np
import pytest

import discmc


def endless():
    """A volume that takes minutes, of one slice of memory."""
    return np.broadcast_to(np.eye(512, dtype=np.uint8), (1 << 17, 512, 512))


@pytest.fixture(autouse=True)
def python_handles_signals():
    """Shells start programs in the background without."""
    handler = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, handler)


@contextmanager
def control_c():
    """Presses Ctrl-C from another thread, which has to interrupt the body."""
    begun = threading.Event()

    def press():
        begun.wait()
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=press)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        begun.set()
        yield
    thread.join()


@pytest.mark.parametrize("threads", [1, 2])
def test_control_c_ends_a_call_during_which_threads_run(threads):
    with control_c():
        discmc.extract(endless(), 1, threads=threads)


def noise(slices, size):
    return np.random.default_rng(1).integers(0, 2, (slices, size, size), dtype=np.uint8)


@pytest.fixture
def threads_switch_only_in_calls():
    """Another thread runs only if a call releases the interpreter."""
    seconds = sys.getswitchinterval()
    sys.setswitchinterval(1000)
    yield
    sys.setswitchinterval(seconds)


@pytest.fixture
def stream():
    scanner = discmc.Extractor(64, 64, 1, memory=1 << 24, encode=True)
    scanner.push(noise(64, 64))
    return scanner.encoded()


def test_control_c_ends_the_mesh_of_a_decoder(threads_switch_only_in_calls, stream):
    decoder = discmc.Decoder(triangles=100)
    decoder.feed(stream)
    meshes = []
    with control_c():
        meshes.append(decoder.mesh())
    assert not meshes
    assert decoder.polygon_count > 0


def test_other_threads_run_while_a_decoder_receives(threads_switch_only_in_calls, stream):
    has_begun, has_ended = threading.Event(), threading.Event()
    turns = [0]

    def run():
        has_begun.set()
        while not has_ended.is_set():
            turns[0] += 1
            time.sleep(0)

    thread = threading.Thread(target=run)
    thread.start()
    has_begun.wait()
    decoder, before = discmc.Decoder(), turns[0]
    decoder.feed(stream)
    after = turns[0]
    has_ended.set()
    thread.join()
    assert after > before


def test_threads_may_share_an_extractor():
    samples = noise(6, 400)
    scanner = discmc.Extractor(400, 400, 1, memory=1 << 24, encode=True)
    has_ended = threading.Event()
    polygons, stream = [], []

    def take():
        polygons.extend(scanner.polygons())
        stream.append(scanner.encoded())

    def look():
        while not has_ended.is_set():
            take()

    thread = threading.Thread(target=look)
    thread.start()
    scanner.push(samples)
    has_ended.set()
    thread.join()
    scanner.finish()
    take()
    assert len(polygons) == scanner.statistics.regions > 0
    [scan] = discmc.Decoder().feed(b"".join(stream))
    assert scan.report.is_complete


def test_two_threads_push_one_after_the_other():
    scanner = discmc.Extractor(400, 400, 1, memory=1 << 24)
    threads = [threading.Thread(target=scanner.push, args=(noise(6, 400),)) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert scanner.slices == 12


def test_a_call_in_another_thread_leaves_signals_to_the_main_thread(ball):
    found = []
    thread = threading.Thread(target=lambda: found.append(discmc.extract(ball, 100)))
    thread.start()
    thread.join()
    assert len(found[0].faces) > 0
