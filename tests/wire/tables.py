"""The tables of the format, read from lib/WIRE.md and the two files that it names."""

import re
from pathlib import Path

LIBRARY = Path(__file__).resolve().parents[2] / "lib"


def numbers(file, name):
    text = re.sub("//.*", "", (LIBRARY / "discmc" / file).read_text())
    body = text[text.index("{", text.index(name)):]
    return [int(n) for n in re.findall(r"\d+", body[:body.index("};")])]


# Section 7.
FREQUENCIES = numbers("stream/frequencies.cpp", "cumulative_frequencies[")
# Section 14: for the contexts 1 to 272.
_trained = numbers("slices/slice_model.cpp", "trained[")
KEY_SLICES, OTHER_SLICES = _trained[:272], _trained[272:]


def context(first, symbols):
    """Section 7: below(0) to below(symbols) of the context that begins with this number."""
    return [0] + [n or 256 for n in FREQUENCIES[first + 1:first + symbols]] + [256]


# Section 10: code of the incidence -> its directions.
DIRECTIONS = {
    int(code): [tuple(map(int, vector.split())) for vector in vectors.split(",")]
    for code, vectors in re.findall(r"^\| (\d+) \| [-01 ]+ \| ([-0-9 ,]+) \|$",
                                    (LIBRARY / "WIRE.md").read_text(), re.MULTILINE)}


def normal(incidence):
    """Section 10."""
    return tuple(incidence // 3 ** axis % 3 - 1 for axis in range(3))
