"""Compares discmc's results for volumes with what other programs wrote or read.

usage: compare.py DISCMC FOLDER [--cases N] [--seed N] [--only TEXT]
Of each generator N volumes (default 30), from a seed each, from --seed on (default 1). Prints a table,
and of each volume that is found otherwise the seed and what differs; its files stay in FOLDER. Exit
code 1 where there is one.
"""
import argparse
import importlib
import os
import pathlib
import shutil
import subprocess
import sys

import numpy

import cases

for file in sorted((pathlib.Path(__file__).parent / "generators").glob("*.py")):
    importlib.import_module(f"generators.{file.stem}")  # generators register themselves


class Failure(Exception):
    pass


def output_of(discmc, *arguments):
    done = subprocess.run([discmc, *map(str, arguments)], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, timeout=600)
    if done.returncode != 0:
        raise Failure(done.stderr.strip().splitlines()[-1])
    return done.stdout


def info_of(discmc, case):
    lines = output_of(discmc, "info", case.file, *case.options).splitlines()
    return {key: value for key, _, value in (line.partition(" ") for line in lines)}


def numbers(text):
    return numpy.array([float(word) for word in text.split()])


def reported_place(info):
    """4 x 4, in LPS if the patient is known."""
    place = numpy.eye(4)
    for axis, key in enumerate(("axis_x", "axis_y", "axis_z")):
        place[:3, axis] = numbers(info[key])
    place[:3, 3] = numbers(info["origin"])
    return cases.FROM_RAS @ place if info["space"] == "ras" else place


def box_of(shape, place):
    """The corners of the volume: the centres of its outermost voxels."""
    ends = numpy.array(numpy.meshgrid(*[(0, size - 1) for size in shape])).reshape(3, -1)
    return place[:3, :3] @ ends + place[:3, 3:]


def surface_points(case):
    """The midpoints between each on voxel and its off neighbours, in numbers of voxels."""
    on = numpy.pad(case.values >= case.iso, 1)
    points = []
    for axis in range(3):
        crossing = numpy.argwhere(numpy.diff(on.astype(numpy.int8), axis=axis) != 0).astype(float) - 1
        crossing[:, axis] += 0.5
        points.append(crossing)
    return numpy.concatenate(points)


def vertices_of(obj):
    with open(obj) as lines:
        return numpy.array([[float(word) for word in line.split()[1:4]]
                            for line in lines if line.startswith("v ")])


def require(is_good, what, expected, found):
    if not is_good:
        raise Failure(f"{what}: {found} instead of {expected}")


def same_number(a, b):
    """Compares the 15 digits that discmc prints, or those of a 32-bit float."""
    return bool(numpy.isclose(a, b, rtol=2e-13, atol=0)) or numpy.float32(a) == numpy.float32(b)


def check_values(case, info):
    finite = case.values[numpy.isfinite(case.values)].astype(numpy.longdouble)
    require(int(info["voxels"]) == case.values.size, "voxels", case.values.size, info["voxels"])
    count = int(info["voxels"]) - int(info["not_numbers"]) - int(info["infinite"])
    require(count == finite.size, "numbers", finite.size, count)
    for key, expected, found in zip(("least", "greatest"), (finite.min(), finite.max()),
                                    numbers(info["range"])):
        require(same_number(float(expected), found), key, expected, found)
    # The sum is the mean times the count. If values cancel, rounding errors of the terms remain.
    mean, found = float(finite.mean()), float(info["mean"])
    largest = float(numpy.abs(finite).max())
    require(same_number(mean, found) or abs(mean - found) <= 1e-15 * largest, "mean", mean, found)


def check_place(case, info):
    require(numpy.array_equal(numbers(info["dimensions"]), case.values.shape), "dimensions",
            case.values.shape, info["dimensions"])
    space = "lps" if info["space"] == "ras" else info["space"]
    require(space == case.space, "space", case.space, info["space"])
    expected, found = (box_of(case.values.shape, place) for place in (case.place, reported_place(info)))
    voxel = numpy.abs(numpy.linalg.det(case.place[:3, :3])) ** (1 / 3)
    apart = numpy.abs(expected - found).max()
    require(apart < 1e-4 * voxel, "box", expected.T.tolist(), found.T.tolist())


def check_mesh(discmc, case, folder):
    """The body's box in space, and every vertex between two voxels on different sides of the threshold."""
    obj = folder / "mesh.obj"
    output_of(discmc, "extract", case.file, *case.options, f"--iso={case.iso!r}", "-q", "-o", obj)
    vertices = vertices_of(obj).T
    points = surface_points(case)
    expected = case.place[:3, :3] @ points.T + case.place[:3, 3:]
    voxel = numpy.abs(numpy.linalg.det(case.place[:3, :3])) ** (1 / 3)
    for name, end in (("low", numpy.min), ("high", numpy.max)):
        box, found = end(expected, axis=1), end(vertices, axis=1)
        require(numpy.abs(box - found).max() < 1e-3 * voxel, f"{name} corner of the body", box, found)
    back = numpy.linalg.solve(case.place[:3, :3], vertices - case.place[:3, 3:]).T
    known = {tuple(point) for point in numpy.round(2 * points).astype(int)}
    strangers = [point for point in back if tuple(numpy.round(2 * point).astype(int)) not in known]
    require(not strangers, "vertices off the surface", 0, len(strangers))


def check(discmc, generate, seed, folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    case = generate(numpy.random.default_rng(seed), folder)
    info = info_of(discmc, case)
    check_place(case, info)
    check_values(case, info)
    check_mesh(discmc, case, folder)


def fault_of(*arguments):
    """Returns None if there is no fault."""
    try:
        check(*arguments)
    except Failure as failure:
        return str(failure)
    except Exception as error:  # an error of a generator is a fault, too
        return repr(error)
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("discmc", type=os.path.abspath)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--cases", type=int, default=30)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="")
    arguments = parser.parse_args()
    faults = []
    print("| volumes | as they should be |\n|---|--:|")
    for number, (name, generate) in enumerate(cases.GENERATORS.items()):
        if arguments.only.lower() not in name.lower():
            continue
        good = 0
        for seed in range(arguments.seed, arguments.seed + arguments.cases):
            folder = arguments.folder.resolve() / f"{number}-{seed}"
            fault = fault_of(arguments.discmc, generate, seed, folder)
            if fault is None:
                good += 1
                shutil.rmtree(folder)
            else:
                faults.append(f"{name}, seed {seed} ({folder}): {fault}")
        print(f"| {name} | {good} of {arguments.cases} |", flush=True)
    if faults:
        print("\n" + "\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
