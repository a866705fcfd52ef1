"""Writes files of volumes of any size for the command."""
import json
import os
import struct
import zipfile
import zlib


def write(path, *parts):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'wb') as file:
        for part in parts:
            file.write(part.encode() if isinstance(part, str) else part)
    return path


def nrrd(path, dims, data, encoding='raw', fields=''):
    sizes = ' '.join(map(str, dims))
    return write(path, f'NRRD0004\ntype: uint8\ndimension: {len(dims)}\nsizes: {sizes}\nencoding: {encoding}\n{fields}\n',
                 data)


def png(width, rows):
    """rows: of grey samples."""
    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', width, len(rows), 8, 0, 0, 0, 0)) +
            chunk(b'IDAT', zlib.compress(b''.join(b'\0' + row for row in rows))) + chunk(b'IEND', b''))


def tiff(width, height, pages, description=''):
    """pages: the samples of each page."""
    bytes_of = bytearray(b'II*\0\x08\0\0\0')
    for number, samples in enumerate(pages):
        text = description.encode() + b'\0' if number == 0 and description else b''
        tags = [(256, 3, 1, width), (257, 3, 1, height), (258, 3, 1, 8), (259, 3, 1, 1), (262, 3, 1, 1)]
        begin = len(bytes_of)
        count = len(tags) + 3 + (1 if text else 0)
        data = begin + 2 + 12 * count + 4
        if text:
            tags.append((270, 2, len(text), data))
        tags += [(273, 4, 1, data + len(text)), (278, 3, 1, height), (279, 4, 1, width * height)]
        end = data + len(text) + len(samples)
        bytes_of += struct.pack('<H', count)
        for tag in tags:
            bytes_of += struct.pack('<HHII', *tag)
        bytes_of += struct.pack('<I', end + end % 2 if number + 1 < len(pages) else 0)
        bytes_of += text + samples + b'\0' * (end % 2)
    return bytes(bytes_of)


def dicom(elements):
    """elements: (group, element, VR, value), in order. The value of a sequence is a list of items."""
    def element(group, number, vr, value):
        if isinstance(value, list):
            value = b''.join(struct.pack('<HHI', 0xFFFE, 0xE000, len(item)) + item
                             for item in (dataset(each) for each in value))
        if isinstance(value, str):
            value = value.encode()
        elif isinstance(value, int):
            value = struct.pack('<H' if vr == 'US' else '<I', value)
        value += (b'\0' if vr in ('UI', 'OB', 'OW') else b' ') * (len(value) % 2)
        head = struct.pack('<HH', group, number) + vr.encode()
        is_long = vr in ('OB', 'OW', 'SQ', 'UN', 'UT')
        return head + (struct.pack('<HI', 0, len(value)) if is_long else struct.pack('<H', len(value))) + value

    def dataset(some):
        return b''.join(element(*each) for each in some)
    meta = dataset([(2, 1, 'OB', b'\0\1'), (2, 2, 'UI', '1.2.840.10008.5.1.4.1.1.2'), (2, 3, 'UI', '1.2.3'),
                    (2, 0x10, 'UI', '1.2.840.10008.1.2.1')])
    return b'\0' * 128 + b'DICM' + dataset([(2, 0, 'UL', len(meta))]) + meta + dataset(elements)


def ct_slice(number, series='1.2.3.4', pixels=bytes(128), more=()):
    """A slice of 8 x 8 samples of 16 bits."""
    return dicom(sorted([
        (8, 0x16, 'UI', '1.2.840.10008.5.1.4.1.1.2'), (8, 0x18, 'UI', f'1.2.3.5.{number}'), (8, 0x60, 'CS', 'CT'),
        (0x20, 0xD, 'UI', '1.2.3'), (0x20, 0xE, 'UI', series), (0x20, 0x13, 'IS', str(number)),
        (0x20, 0x32, 'DS', f'0\\0\\{number}'), (0x20, 0x37, 'DS', '1\\0\\0\\0\\1\\0'), (0x28, 2, 'US', 1),
        (0x28, 4, 'CS', 'MONOCHROME2'), (0x28, 0x10, 'US', 8), (0x28, 0x11, 'US', 8), (0x28, 0x30, 'DS', '1\\1'),
        (0x28, 0x100, 'US', 16), (0x28, 0x101, 'US', 16), (0x28, 0x102, 'US', 15), (0x28, 0x103, 'US', 0),
        (0x7FE0, 0x10, 'OW', pixels), *more]))


def zarr(folder, shape, chunks, data=None):
    description = {'zarr_format': 2, 'shape': shape, 'chunks': chunks, 'dtype': '|u1', 'compressor': None,
                   'fill_value': 0, 'order': 'C', 'filters': None}
    write(os.path.join(folder, '.zarray'), json.dumps(description))
    count = [-(-of // by) for of, by in zip(shape, chunks)]
    size = chunks[0] * chunks[1] * chunks[2]
    for z in range(count[0]):
        for y in range(count[1]):
            for x in range(count[2]):
                write(os.path.join(folder, f'{z}.{y}.{x}'), bytes(size - 1) + b'\1')
    return folder


def zipped(path, members):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with zipfile.ZipFile(path, 'w') as archive:
        for name, data in members:
            archive.writestr(name, data)
    return path
