#!/usr/bin/env python3
"""write_pictures.py FOLDER: writes the pictures of image_stack_test.cpp and tiff_volume_test.cpp, by Pillow and tifffile.

On Debian: python3-pil, python3-tifffile and python3-numpy. The volume is 8 by 6 by 12 voxels; the
test knows its values by the same formula.
"""
import itertools
import pathlib
import sys

import numpy
import PIL.Image
import tifffile

WIDTH, HEIGHT, DEPTH = 8, 6, 12

z, y, x = numpy.meshgrid(range(DEPTH), range(HEIGHT), range(WIDTH), indexing="ij")
volume = (x * 7919 + y * 1047 + z * 12997) % 4001 - 2000  # [z, y, x]


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    u8 = (volume % 251).astype(numpy.uint8)
    u16 = (volume + 2000).astype(numpy.uint16)
    stack = folder / "stack"
    stack.mkdir(exist_ok=True)
    for k in range(DEPTH):
        # slice0 to slice11: 10 follows 9, not 1.
        PIL.Image.fromarray(u16[k]).save(stack / f"slice{k}.png")
    PIL.Image.fromarray(u8[0]).save(folder / "u8.png")
    PIL.Image.fromarray(u8[0]).convert("RGB").save(folder / "rgb.png")
    PIL.Image.fromarray(u8[0]).convert("LA").save(folder / "alpha.png")
    PIL.Image.fromarray(u8[0]).convert("P").save(folder / "palette.png")
    PIL.Image.fromarray((u8[0] % 2 * 255).astype(numpy.uint8)).convert("1").save(folder / "bits.png")
    for name, samples in ("u8", u8), ("u16", u16), ("f32", (volume / 4).astype(numpy.float32)):
        tifffile.imwrite(folder / f"{name}.tif", samples[:5], photometric="minisblack",
                         metadata=None)
    tifffile.imwrite(folder / "big-endian.tif", u16[:5], photometric="minisblack", byteorder=">",
                     metadata=None)
    tifffile.imwrite(folder / "tiles.tif", u16[:5], photometric="minisblack", tile=(16, 16),
                     metadata=None)
    tifffile.imwrite(folder / "deflate.tif", u16[:5], photometric="minisblack", rowsperstrip=4,
                     compression="zlib", predictor=True, metadata=None)
    tifffile.imwrite(folder / "imagej.tif", u16[:5], imagej=True, resolution=(2, 4),
                     metadata={"spacing": 2.5, "unit": "mm", "axes": "ZYX"})
    tifffile.imwrite(folder / "rgb.tif", numpy.stack([u8[0]] * 3, axis=-1), photometric="rgb",
                     metadata=None)
    write_other_kinds(folder, u8)
    write_hyperstacks(folder, u8)


def write_other_kinds(folder, u8):
    picture = PIL.Image.fromarray(u8[0])
    colours = PIL.Image.merge("RGB", [PIL.Image.fromarray(u8[i]) for i in range(3)])
    for kind in "bmp", "jpg":
        picture.save(folder / f"u8.{kind}", quality=100)
        colours.save(folder / f"colours.{kind}", quality=100, subsampling=0)
    colours.save(folder / "colours.png")
    planes = numpy.stack([u8[i] for i in range(3)])
    tifffile.imwrite(folder / "colours.tif", numpy.moveaxis(planes, 0, -1), photometric="rgb",
                     metadata=None)
    tifffile.imwrite(folder / "planar-colours.tif", planes, photometric="rgb",
                     planarconfig="separate", metadata=None)
    tifffile.imwrite(folder / "f16.tif", (volume[:5] / 4).astype(numpy.float16),
                     photometric="minisblack", metadata=None)
    tifffile.imwrite(folder / "bilevel.tif", u8[:5] % 2 == 1, photometric="minisblack",
                     metadata=None)
    reds = numpy.zeros((3, 256), numpy.uint16)
    reds[0] = numpy.arange(256) * 257
    tifffile.imwrite(folder / "palette.tif", u8[:5], photometric="palette", colormap=reds,
                     metadata=None)
    for depth in 1, 4:
        tifffile.imwrite(folder / f"deep-tiles{depth}.tif", u8[:5], photometric="minisblack",
                         volumetric=True, tile=(depth, 16, 16), compression="zlib")
    tifffile.imwrite(folder / "deep-strips.tif", u8[:5], photometric="minisblack", volumetric=True)
    tifffile.imwrite(folder / "one-directory.tif", u8[:5], photometric="minisblack", truncate=True)


def write_hyperstacks(folder, u8):
    """The 12 slices are 2 times with 2 channels of 3 slices."""
    stack = u8.reshape(2, 2, 3, HEIGHT, WIDTH)  # [t, c, z, y, x]
    for axes in map("".join, itertools.permutations("TCZ")):
        sorted_stack = stack.transpose(*("TCZ".index(axis) for axis in axes), 3, 4)
        tifffile.imwrite(folder / f"hyperstack-{axes.lower()}.ome.tif", sorted_stack,
                         photometric="minisblack",
                         metadata={"axes": axes + "YX", "Channel": {"Name": ["bone", "dye"]},
                                   "PhysicalSizeX": 2.5, "PhysicalSizeXUnit": "\u00b5m",
                                   "PhysicalSizeY": 500, "PhysicalSizeYUnit": "nm",
                                   "PhysicalSizeZ": 0.5, "PhysicalSizeZUnit": "cm"})
    tifffile.imwrite(folder / "hyperstack-imagej.tif", stack.transpose(0, 2, 1, 3, 4), imagej=True,
                     resolution=(2, 4),
                     metadata={"axes": "TZCYX", "spacing": 2.5, "unit": "um"})
    tifffile.imwrite(folder / "hyperstack-shaped.tif", stack, photometric="minisblack",
                     metadata={"axes": "TCZYX"})


main(pathlib.Path(sys.argv[1]))
