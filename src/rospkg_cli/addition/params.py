"""A file of parameters: with those that the package's code declares, and what installs it."""

from __future__ import annotations

import json
from collections.abc import Iterator

from ..change import ChangeError
from ..package.package import Package
from ..package.params.collect_declared import declared_parameters
from ..package.params.declared_parameter import DeclaredParameter
from .launch import FILE_NAME
from .new_file import NewFile
from .part import Part
from .share_file import ShareFile

FOLDERS = ("config", "params", "param", "cfg")
"""Where packages keep parameters; the first is used where there is none of them."""


def params_parts(package: Package, asked: str, force: bool = False) -> tuple[Part, ...]:
    """Return the parts of a file of parameters; raises ChangeError for a name that no file can have."""
    folder, slash, stem = asked.removesuffix(".yaml").removesuffix(".yml").rpartition("/")
    if (slash and folder not in FOLDERS) or not FILE_NAME.fullmatch(stem):
        raise ChangeError(f"`{asked}` can't be the name of a file of parameters: letters, digits, `_`, `-` and `.`")
    path = f"{folder or folder_of(package)}/{stem}.yaml"
    return (NewFile(path, text_of(package), force=force), ShareFile(path))


def folder_of(package: Package) -> str:
    """Return the folder in which the package keeps YAML files."""
    kept = [name for name in FOLDERS if any(path.endswith((".yaml", ".yml")) for path in package.files.below(name))]
    return kept[0] if kept else FOLDERS[0]


def text_of(package: Package) -> str:
    """Return a file that holds for each node what all nodes have; what the code declares stands there as a comment."""
    lines = ["/**:", "  ros__parameters:", "    use_sim_time: false  # whether time comes from the topic /clock"]
    return "\n".join([*lines, *declared_lines(package)]) + "\n"


def declared_lines(package: Package) -> Iterator[str]:
    """Yield a commented line for each plain parameter that the code declares, by name."""
    names = dict.fromkeys(sorted(each.name for each in declared_parameters(package) if is_plain(each)))
    if names:
        yield "    # What the package's code declares; take the `#` away to set one:"
        yield from (f"    # {name}:" for name in names)


def is_plain(declared: DeclaredParameter) -> bool:
    """Return whether a parameter has a name that YAML takes as it is."""
    return bool(declared.name) and json.dumps(declared.name)[1:-1] == declared.name and declared.name.isidentifier()
