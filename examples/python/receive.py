"""Receives the scans of a device from a serial port, and writes a mesh for each.

usage: receive.py PORT [FOLDER]
With pyserial, replace open_port() by serial.Serial(port, 921600), and read(4096) by
read(max(1, link.in_waiting)).
"""

import sys
import termios
import tty
from pathlib import Path

import discmc


def open_port(port):
    link = open(port, "rb", buffering=0)
    if link.isatty():
        tty.setraw(link, termios.TCSANOW)  # bytes as they are, also those that wait
    return link


def receive(link):
    """Yields scans until the link ends."""
    decoder = discmc.Decoder(normals="surface")
    try:
        while data := link.read(4096):
            yield from decoder.feed(data)
            print(decoder.polygon_count, "polygons so far", end="\r", file=sys.stderr)
    except OSError:  # the other end of a terminal is closed
        pass
    if scan := decoder.finish():
        yield scan


def main(port, folder="."):
    with open_port(port) as link:
        for number, scan in enumerate(receive(link)):
            file = Path(folder) / f"scan{number}.stl"
            scan.mesh.write(file)
            lost = scan.report.lost_packets + scan.report.lost_rows
            state = "complete" if scan.report.is_complete else f"incomplete, {lost} packets or rows are lost"
            print(f"{file}: {len(scan.mesh.faces)} triangles, {state}")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(*sys.argv[1:])
