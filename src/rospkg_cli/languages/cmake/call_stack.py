"""The frame that is being run, the variables that CMake itself sets, and how a file or a loop is left."""

from __future__ import annotations

import posixpath
from collections.abc import Mapping

from ...light_dataclasses import dataclass, field
from ...source import Span
from .command_blocks import Block
from .file import ROOT
from .syntax import CommandInvocation
from .values import BINARY, PREFIX, SOURCE, UNKNOWN, Value

MAX_STEPS = 20_000
MAX_DEPTH = 40
MAX_COST = 1_000_000
"""So many words (and sixteens of characters) are looked at and built in all: a hundred MiB at most."""

ENVIRONMENT = {"ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3"}
IS_SET = frozenset({*ENVIRONMENT, "AMENT_PREFIX_PATH"})
"""What every environment of ROS 2 sets."""
FOUND = {"catkin": "0", "ament_cmake": "1"}
"""Whether what packages for both versions of ROS look for, to know theirs, is found."""
OFF = ("WIN32", "MSVC", "APPLE", "ANDROID", "CYGWIN", "MINGW", "IOS", "BORLAND", "CMAKE_CROSSCOMPILING")
INSTALL_DIRS = {
    "BINDIR": "bin", "SBINDIR": "sbin", "LIBEXECDIR": "libexec", "SYSCONFDIR": "etc", "LIBDIR": "lib",
    "INCLUDEDIR": "include", "DATAROOTDIR": "share", "DATADIR": "share", "DOCDIR": "share/doc", "MANDIR": "share/man",
}  # fmt: skip
"""What GNUInstallDirs sets, below any prefix but /usr."""

PYTHON = "lib/python"
"""A placeholder for `lib/python3.12/site-packages`, whose name depends on the version of Python."""

CONSTANTS = {
    "CMAKE_INSTALL_PREFIX": PREFIX,
    "CMAKE_SYSTEM_NAME": "Linux",
    "PYTHON_INSTALL_DIR": PYTHON,
    **{f"CMAKE_INSTALL_{name}": text for name, text in INSTALL_DIRS.items()},
    "UNIX": "1",
    "LINUX": "1",
    **dict.fromkeys(OFF, ""),
}


NOWHERE = Span(0, 0)


class LeaveError(Exception):
    """`return`, `break` or `continue`; `fatal` where the configuration stops."""

    def __init__(self, how: str) -> None:
        super().__init__(how)
        self.how = how


class ExhaustedError(Exception):
    """The run takes more steps, or costs more, than is allowed."""


@dataclass(frozen=True)
class Frame:
    """The position of the interpreter and the conditions under which it is there."""

    path: str
    """The file whose commands are run."""
    file: str = ROOT
    """CMAKE_CURRENT_LIST_FILE: inside a function that of its caller."""
    folder: str = ""
    """CMAKE_CURRENT_SOURCE_DIR, relative to the package."""
    testing: bool = False
    maybe: bool = False
    is_unreachable: bool = False
    """It is never run: a branch that is never taken, a loop over nothing."""
    depth: int = 0
    inside: str = ""
    """The function or macro of the package that is run."""
    bindings: Mapping[str, Value] = field(default_factory=dict)
    """The arguments of the macro that is run."""


@dataclass
class FunctionDefinition:
    command: CommandInvocation
    body: list[CommandInvocation | Block]
    path: str
    parameters: list[str]
    is_macro: bool


def environment(name: str) -> str:
    return ENVIRONMENT.get(name, UNKNOWN)


def built_in(name: str, here: Frame, testing: str | None) -> str | None:
    """Return what CMake itself sets a variable to, None for one that it doesn't; `testing` is BUILD_TESTING."""
    match name:
        case "CMAKE_SOURCE_DIR":
            return SOURCE
        case "CMAKE_BINARY_DIR":
            return BINARY
        case "CMAKE_CURRENT_SOURCE_DIR":
            return posixpath.join(SOURCE, here.folder).rstrip("/")
        case "CMAKE_CURRENT_BINARY_DIR":
            return posixpath.join(BINARY, here.folder).rstrip("/")
        case "CMAKE_CURRENT_LIST_DIR":
            return posixpath.join(SOURCE, posixpath.dirname(here.file)).rstrip("/")
        case "CMAKE_CURRENT_LIST_FILE":
            return posixpath.join(SOURCE, here.file)
        case "BUILD_TESTING":
            return testing
        case _:
            return CONSTANTS.get(name)
