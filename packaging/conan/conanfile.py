"""Conan 2: `conan create packaging/conan`, then `requires = "discmc/VERSION"`."""

import os
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load


class Discmc(ConanFile):
    name = "discmc"
    description = "Streaming Discretized Marching Cubes for scanners: slices in, merged polygons out"
    license = "MIT"
    topics = ("marching-cubes", "isosurface", "mesh", "embedded")
    package_type = "static-library"
    settings = "os", "compiler", "build_type", "arch"

    @property
    def _project(self):
        return os.path.join(self.recipe_folder, "..", "..")

    def set_version(self):
        cmake = load(self, os.path.join(self._project, "CMakeLists.txt"))
        self.version = self.version or re.search(r"VERSION (\d+\.\d+\.\d+)", cmake).group(1)

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "lib/*"):
            copy(self, pattern, self._project, self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        for part in ("MESH", "COMMAND", "EXAMPLES", "TESTS", "FUZZ"):
            toolchain.cache_variables["DISCMC_BUILD_" + part] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        CMake(self).install()

    def package_info(self):
        self.cpp_info.libs = ["discmc"]
        self.cpp_info.set_property("cmake_file_name", "discmc")
        self.cpp_info.set_property("cmake_target_name", "discmc::discmc")
