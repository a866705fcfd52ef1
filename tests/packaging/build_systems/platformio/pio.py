"""Stands in for `pio run`: pio.py PROJECT, which has one environment, of the platform native.

Unpacks what lib_deps names to .pio/libdeps, as PlatformIO does, under the name in its library.json.
Compiles of it what build.srcDir and build.srcFilter select, with build.flags and build.unflags; takes
the library up only if the project includes a header that lies in its includeDir; and compiles the
project with its includeDir and the project's own flags. The compiler's default stands in for that of a
framework: C++11.
"""

import concurrent.futures
import configparser
import json
import pathlib
import re
import shutil
import subprocess
import sys

FRAMEWORK = ["-std=gnu++11", "-O0"]


def as_list(value):
    return value.split() if isinstance(value, str) else list(value or ())


def flags(defaults, add, remove):
    """The last -std= wins for the compiler; a flag that is taken away must have been there or not matter."""
    return [f for f in defaults if f not in remove] + add


def install(dependency, folder):
    """Unpacks file://ARCHIVE, or copies file://FOLDER; gives the library's folder."""
    path = pathlib.Path(dependency.removeprefix("file://"))
    work = folder / "_unpacked"
    shutil.unpack_archive(path, work)
    while not (work / "library.json").exists():
        work, = work.iterdir()  # an archive of one folder is that folder
    manifest = json.loads((work / "library.json").read_text())
    for field in ("name", "version"):
        assert manifest[field], field
    work.rename(folder / manifest["name"])
    return folder / manifest["name"], manifest


def selected(folder, manifest):
    """The sources that srcFilter leaves of srcDir: +<...> adds, -<...> takes away, in turn."""
    build = manifest["build"]
    base = folder / build.get("srcDir", "src")
    chosen = set()
    for sign, pattern in re.findall(r"([+-])<([^>]*)>", " ".join(as_list(build.get("srcFilter", ["+<*>"])))):
        found = set()
        for match in base.glob(pattern.rstrip("/")):
            found |= set(match.rglob("*")) if match.is_dir() else {match}
        chosen = chosen | found if sign == "+" else chosen - found
    return sorted(p for p in chosen if p.suffix in (".c", ".cpp", ".cc", ".S"))


def compile_all(sources, base, output, options):
    def run(source):
        output_file = output / (str(source.relative_to(base)).replace("/", "_") + ".o")
        subprocess.run(["g++", *options, "-c", source, "-o", output_file], check=True)
        return output_file
    output.mkdir(parents=True)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        return list(pool.map(run, sources))


def main():
    project = pathlib.Path(sys.argv[1]).resolve()
    ini = configparser.ConfigParser()
    ini.read(project / "platformio.ini")
    settings = ini["env:native"]
    pio = project / ".pio"
    (pio / "libdeps" / "native").mkdir(parents=True)
    library, manifest = install(settings["lib_deps"], pio / "libdeps" / "native")
    build = manifest["build"]
    include = library / build.get("includeDir", "include")
    own = flags(FRAMEWORK, as_list(settings["build_flags"]), as_list(settings["build_unflags"]))

    sources = sorted((project / "src").rglob("*.cpp"))
    included = re.findall(r"#include <([^>]*)>", "".join(s.read_text() for s in sources))
    assert any((include / header).exists() for header in included), "the library is not found by its headers"
    for header in as_list(manifest.get("headers")):
        assert (include / header).exists(), header

    output = pio / "build" / "native"
    theirs = flags(own, as_list(build.get("flags")), as_list(build.get("unflags")))
    objects = compile_all(selected(library, manifest), library, output / "lib", [*theirs, "-I", include])
    archive = output / f"lib{manifest['name']}.a"
    subprocess.run(["ar", "rcs", archive, *objects], check=True)
    program = compile_all(sources, project, output / "src", [*own, "-I", include])
    subprocess.run(["g++", *program, archive, "-o", output / "program"], check=True)


main()
