import os
import signal
import threading

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


@pytest.mark.parametrize("threads", [1, 2])
def test_control_c_ends_a_call_during_which_threads_run(threads):
    begun = threading.Event()

    def press():
        begun.wait()
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=press)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        begun.set()
        discmc.extract(endless(), 1, threads=threads)
    thread.join()


def test_a_call_in_another_thread_leaves_signals_to_the_main_thread(ball):
    found = []
    thread = threading.Thread(target=lambda: found.append(discmc.extract(ball, 100)))
    thread.start()
    thread.join()
    assert len(found[0].faces) > 0
