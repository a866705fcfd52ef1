"""Stands in for Bazel: starlark.py PROJECT.

Reads MODULE.bazel and BUILD.bazel of PROJECT and of the modules that it overrides with local paths,
as Python, whose subset Starlark is. Compiles cc_library and cc_binary as Bazel does by default: -O0,
headers of `includes` as system headers, copts for the target's own sources alone. Of a package's
files only those named in srcs and hdrs are seen, as in Bazel's sandbox. The programs go to
PROJECT/built-bin.
"""

import concurrent.futures
import pathlib
import shutil
import subprocess
import sys


def read(path, functions):
    """Runs a file of definitions. Names that are not in `functions` are errors."""
    exec(compile(path.read_text(), str(path), "exec"), {"__builtins__": {}, **functions})


def modules_of(project):
    """The folders of PROJECT and of its dependencies with local paths, by name."""
    folders, declared, wanted = {}, [], []
    read(project / "MODULE.bazel", {
        "module": lambda name, version="": declared.append(name),
        "bazel_dep": lambda name, version: wanted.append((name, version)),
        "local_path_override": lambda module_name, path: folders.update({module_name: project / path}),
    })
    for name, version in wanted:
        if name in folders:
            found = []
            read(folders[name] / "MODULE.bazel", {
                "module": lambda name, version: found.append((name, version)),
                "bazel_dep": lambda name, version: None,
            })
            assert found == [(name, version)], f"{found} where {name} {version} was asked for"
    return folders


def targets_of(folder):
    """The rules in a BUILD.bazel by name, with their files."""
    targets, loaded = {}, {}

    def rule(kind):
        def call(name, srcs=(), hdrs=(), copts=(), includes=(), deps=(), visibility=()):
            targets[name] = {
                "kind": kind, "srcs": list(srcs), "hdrs": list(hdrs), "copts": list(copts),
                "includes": list(includes), "deps": list(deps), "visibility": list(visibility),
            }
        return call

    def glob(include):
        return sorted({str(p.relative_to(folder)) for i in include for p in folder.glob(i)})

    def load(label, *names):
        assert label == "@rules_cc//cc:defs.bzl", label
        loaded.update({name: rule(name) for name in names})

    # A rule must be loaded before its first call.
    late = {n: lambda n=n, **k: loaded[n](**k) for n in ("cc_library", "cc_binary")}
    read(folder / "BUILD.bazel", {"load": load, "glob": glob, **late})
    return targets


def sandbox(folder, target, place):
    for file in target["srcs"] + target["hdrs"]:
        (place / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(folder / file, place / file)
    return place


def compiled(target, place, options):
    """The object files of a target's sources."""
    def run(source):
        compiler = "gcc" if source.endswith(".c") else "g++"
        output = place / (source.replace("/", "_") + ".o")
        subprocess.run([compiler, "-O0", *target["copts"], *options, "-c", place / source, "-o", output],
                       check=True)
        return output
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        return list(pool.map(run, target["srcs"]))


def main():
    project = pathlib.Path(sys.argv[1]).resolve()
    output = project / "built-bin"
    output.mkdir()
    libraries = {}
    for name, folder in modules_of(project).items():
        library = targets_of(folder)[name]  # @name is short for @name//:name
        assert library["kind"] == "cc_library" and "//visibility:public" in library["visibility"]
        place = sandbox(folder, library, output / name)
        options = [part for i in library["includes"] for part in ("-isystem", place / i)]
        archive = output / f"lib{name}.a"
        subprocess.run(["ar", "rcs", archive, *compiled(library, place, options)], check=True)
        libraries["@" + name] = (options, archive)
    for name, binary in targets_of(project).items():
        place = sandbox(project, binary, output / (name + ".sandbox"))
        options = [o for d in binary["deps"] for o in libraries[d][0]]
        archives = [libraries[d][1] for d in binary["deps"]]
        subprocess.run(["gcc", *compiled(binary, place, options), *archives, "-o", output / name],
                       check=True)


main()
