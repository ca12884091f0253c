"""Builds the module's C++ with CMake; all else is in pyproject.toml."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).parent.resolve()


class CMakeBuild(build_ext):
    """In build/release where that is for this interpreter, so that what is built there is used; else
    in a tree of its own. STATIONARY_BUILD names another tree, which is configured already."""

    def build_extension(self, extension):
        module = Path(self.get_ext_fullpath(extension.name))
        tree = self.tree(module.name)
        subprocess.run(["cmake", "--build", tree, "--target", "stationary_python"], check=True)
        module.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(tree / "python" / "stationary" / module.name, module)

    def tree(self, name):
        if os.environ.get("STATIONARY_BUILD"):
            return Path(os.environ["STATIONARY_BUILD"])
        release = ROOT / "build" / "release"
        if name in build_files(release):
            return release
        tree = ROOT / "build" / f"python-{sys.implementation.cache_tag}"
        subprocess.run(
            ["cmake", "--preset", "release", "-B", tree, "-D", "STATIONARY_PYTHON=ON", "-D", f"Python_EXECUTABLE={sys.executable}"]
            + [f"-DSTATIONARY_BUILD_{part}=OFF" for part in ("TESTS", "BENCHMARKS")],
            cwd=ROOT,
            check=True,
        )
        return tree


def build_files(tree):
    file = tree / "build.ninja"
    return file.read_text() if file.exists() else ""


setup(
    version=re.search(r"VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text().partition("project(")[2])[1],
    ext_modules=[Extension("stationary._core", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
