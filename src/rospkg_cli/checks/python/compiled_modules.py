"""Python modules that a separate build compiles, which colcon does not run: an inner setup.py, or CMake."""

from __future__ import annotations

import posixpath
import re

from ...files import PackageFiles
from ...lazy_regex import regex

EXTENDS = regex(r"Extension\b|ext_modules|cythonize|rust_extensions|make_\w*ext")
"""How a setup.py makes modules, be it by a function of its own that takes the name."""
SETUPS = r"[\"'](?:[\w.]+[.])?{0}[\"']"
CMAKE = r"(?i:\b\w*(?:add_module|add_library|create_module)\s*\(\s*{0}\b|\bOUTPUT_NAME\s+[\"']?{0}\b)"
CODE = (
    r"\b(?:PYBIND11_(?:EMBEDDED_)?MODULE|PYBIND11_PLUGIN|NB_MODULE|BOOST_PYTHON_MODULE|TORCH_LIBRARY)\s*\(\s*{0}\b"
    r"|\bPyInit_{0}\b|#\[pymodule\][^{{]*?\bfn\s+{0}\b"
)
"""How the code of a module says what it is called."""
OF_CODE = (".c", ".cc", ".cpp", ".cxx", ".cu", ".rs")
OF_CYTHON = ".pyx"


def is_compiled(files: PackageFiles, name: str) -> bool:
    """Return whether a file of the package has a module compiled by its name, wherever it puts that."""
    return any(may_compile(files, path, name) for path in files.every)


def may_compile(files: PackageFiles, path: str, name: str) -> bool:
    base = posixpath.basename(path)
    if base == f"{name}{OF_CYTHON}":
        return True
    is_setup = base.startswith("setup") and base.endswith(".py")
    pattern = SETUPS if is_setup else CMAKE if is_cmake(base) else CODE if base.endswith(OF_CODE) else ""
    if not pattern or not files.holds(path, name.encode()):
        return False
    text = files.readable_text(path)
    if is_setup and not EXTENDS.search(text):
        return False
    return re.search(pattern.format(re.escape(name)), text) is not None


def is_cmake(base: str) -> bool:
    return base == "CMakeLists.txt" or base.endswith(".cmake")
