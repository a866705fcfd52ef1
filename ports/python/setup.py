"""Builds the module discmc._discmc with CMake, in the folder build/ beside this file."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist

here = Path(__file__).resolve().parent


class CMakeBuild(build_ext):
    def build_extension(self, ext: Extension) -> None:
        import pybind11

        module = Path(self.get_ext_fullpath(ext.name)).resolve()
        build = Path(os.environ.get("DISCMC_PYTHON_BUILD", here / "build" / "cmake")).resolve()
        configure = [
            "cmake", "-S", str(here), "-B", str(build),
            "-DCMAKE_BUILD_TYPE=Release",
            f"-DPython_EXECUTABLE={sys.executable}",
            f"-Dpybind11_DIR={pybind11.get_cmake_dir()}",
            f"-DCMAKE_LIBRARY_OUTPUT_DIRECTORY={module.parent}",
        ]
        if "CMAKE_GENERATOR" not in os.environ and shutil.which("ninja"):
            configure += ["-G", "Ninja"]
        subprocess.run(configure, check=True)
        subprocess.run(
            ["cmake", "--build", str(build), "--target", "discmc_python",
             "--parallel", str(os.cpu_count() or 1)],
            check=True)


class NoSourceArchive(sdist):
    def run(self) -> None:
        raise SystemExit("an sdist cannot be built, as the C++ sources are outside of this folder; "
                         "build a wheel in a clone of the repository: pip wheel .")


setup(ext_modules=[Extension("discmc._discmc", sources=[])], cmdclass={"build_ext": CMakeBuild, "sdist": NoSourceArchive})
