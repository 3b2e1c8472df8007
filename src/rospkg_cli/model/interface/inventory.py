"""What other packages may know of a package's interfaces: their names, and whether these are all."""

from __future__ import annotations

import re

from ...ros.interfaces import KINDS
from ..cmake.read import CMakeFile
from ..files import Reading
from ..uses.roles import role_of
from .reader import interface_paths

GENERATED = tuple(f".{kind}{suffix}" for kind in (*KINDS, "idl") for suffix in (".in", ".em", ".j2", ".template"))
VARIABLE = re.compile(r"\$\{([^}]*)\}")
ALWAYS = frozenset({"PROJECT_NAME", "CMAKE_CURRENT_SOURCE_DIR", "CMAKE_CURRENT_LIST_DIR", "PROJECT_SOURCE_DIR"})


def interface_names(reading: Reading) -> tuple[frozenset[str], bool]:
    """Return `msg/Name`, `srv/Name` … of all interfaces of a package, and whether these are all.

    rosidl_adapter makes `msg/Name.idl` of a .msg in whatever folder; an .idl file stays in its own.
    """
    found = {f"{path.rpartition('.')[2]}/{stem(path)}" for path in interface_paths(reading.files)}
    for path in reading.files.paths:
        folders = path.split("/")[:-1]
        if path.endswith(".idl") and folders[-1:] and folders[-1] in KINDS and role_of(path) == "run":
            found.add(f"{folders[-1]}/{stem(path)}")
    complete = not any(path.endswith(GENERATED) for path in reading.files.paths) and not from_elsewhere(reading)
    return frozenset(found), complete


def stem(path: str) -> str:
    return path.rpartition("/")[2].rpartition(".")[0]


def from_elsewhere(reading: Reading) -> bool:
    """Return whether rosidl_generate_interfaces is given a variable that no file of the package sets."""
    commands = [command for file in reading.parts(CMakeFile).good for command in file.syntax.commands]
    given = set()
    for command in commands:
        if command.name == "rosidl_generate_interfaces":
            given |= {name for argument in command.arguments for name in VARIABLE.findall(argument.text)}
    own = {
        argument.text
        for command in commands
        if command.name in ("set", "file", "list")
        for argument in command.arguments
    }
    return bool(reading.parts(CMakeFile).broken) or not given <= own | ALWAYS
