"""As much of Conan 2's Python interface as recipes of a CMake library use."""

import subprocess


class _CppInfo:
    def __init__(self):
        self.libs, self.properties, self.package_folder = [], {}, None

    def set_property(self, name, value):
        self.properties[name] = value


class _Folders:
    bindir = None


class _Cpp:
    def __init__(self):
        self.build = _Folders()


class ConanFile:
    generators = ()

    def __init__(self):
        self.cpp, self.cpp_info, self.required = _Cpp(), _CppInfo(), []

    def requires(self, reference):
        self.required.append(reference)

    def run(self, command, env=None):
        subprocess.run(command, shell=True, check=True)

    def layout_in(self, source, build):
        """Where `source` and `build` are the folders that Conan gives before layout()."""
        self.source_folder, self.build_folder = str(source), str(build)
        self.layout()
