"""Variables that CMake itself sets, and which of them a misspelt name stands for."""

from __future__ import annotations

from ...suggest import near_names
from .name_slips import digits

SET_BY_CMAKE = frozenset("""
    PROJECT_NAME PROJECT_SOURCE_DIR PROJECT_BINARY_DIR PROJECT_VERSION CMAKE_PROJECT_NAME CMAKE_SOURCE_DIR
    CMAKE_BINARY_DIR CMAKE_CURRENT_SOURCE_DIR CMAKE_CURRENT_BINARY_DIR CMAKE_CURRENT_LIST_DIR CMAKE_CURRENT_LIST_FILE
    CMAKE_CURRENT_LIST_LINE CMAKE_INSTALL_PREFIX CMAKE_CXX_FLAGS CMAKE_C_FLAGS CMAKE_CXX_COMPILER_ID
    CMAKE_C_COMPILER_ID CMAKE_CXX_COMPILER CMAKE_C_COMPILER CMAKE_CXX_STANDARD CMAKE_C_STANDARD
    CMAKE_INSTALL_BINDIR CMAKE_INSTALL_SBINDIR CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_LIBEXECDIR CMAKE_INSTALL_SYSCONFDIR
    CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_DATAROOTDIR CMAKE_INSTALL_DATADIR CMAKE_INSTALL_DOCDIR CMAKE_INSTALL_MANDIR
    CMAKE_INSTALL_INFODIR CMAKE_INSTALL_LOCALEDIR
""".split())  # fmt: skip
"""Those that packages use, and all others of CMake 3.25 with a similar name."""


def near_variable_of_cmake(name: str) -> str | None:
    """Return the variable of CMake that is one or two letters off a name and has the same digits."""
    alike = (each for each in SET_BY_CMAKE if digits(each) == digits(name))
    return next(iter(near_names(name, alike)), None)
