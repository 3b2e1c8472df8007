"""Modules that an inner build compiles: DEP109 does not miss them, and still tells of others."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

MAIN = "\n\n\ndef main():\n    print({})\n"
FILES = {
    "package.xml": manifest(),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
    "resource/my_pkg": "",
    "my_pkg/__init__.py": "",
    "my_pkg/ops/__init__.py": "",
    "my_pkg/talker.py": "from my_pkg.ops.grid import fill" + MAIN.format("fill"),
    "my_pkg/ops/grid.py": "from .grid_op import fill\n",
}
EXTENSION = "from setuptools import Extension, setup\n\nsetup(ext_modules=[Extension({}, ['grid.cpp'])])\n"
BY_HELPER = "def make_ext(name, sources):\n    return CUDAExtension(name, sources)\n\n\nmake_ext('grid_op', [])\n"


def told(**more: str) -> list[str]:
    files = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in more.items()}
    return [each.message for each in lint_files({**FILES, **files}, ["DEP109"]).findings]


@pytest.mark.parametrize(
    ("path", "text"),
    [
        ("my_pkg__ops__setup_DOT_py", EXTENSION.format("'grid_op'")),
        ("my_pkg__ops__setup_DOT_py", EXTENSION.format("name='my_pkg.ops.grid_op'")),
        ("my_pkg__ops__setup_DOT_py", BY_HELPER),
        ("my_pkg__ops__CMakeLists_DOT_txt", "pybind11_add_module(grid_op grid.cpp)\n"),
        ("my_pkg__ops__CMakeLists_DOT_txt", "add_library(grid_op MODULE grid.cpp)\n"),
        ("my_pkg__ops__src__grid_DOT_cpp", "PYBIND11_MODULE(grid_op, m) {}\n"),
        ("my_pkg__ops__src__grid_DOT_c", "PyMODINIT_FUNC PyInit_grid_op(void) {return 0;}\n"),
        ("my_pkg__ops__src__lib_DOT_rs", "#[pymodule]\npub fn grid_op(m: &PyModule) -> PyResult<()> {}\n"),
        ("my_pkg__cython__grid_op_DOT_pyx", "def fill(): pass\n"),
    ],
)
def test_a_module_that_an_inner_build_compiles_may_be_there(path: str, text: str) -> None:
    assert told(**{path: text}) == []
    by_name = "from . import grid_op as fill\n"
    assert told(my_pkg__ops__grid_DOT_py=by_name, **{path: text}) == []


@pytest.mark.parametrize(
    ("path", "text"),
    [
        ("my_pkg__ops__setup_DOT_py", EXTENSION.format("'voxel_op'")),
        ("my_pkg__ops__setup_DOT_py", "from setuptools import setup\n\nsetup(name='grid_op')\n"),
        ("my_pkg__ops__CMakeLists_DOT_txt", "pybind11_add_module(grid_op_fast grid.cpp)\n"),
        ("my_pkg__ops__src__grid_DOT_cpp", "// grid_op was here\nPYBIND11_MODULE(other, m) {}\n"),
    ],
)
def test_a_module_of_another_name_is_missing(path: str, text: str) -> None:
    assert told(**{path: text}) == ["there is no module `my_pkg.ops.grid_op`: the import raises ModuleNotFoundError"]
