"""The Python code of the guide and the examples run."""

import os
import pty
import re
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest
from conftest import ball_of

import discmc
from discmc import _discmc

PROJECT = Path(__file__).resolve().parents[3]
EXAMPLES = PROJECT / "examples" / "python"


def write_nrrd(file):
    volume = (3 * ball_of()).astype(np.int16)
    header = (
        "NRRD0004\ntype: int16\ndimension: 3\nsizes: 28 26 24\nendian: little\nencoding: raw\n"
        "space: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,2)\n"
        "space origin: (5,6,7)\n\n")
    file.write_bytes(header.encode() + volume.tobytes())


@pytest.mark.parametrize("page", ["docs/python.md", "README.md"])
def test_blocks_of_a_page_run_in_their_order(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_nrrd(tmp_path / "head.nrrd")
    blocks = re.findall(r"^```python\n(.*?)^```", (PROJECT / page).read_text(), re.DOTALL | re.MULTILINE)
    assert blocks
    names = {}
    for block in blocks:
        if "discmc.read(" in block and not _discmc.has_files:
            continue
        exec(compile(block, page, "exec"), names)


def test_the_receiver_of_the_guide_writes_the_scan(tmp_path):
    images = ball_of().clip(0, 255).astype(np.uint8)
    stream = b""
    for number in range(2):
        device = discmc.Extractor(28, 26, 100, memory=1 << 16, encode=True, scan=number)
        device.push(images)
        device.finish()
        stream += device.encoded()
    device_end, port = pty.openpty()
    receiver = subprocess.Popen(
        [sys.executable, "-u", EXAMPLES / "receive.py", os.ttyname(port), tmp_path], stdout=subprocess.PIPE, text=True)

    def send():
        # Raw before the first byte, whichever process comes first.
        import tty

        tty.setraw(port)
        for at in range(0, len(stream), 512):
            os.write(device_end, stream[at : at + 512])

    sender = threading.Thread(target=send)
    sender.start()
    lines = [line for _, line in zip(range(2), receiver.stdout)]
    sender.join()
    os.close(device_end)
    os.close(port)
    receiver.stdout.close()
    assert receiver.wait() == 0
    assert all("complete" in line and "incomplete" not in line for line in lines), lines
    assert {file.name for file in tmp_path.iterdir()} == {"scan0.stl", "scan1.stl"}


def test_the_picture_of_the_guide_is_written(tmp_path):
    pytest.importorskip("matplotlib")
    np.save(tmp_path / "ball.npy", ball_of())
    subprocess.run(
        [sys.executable, EXAMPLES / "show.py", tmp_path / "ball.npy", "100", tmp_path / "ball.png"], check=True)
    assert (tmp_path / "ball.png").read_bytes().startswith(b"\x89PNG")
