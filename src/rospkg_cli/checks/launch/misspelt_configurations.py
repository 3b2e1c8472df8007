"""Launch configurations that are probably misspelt, in launch files that cannot be evaluated to the end (LCH008)."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...lazy_regex import regex
from ...package.file_role import role_of
from ...source import Span
from ...suggest import near_names, nearest
from .launch_configurations import OWN, LaunchConfigurations
from .unset_configuration import UnsetConfiguration

SHORTEST = 5
DIGITS = regex(r"\d")


def slips(configurations: LaunchConfigurations) -> Iterator[UnsetConfiguration]:
    """Yield names that a file uses once, where one that it declares and never uses is spelt nearly alike.

    Not all of the file need be known. Neither name occurs anywhere else in it, and no other launch file has the
    name that is used; where a default hides the slip, none has the one that is declared.
    """
    file = configurations.file
    if not file.has_entry_point or file.is_ros1 or role_of(file.path) != "launch":
        return
    alone = {
        name
        for each in file.arguments
        if (name := each.name.literal or "") and configurations.mentions[name] == 1 and len(name) >= SHORTEST
    }
    for use in file.configurations() if alone else ():
        name, has_default = use.arguments[0].literal or "" if use.arguments else "", len(use.arguments) > 1
        near, is_far = near_names(name, alone, 1), False
        if not near and not has_default and (alike := nearest(name, alone)):
            near, is_far = [alike], True
        near = [each for each in near if DIGITS.sub("", each) != DIGITS.sub("", name)]
        if (
            len(near) == 1
            and configurations.mentions[name] == 1
            and not is_elsewhere(configurations, name, near[0], has_default)
        ):
            is_guess = is_far or (has_default and bool(file.includes))
            yield UnsetConfiguration(
                name,
                use.span,
                "undeclared",
                (near[0],),
                has_default=has_default,
                is_guess=is_guess,
                is_unread=not configurations.is_read(use.span),
            )


def is_elsewhere(configurations: LaunchConfigurations, used: str, declared: str, has_default: bool) -> bool:
    """Return whether another launch file has the name that is used; with a default, the one that is declared."""
    launch = configurations.workspace.launch
    return launch.has(declared, besides=configurations.file_name) if has_default else launch.has(used)


def unset_in_classes(configurations: LaunchConfigurations) -> Iterator[UnsetConfiguration]:
    """Yield names that a class of the file uses and no launch file has; whether the class's code runs is not known."""
    file = configurations.file
    spans = tuple(used_classes(file.python)) if file.python is not None else ()
    inherited = configurations.inherited if spans else None
    if inherited is None or configurations.may_set_any:
        return
    known = inherited | OWN | file.set_configurations
    declared = tuple(name for each in file.arguments if (name := each.name.literal))
    for use in file.configurations() if declared else ():
        name = use.arguments[0].literal or "" if len(use.arguments) == 1 else ""
        is_inside = any(span.holds(use.span) for span in spans)
        if name and is_inside and name not in known and not configurations.workspace.launch.has(name):
            may_be = bool(file.includes)
            yield UnsetConfiguration(
                name,
                use.span,
                "undeclared",
                declared,
                may_be_included=may_be,
                is_guess=True,
                is_unread=not configurations.is_read(use.span),
            )


def used_classes(file: PythonFile) -> Iterator[Span]:
    """Yield where a file defines classes of which it makes objects itself."""
    made = {each.func.id for each in nodes_of_kind(file.tree, ast.Call) if isinstance(each.func, ast.Name)}
    for each in nodes_of_kind(file.tree, ast.ClassDef):
        if each.name in made:
            yield file.span(each)
