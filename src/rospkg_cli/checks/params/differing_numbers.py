"""Parameters that one file of a package gives a node as whole numbers, and another one as doubles (PRM006)."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from ...package.file_role import is_set_aside, role_of
from ...package.params.parameter_file import Parameter, ParameterFile
from ...source import Span
from .declaring_packages import is_its_own
from .mistyped_blocks import WILD, last
from .rcl_types import given_type

Numbers = dict[tuple[str, str], list[tuple[ParameterFile, Parameter]]]
"""By the name of a node and that of its parameter."""


def differing_numbers(
    files: Iterable[ParameterFile], known: Collection[tuple[str, Span]]
) -> Iterator[tuple[ParameterFile, list[tuple[Parameter, str]]]]:
    """Yield each file with the whole numbers that another file of the package has as doubles, and the path of that.

    `known` are the values whose type code declares.
    """
    used = [file for file in files if role_of(file.path) != "test" and not is_set_aside(file.path)]
    doubles = numbers(used, "double")
    found: dict[str, tuple[ParameterFile, list[tuple[Parameter, str]]]] = {}
    for key, places in numbers(used, "int").items():
        others = [file.path for file, _ in doubles.get(key, ())]
        for file, parameter in places:
            if others and file.path not in others and (file.path, parameter.value.span) not in known:
                found.setdefault(file.path, (file, []))[1].append((parameter, others[0]))
    yield from found.values()


def numbers(files: Iterable[ParameterFile], kind: str) -> Numbers:
    """Return the parameters of named nodes that have a number of a kind."""
    found: Numbers = {}
    for file in files:
        for block in file.blocks:
            for each in block.parameters if last(block) not in WILD else ():
                if is_its_own(each.name) and given_type(each.value) == kind:
                    found.setdefault((last(block), each.name), []).append((file, each))
    return found
