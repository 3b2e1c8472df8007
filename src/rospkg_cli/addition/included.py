"""The packages whose headers the C++ of a package includes."""

from __future__ import annotations

import re

from ..package.package import Package

CPP = (".cpp", ".cc", ".cxx", ".c", ".hpp", ".h", ".hh", ".hxx", ".ipp", ".tpp")
TESTS = ("test/", "tests/")
INCLUDE = re.compile(r"^[ \t]*#[ \t]*include[ \t]*[<\"]([\w.-]+)/", re.MULTILINE)


def included(package: Package) -> frozenset[str]:
    """Return the packages that code outside of the tests includes, by the first folder of each header's path."""
    paths = [path for path in package.files.paths if path.endswith(CPP) and not path.startswith(TESTS)]
    return frozenset(name for path in paths for name in includes_of(package, path))


def includes_of(package: Package, path: str) -> list[str]:
    """Return the first folder of each header that a file includes."""
    return INCLUDE.findall(package.files.readable_text(path))
