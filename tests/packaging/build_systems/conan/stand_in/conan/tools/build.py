"""conan.tools.build, for a build on the machine that it is for."""


def can_run(conanfile):
    return True
