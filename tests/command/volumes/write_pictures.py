#!/usr/bin/env python3
"""write_pictures.py FOLDER: writes the PNG and TIFF files of image_stack_test.cpp, by Pillow and tifffile.

On Debian: python3-pil, python3-tifffile and python3-numpy. The volume is 8 by 6 by 12 voxels; the
test knows its values by the same formula.
"""
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
        # slice0 to slice11: 10 comes after 9, not after 1.
        PIL.Image.fromarray(u16[k]).save(stack / f"slice{k}.png")
    PIL.Image.fromarray(u8[0]).save(folder / "u8.png")
    PIL.Image.fromarray(u8[0]).convert("RGB").save(folder / "rgb.png")
    PIL.Image.fromarray(u8[0]).convert("LA").save(folder / "alpha.png")
    PIL.Image.fromarray(u8[0]).convert("P").save(folder / "palette.png")
    PIL.Image.fromarray((u8[0] % 2 * 255).astype(numpy.uint8)).convert("1").save(folder / "bits.png")
    types = {"u8": u8, "u16": u16, "i16": volume.astype(numpy.int16),
             "i32": (volume * 70000).astype(numpy.int32),
             "u32": ((volume + 2000) * 70000).astype(numpy.uint32),
             "f32": (volume / 4).astype(numpy.float32), "f64": volume / 10}
    for name, samples in types.items():
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


main(pathlib.Path(sys.argv[1]))
