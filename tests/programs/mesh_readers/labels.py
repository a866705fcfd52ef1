"""Writes a label volume of four touching balls. usage: labels.py OUTPUT.npy"""
import sys

import numpy

z, y, x = numpy.ogrid[:50, :50, :50]
centres = [(15, 20, 25), (35, 20, 25), (25, 36, 20), (25, 28, 38)]
squares = numpy.stack([(x - a) ** 2 + (y - b) ** 2 + (z - c) ** 2 for a, b, c in centres])
labels = numpy.where(squares.min(0) < 180, squares.argmin(0) + 1, 0)
numpy.save(sys.argv[1], labels.astype(numpy.uint8))
