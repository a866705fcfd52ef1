"""Stands in for `conan create`: create.py RECIPE CACHE.

Calls the methods of the recipe in the order and in the folders that Conan 2's documentation gives:
the sources are exported to the cache, built there, and packaged; then the test package is built
against what package_info() tells, in its own folder.
"""

import importlib.util
import os
import pathlib
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))


def recipe_in(folder):
    """An object of the one recipe of a folder's conanfile.py."""
    spec = importlib.util.spec_from_file_location("recipe", folder / "conanfile.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    from conan import ConanFile
    found = [c for c in vars(module).values()
             if isinstance(c, type) and issubclass(c, ConanFile) and c is not ConanFile]
    recipe, = (c() for c in found)
    recipe.recipe_folder = str(folder)
    return recipe


def build_in(recipe, source, build):
    recipe.layout_in(source, build)
    pathlib.Path(recipe.generators_folder).mkdir(parents=True, exist_ok=True)
    for generator in recipe.generators:
        if generator == "CMakeToolchain":
            from conan.tools.cmake import CMakeToolchain
            CMakeToolchain(recipe).generate()
    if hasattr(recipe, "generate"):
        recipe.generate()
    recipe.build()


def cmake_deps(info, folder, name, version):
    """What the generator CMakeDeps writes for a package: a config file with one target."""
    file = info.properties.get("cmake_file_name", name)
    target = info.properties.get("cmake_target_name", f"{name}::{name}")
    package = info.package_folder
    library, = info.libs
    (folder / f"{file}-config.cmake").write_text(
        f"set({file}_VERSION {version})\n"
        f"add_library({target} INTERFACE IMPORTED)\n"
        f"target_include_directories({target} INTERFACE {package}/include)\n"
        f"target_link_libraries({target} INTERFACE {package}/lib/lib{library}.a)\n")


def main():
    recipe_folder, cache = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    recipe = recipe_in(recipe_folder)
    recipe.version = None
    recipe.set_version()
    recipe.export_sources_folder = str(cache / "source")
    recipe.export_sources()

    # From here on the recipe is the cache's: what lies beside it in the project is gone.
    (cache / "export").mkdir()
    recipe.recipe_folder = str(cache / "export")
    recipe.package_folder = str(cache / "package")
    build_in(recipe, cache / "source", cache / "build")
    recipe.package()
    assert os.listdir(cache / "package" / "licenses") == ["LICENSE"]
    recipe.cpp_info.package_folder = recipe.package_folder
    recipe.package_info()

    test = recipe_in(recipe_folder / "test_package")
    test.tested_reference_str = f"{recipe.name}/{recipe.version}"
    test.requirements()
    assert test.required == [test.tested_reference_str]
    build = recipe_folder / "test_package" / "build"
    generators = build / "Debug" / "generators"
    generators.mkdir(parents=True)
    assert "CMakeDeps" in test.generators
    cmake_deps(recipe.cpp_info, generators, recipe.name, recipe.version)
    build_in(test, recipe_folder / "test_package", build)
    os.chdir(build)
    test.test()


main()
