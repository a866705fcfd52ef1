"""Encodes a mesh of discmc with the codec of meshoptimizer.

usage: encoded_mesh.py MESH.ply > FILE; `discmc extract --spacing 2` writes such a mesh, whose coordinates are whole
half-steps. Triangles and vertices are put into the order that the codec codes best. scripts/tools/bench-bits runs this.
"""

import ctypes
import struct
import sys

codec = ctypes.CDLL('libmeshoptimizer.so')
for function in (codec.meshopt_optimizeVertexFetch, codec.meshopt_encodeVertexBuffer, codec.meshopt_encodeIndexBuffer,
                 codec.meshopt_encodeVertexBufferBound, codec.meshopt_encodeIndexBufferBound):
    function.restype = ctypes.c_size_t


def size(number):
    return ctypes.c_size_t(number)


def read_ply(path):
    """Returns the vertices, as four half-steps each, and the triangles, in arrays for the codec."""
    with open(path, 'rb') as file:
        header, _, rows = file.read().partition(b'end_header\n')
    vertices, faces = (int(line.split()[2]) for line in header.splitlines() if line.startswith(b'element'))
    points = [(int(x), int(y), int(z)) for x, y, z in struct.iter_unpack('<3f', rows[:12 * vertices])]
    low = [min(along) for along in zip(*points)]
    corners = struct.iter_unpack('<B3I', rows[12 * vertices:])
    return ((ctypes.c_uint16 * (4 * vertices))(*(at - least for point in points
                                                 for at, least in zip((*point, 0), (*low, 0)))),
            (ctypes.c_uint32 * (3 * faces))(*(number for face in corners for number in face[1:])))


def encoded(encode, bound, *source):
    """source: the codec's input, after its output buffer."""
    buffer = ctypes.create_string_buffer(bound)
    length = encode(buffer, size(bound), *source)
    return buffer.raw[:length]


vertices, triangles = read_ply(sys.argv[1])
count, vertex_bytes = size(len(vertices) // 4), size(8)
codec.meshopt_optimizeVertexCacheStrip(triangles, triangles, size(len(triangles)), count)
codec.meshopt_optimizeVertexFetch(vertices, triangles, size(len(triangles)), vertices, count, vertex_bytes)
sys.stdout.buffer.write(
    encoded(codec.meshopt_encodeVertexBuffer, codec.meshopt_encodeVertexBufferBound(count, vertex_bytes), vertices,
            count, vertex_bytes) +
    encoded(codec.meshopt_encodeIndexBuffer, codec.meshopt_encodeIndexBufferBound(size(len(triangles)), count),
            triangles, size(len(triangles))))
