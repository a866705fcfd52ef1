"""Stands in for a program that takes CMSIS packs: project.py PACK SDK OUTPUT

Makes a project of the one component in the folder PACK and of its template in C++, and builds it as
such a program does: the sources that the description lists, with the include paths that it lists, and
SDK, a folder made by board/make, for the device. All files that are listed must be there, and all
sources that are there must be listed.
"""

import concurrent.futures
import pathlib
import subprocess
import sys
import xml.etree.ElementTree

COMPILER = "arm-none-eabi-g++"


def main():
    pack, sdk, output = map(pathlib.Path, sys.argv[1:])
    description, = pack.glob("*.pdsc")
    root = xml.etree.ElementTree.parse(description).getroot()
    names = [root.find("vendor").text, root.find("name").text]
    assert description.name == ".".join(names) + ".pdsc", names
    component, = root.find("components")
    release = root.find("releases/release").get("version")
    assert component.get("Cversion") == release

    files = component.find("files")
    for file in files:
        assert (pack / file.get("name")).exists(), file.get("name")
    assert (pack / root.find("license").text).exists()
    listed = {f.get("name") for f in files}
    forgotten = [p for p in pack.rglob("lib/**/*.cpp") if str(p.relative_to(pack)) not in listed]
    assert not forgotten, forgotten

    include = [f"-I{pack / f.get('name')}" for f in files if f.get("category") == "include"]
    sources = [f.get("name") for f in files if f.get("category") == "sourceCpp"]

    def compiled(source):
        path = pathlib.Path(source.replace("/", "_") + ".o")
        subprocess.run([COMPILER, f"@{sdk}/compile", "-std=c++17", "-fno-rtti", "-Wall", "-Wextra", "-Werror",
                        *include, "-c", pack / source, "-o", path], check=True)
        return path

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        objects = list(pool.map(compiled, sources))
    subprocess.run([COMPILER, f"@{sdk}/link", *objects, sdk / "sdk.o", "-lgcc", "-o", output], check=True)


main()
