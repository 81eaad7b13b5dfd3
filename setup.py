"""The wheel: CMake builds the module and the tool and lays them out, setuptools packs them. CMAKE_ARGS holds
options for CMake, CMAKE_BUILD_PARALLEL_LEVEL the number of jobs."""

import importlib.util
import os
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.errors import SetupError

ROOT = os.path.dirname(os.path.abspath(__file__))


def options():
    """What a wheel wants of the project: all that it needs lies in it."""
    wanted = {
        "CMAKE_BUILD_TYPE": "Release",
        "HTL_WHEEL": "ON",
        "HTL_THREADS": "STD",
        "HTL_PYTHON_DIR": ".",
        "HTL_PLUGINS_DIR": "handle_tunnel_loops/plugins",
        "HTL_CUDA": "OFF",
        "HTL_BUILD_TESTS": "OFF",
        "HTL_BUILD_EXAMPLES": "OFF",
        "HTL_BUILD_BENCHMARKS": "OFF",
        "CMAKE_DISABLE_FIND_PACKAGE_Doxygen": "ON",
        "Python_EXECUTABLE": sys.executable,
    }
    if importlib.util.find_spec("pybind11"):
        import pybind11

        wanted["pybind11_DIR"] = pybind11.get_cmake_dir()
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    return generator + [f"-D{name}={value}" for name, value in wanted.items()] + os.environ.get("CMAKE_ARGS", "").split()


class Build(build_ext):
    def run(self):
        if self.inplace:
            raise SetupError("an editable install is not possible: PYTHONPATH=build/python names a build instead")
        if not shutil.which("cmake"):
            raise SetupError("CMake is needed, version 3.21 or later, and was not found")
        build, layout = os.path.abspath(self.build_temp), os.path.abspath(self.build_lib)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count()))
        self.call("-S", ROOT, "-B", build, *options())
        self.call("--build", build, "--config", "Release", "--target", "htl_python", "htloops", "--parallel", jobs)
        self.call("--install", build, "--config", "Release", "--component", "python", "--prefix", layout, "--strip")

    @staticmethod
    def call(*arguments):
        if subprocess.run(["cmake", *arguments]).returncode != 0:
            raise SetupError("CMake failed, see above")

    def get_outputs(self):
        return []

    def get_source_files(self):
        return []


setup(ext_modules=[Extension("handle_tunnel_loops._core", [])], cmdclass={"build_ext": Build})
