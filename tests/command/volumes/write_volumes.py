#!/usr/bin/python3
"""Writes one small volume in every container, sample type and byte order, with programs that have
nothing to do with discmc. The files are committed; the test container_table reads all of them.

Run it again only to add files:   /usr/bin/python3 tests/command/volumes/write_volumes.py
On Debian it needs python3-h5py, python3-mrcfile, python3-nibabel, python3-numpy, python3-tifffile,
python3-vtk9, python3-zarr and teem-apps.

A file is CONTAINER/TYPE-ORDER[-HOW].EXTENSION. The volume has 5 x 3 x 4 voxels of 0.5 x 0.75 x 2 mm
at (10, -20, 30.5), and the samples of sample_at() in volume_files.hpp. In a file of two volumes
("frame1") the first one is zero.
"""
import io
import json
import pathlib
import plistlib
import subprocess
import tarfile

import h5py
import mrcfile
import nibabel
import numcodecs
import numpy
import tifffile
import zarr
from vtkmodules import vtkIOImage, vtkIOLegacy, vtkIOXML
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonDataModel import vtkImageData

HERE = pathlib.Path(__file__).parent
SPACING = (0.5, 0.75, 2.0)
ORIGIN = (10.0, -20.0, 30.5)
SIZES = (5, 3, 4)  # x, y, z

TYPES = {
    'u8': ('uint8', lambda i: i * 4),
    'i8': ('int8', lambda i: i * 2 - 60),
    'u16': ('uint16', lambda i: i * 1000 + 7),
    'i16': ('int16', lambda i: i * 1000 - 30000),
    'u32': ('uint32', lambda i: i * 70000000 + 1),
    'i32': ('int32', lambda i: i * 70000000 - 2000000000),
    'u64': ('uint64', lambda i: i * 3 * 10**17),
    'i64': ('int64', lambda i: i * 3 * 10**17 - 9 * 10**18),
    'f32': ('float32', lambda i: i * 0.25 - 7.5),
    'f64': ('float64', lambda i: i * 0.1 - 3),
}


def samples(name):
    """Returns the volume as array[z][y][x], little-endian."""
    dtype, value = TYPES[name]
    flat = numpy.array([value(i) for i in range(60)], dtype=numpy.dtype(dtype).newbyteorder('<'))
    return flat.reshape(SIZES[::-1])


def orders(name):
    return ['little'] if name in ('u8', 'i8') else ['little', 'big']


def ordered_samples():
    """Returns all types and byte orders, with the volume."""
    return [(name, order, in_order(samples(name), order)) for name in TYPES for order in orders(name)]


def in_order(array, order):
    return array.astype(array.dtype.newbyteorder('>' if order == 'big' else '<'))


def path(container, name):
    folder = HERE / container
    folder.mkdir(exist_ok=True)
    return folder / name


def two_frames(array):
    return numpy.stack([numpy.zeros_like(array), array])


# NRRD, by unu of Teem. It has its own names for types.
def unu(array, name, order, encoding, target, form='nrrd'):
    sizes = [str(size) for size in array.shape[::-1]]
    axes = len(sizes)
    spacing = [str(length) for length in SPACING] + ['1'] * (axes - 3)
    teem = {'u64': 'ulonglong', 'i64': 'longlong', 'f32': 'float', 'f64': 'double'}
    make = ['teem-unu', 'make', '-t', teem.get(name, TYPES[name][0]), '-s', *sizes, '-sp', *spacing,
            '-en', 'little', '-e', 'raw']
    made = subprocess.run(make, input=array.tobytes(), stdout=subprocess.PIPE, check=True).stdout
    save = ['teem-unu', 'save', '-f', form, '-e', encoding, '-o', str(target)]
    if encoding != 'ascii':
        save[4:4] = ['-en', order]
    subprocess.run(save, input=made, check=True)


def write_nrrd():
    for name in TYPES:
        for order in orders(name):
            unu(samples(name), name, order, 'raw', path('nrrd', f'{name}-{order}.nrrd'))
        unu(samples(name), name, 'little', 'ascii', path('nrrd', f'{name}-little-text.nrrd'))
    for encoding in ('gzip', 'bzip2'):
        unu(samples('i16'), 'i16', 'big', encoding, path('nrrd', f'i16-big-{encoding}.nrrd'))
    unu(samples('i16'), 'i16', 'big', 'gzip', path('nrrd', 'i16-big-detached.nhdr'), 'nrrd')
    unu(two_frames(samples('i16')), 'i16', 'big', 'raw', path('nrrd', 'i16-big-frame1.nrrd'))


# NIfTI and Analyze, by nibabel. Its arrays are array[x][y][z].
def write_nifti():
    affine = numpy.diag([*SPACING, 1.0])
    affine[:3, 3] = ORIGIN
    kinds = {
        ('nifti1', '.nii'): nibabel.Nifti1Image,
        ('nifti1', '.nii.gz'): nibabel.Nifti1Image,
        ('nifti1', '.hdr'): nibabel.Nifti1Pair,
        ('nifti2', '.nii'): nibabel.Nifti2Image,
        ('nifti2', '.hdr'): nibabel.Nifti2Pair,
        ('analyze', '.hdr'): nibabel.AnalyzeImage,
    }
    for (container, extension), image_class in kinds.items():
        header_class = image_class.header_class
        for name in TYPES:
            dtype = samples(name).dtype
            if name not in ('u8', 'i16', 'i32', 'f32', 'f64') and container == 'analyze':
                continue
            whole_table = extension == '.nii' or container == 'analyze'
            if not whole_table and name != 'i16':
                continue
            for order in orders(name):
                header = header_class(endianness=order)
                header.set_data_dtype(dtype.newbyteorder('>' if order == 'big' else '<'))
                image = image_class(samples(name).T, affine, header)
                nibabel.save(image, path(container, f'{name}-{order}{extension}'))
    for container, image_class in (('nifti1', nibabel.Nifti1Image), ('nifti2', nibabel.Nifti2Image)):
        image = image_class(two_frames(samples('i16')).T, affine)
        nibabel.save(image, path(container, 'i16-little-frame1.nii'))


def image_data(name):
    array = samples(name)
    image = vtkImageData()
    image.SetDimensions(*SIZES)
    image.SetSpacing(*SPACING)
    image.SetOrigin(*ORIGIN)
    scalars = numpy_support.numpy_to_vtk(array.ravel().astype(array.dtype.newbyteorder('=')), 1)
    scalars.SetName('samples')
    image.GetPointData().SetScalars(scalars)
    return image


# MetaImage, by VTK: little-endian, without 64-bit integers, which write_metaimage.cpp writes.
def write_metaimage():
    for name in TYPES:
        if name in ('u64', 'i64'):
            continue
        for how in ('.mha', '-compressed.mha', '.mhd'):
            if how != '.mha' and name != 'i16':
                continue
            target = path('metaimage', f'{name}-little{how}')
            writer = vtkIOImage.vtkMetaImageWriter()
            writer.SetInputData(image_data(name))
            writer.SetFileName(str(target))
            if how == '.mhd':
                writer.SetRAWFileName(str(target.with_suffix('.raw')))
            writer.SetCompression(how == '-compressed.mha')
            writer.Write()


# VTK's own formats. Legacy files are big-endian.
def write_vtk():
    for name in TYPES:
        # As text, VTK writes bytes as colours, in fractions of 255, and rounds double precision.
        for how in ('big',) if name in ('u8', 'f64') else ('big', 'big-text'):
            writer = vtkIOLegacy.vtkStructuredPointsWriter()
            writer.SetInputData(image_data(name))
            writer.SetFileName(str(path('vtk', f'{name}-{how}.vtk')))
            if how == 'big':
                writer.SetFileTypeToBinary()
            writer.Write()
        for order in orders(name):
            write_vti(name, order, 'appended-raw', False)
    for order in ('little', 'big'):
        for encoding in ('appended-raw', 'appended-base64', 'base64', 'text'):
            for is_packed in (False, True):
                write_vti('i16', order, encoding, is_packed)
    write_vti('f64', 'little', 'text', False)


def write_vti(name, order, encoding, is_packed):
    writer = vtkIOXML.vtkXMLImageDataWriter()
    writer.SetInputData(image_data(name))
    writer.SetFileName(str(path('vti', f'{name}-{order}-{encoding}{"-zlib" if is_packed else ""}.vti')))
    writer.SetByteOrder(1 if order == 'little' else 0)
    if encoding == 'text':
        writer.SetDataModeToAscii()
    elif encoding == 'base64':
        writer.SetDataModeToBinary()
    else:
        writer.SetDataModeToAppended()
        writer.SetEncodeAppendedData(encoding == 'appended-base64')
    if is_packed:
        writer.SetCompressorTypeToZLib()
        writer.SetBlockSize(64)  # several blocks
    else:
        writer.SetCompressorTypeToNone()
    if order == 'big':
        writer.SetHeaderTypeToUInt32()
    writer.Write()


def write_numpy():
    for name, order, array in ordered_samples():
        numpy.save(path('numpy', f'{name}-{order}.npy'), array)
    numpy.save(path('numpy', 'i16-little-fortran.npy'), samples('i16').T)
    numpy.save(path('numpy', 'i16-little-frame1.npy'), two_frames(samples('i16')))


def write_npz():
    for name, order, array in ordered_samples():
        numpy.savez(path('npz', f'{name}-{order}.npz'), volume=array, table=numpy.zeros((2, 3)))
    numpy.savez_compressed(path('npz', 'i16-little-deflate.npz'), samples('i16'))
    numpy.savez(path('npz_arrays', 'several.npz'), scan=samples('u8'), truth=samples('u8') >= 100,
                slice=samples('u8')[1], words=numpy.array(['scans', 'and']))


# FreeSurfer's, by nibabel.
def write_mgh():
    affine = numpy.diag([*SPACING, 1.0])
    affine[:3, 3] = ORIGIN
    for name in ('u8', 'i16', 'i32', 'f32'):
        for extension in ('.mgh', '.mgz') if name == 'i16' else ('.mgh',):
            image = nibabel.MGHImage(samples(name).T.astype(TYPES[name][0]), affine)
            nibabel.save(image, path('mgh', f'{name}-big{extension}'))


def write_mrc():
    for name in ('i8', 'i16', 'u16', 'f32'):
        for order in ('little', 'big'):
            with mrcfile.new(path('mrc', f'{name}-{order}.mrc'), overwrite=True) as file:
                file.set_data(in_order(samples(name), order))
                file.voxel_size = SPACING


# Zarr of version 2, as OME-Zarr 0.4, by zarr in Python.
def write_zarr_file(name, byte_order, how='', **storage):
    folder = path('zarr', f'{name}-{byte_order}{how}.zarr')
    group = zarr.group(zarr.NestedDirectoryStore(str(folder)), overwrite=True)
    group.create_dataset('0', data=in_order(samples(name), byte_order), dimension_separator='/',
                         **storage)
    group.attrs['multiscales'] = [{
        'version': '0.4',
        'axes': [{'name': axis, 'type': 'space', 'unit': 'millimeter'} for axis in 'zyx'],
        'datasets': [{'path': '0', 'coordinateTransformations': [
            {'type': 'scale', 'scale': SPACING[::-1]},
            {'type': 'translation', 'translation': ORIGIN[::-1]}]}],
    }]


def write_zarr():
    for name, order, _ in ordered_samples():
        write_zarr_file(name, order, chunks=(4, 3, 5))
    write_zarr_file('i16', 'big', '-chunks', chunks=(2, 2, 3))
    for how in ('zlib', 'gzip', 'zstd'):
        compressor = {'zlib': numcodecs.Zlib, 'gzip': numcodecs.GZip, 'zstd': numcodecs.Zstd}[how]()
        write_zarr_file('i16', 'big', '-' + how, compressor=compressor, chunks=(4, 2, 5))
    write_zarr_file('i16', 'big', '-fortran', compressor=None, chunks=(4, 2, 5), order='F')


def write_tiff():
    for name, order, _ in ordered_samples():
        tifffile.imwrite(path('tiff', f'{name}-{order}.tif'), samples(name),
                         photometric='minisblack', byteorder='>' if order == 'big' else '<')


# HDF5, by h5py. Its sizes of a voxel are along z, y and x, in micrometres.
def hdf5_file(name, folder='hdf5'):
    return h5py.File(path(folder, name), 'w')


def add_dataset(file, name, array, **how):
    dataset = file.create_dataset(name, data=array, track_times=False, **how)
    dataset.attrs['element_size_um'] = [1000 * length for length in SPACING[::-1]]


def write_hdf5():
    for name, order, array in ordered_samples():
        with hdf5_file(f'{name}-{order}.h5') as file:
            add_dataset(file, 'volume', array)
    with hdf5_file('i16-big-gzip.h5') as file:
        add_dataset(file, 'exchange/data', samples('i16').astype('>i2'), chunks=(2, 2, 2),
                    compression='gzip', shuffle=True, fletcher32=True)
        file['theta'] = numpy.zeros((4, 3))
        file['title'] = 'beside the volume'
    with hdf5_file('i16-big-lzf.h5') as file:
        add_dataset(file, 'volume', samples('i16').astype('>i2'), chunks=(4, 3, 5), compression='lzf',
                    shuffle=True)
    with hdf5_file('i16-little-frame1.h5') as file:
        add_dataset(file, 'volume', two_frames(samples('i16')), chunks=(1, 1, 3, 5))
    with hdf5_file('several.hdf5', 'hdf5_arrays') as file:
        add_dataset(file, 'scan/u8', samples('u8'))
        add_dataset(file, 'scan/truth', samples('u8') >= 100)
        file['scan/half'] = samples('f32').astype('float16')
        file['scan/slice'] = samples('u8')[1]
        file['scan/complex'] = samples('f32').astype('complex64')
    with hdf5_file('packed.h5', 'hdf5_arrays') as file:
        file.create_dataset('volume', (4, 3, 5), 'u1', chunks=(1, 3, 5), compression=32008,
                            allow_unknown_filter=True)
    with hdf5_file('ilastik.h5', 'hdf5_arrays') as file:
        file['exported_data'] = samples('u8')[..., numpy.newaxis]
        axes = [{'key': axis, 'typeFlags': 2, 'resolution': 0, 'description': ''} for axis in 'zyxc']
        file['exported_data'].attrs['axistags'] = json.dumps({'axes': axes})
    with hdf5_file('master.h5', 'hdf5_arrays') as file:
        file['entry/data/data_000001'] = h5py.ExternalLink('data_000001.h5', '/entry/data/data')
        file['entry/instrument/detector/data'] = h5py.SoftLink('/entry/data/data_000001')
    with hdf5_file('data_000001.h5', 'hdf5_arrays') as file:
        file['entry/data/data'] = samples('u8')
    with hdf5_file('minc.h5', 'hdf5_arrays') as file:
        file['minc-2.0/image/0/image'] = samples('u16')


# InVesalius, with the Python modules that it uses to write its projects.
def write_invesalius():
    for how in ('', '-gzip'):
        matrix = samples('i16')
        project = {
            'format_version': 1.1,
            'name': 'samples',
            'modality': 'CT',
            'spacing': list(SPACING),
            'matrix': {'filename': 'matrix.dat', 'shape': list(matrix.shape), 'dtype': 'int16'},
            'masks': {},
            'surfaces': {},
        }
        with tarfile.open(path('invesalius', f'i16-little{how}.inv3'), 'w:gz' if how else 'w') as tar:
            for member, content in (('matrix.dat', matrix.tobytes()),
                                    ('main.plist', plistlib.dumps(project))):
                entry = tarfile.TarInfo('project/' + member)
                entry.size = len(content)
                tar.addfile(entry, io.BytesIO(content))


if __name__ == '__main__':
    write_nrrd()
    write_nifti()
    write_metaimage()
    write_vtk()
    write_numpy()
    write_npz()
    write_mgh()
    write_mrc()
    write_zarr()
    write_tiff()
    write_hdf5()
    write_invesalius()
