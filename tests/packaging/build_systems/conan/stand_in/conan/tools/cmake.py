"""conan.tools.cmake, with the profile build_type=Debug."""

import os
import subprocess

BUILD_TYPE = "Debug"


def cmake_layout(conanfile):
    conanfile.build_folder = os.path.join(conanfile.build_folder, BUILD_TYPE)
    conanfile.generators_folder = os.path.join(conanfile.build_folder, "generators")
    conanfile.cpp.build.bindir = conanfile.build_folder


def _toolchain(conanfile):
    return os.path.join(conanfile.generators_folder, "conan_toolchain.cmake")


class CMakeToolchain:
    def __init__(self, conanfile):
        self.conanfile, self.cache_variables = conanfile, {}

    def generate(self):
        """A toolchain file; cache_variables go to a preset, which conan_options stands for."""
        folder = self.conanfile.generators_folder
        with open(_toolchain(self.conanfile), "w", encoding="utf-8") as file:
            file.write(f'list(PREPEND CMAKE_PREFIX_PATH "{folder}")\n')
        self.conanfile.conan_options = [
            f"-D{name}={'ON' if value is True else 'OFF' if value is False else value}"
            for name, value in self.cache_variables.items()]


class CMake:
    def __init__(self, conanfile):
        self.conanfile = conanfile

    def _run(self, *arguments):
        subprocess.run(["cmake", *arguments], check=True)

    def configure(self):
        c = self.conanfile
        prefix = [f"-DCMAKE_INSTALL_PREFIX={c.package_folder}"] if hasattr(c, "package_folder") else []
        self._run("-S", c.source_folder, "-B", c.build_folder, f"-DCMAKE_BUILD_TYPE={BUILD_TYPE}",
                  f"-DCMAKE_TOOLCHAIN_FILE={_toolchain(c)}", "-DCMAKE_INSTALL_LIBDIR=lib", *prefix,
                  *c.conan_options)

    def build(self):
        self._run("--build", self.conanfile.build_folder, "--parallel", "2")

    def install(self):
        self._run("--install", self.conanfile.build_folder)
