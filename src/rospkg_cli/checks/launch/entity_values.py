"""Substitutions in XML and YAML launch files, and values that should be one (LCH007)."""

from __future__ import annotations

from collections.abc import Iterator

from ...lazy_regex import regex
from ...package.launch.entity import Entity
from ...package.launch.launch_file import LaunchFile
from ...package.launch.text import Substitution
from ...ros.launch_entities import SUBSTITUTIONS
from ...suggest import nearest
from ..fault import Fault

BARE = regex(r"(?<![$\w)])\((var|find-pkg-share|find-pkg-prefix) (\w+)\)")
PROSE = frozenset({"description", "message", "reason"})


def without_dollar(file: LaunchFile) -> Iterator[Fault]:
    """Yield `(var x)` where `x` is an argument of the file, and `(find-pkg-share x)/…`: text, as launch reads it."""
    declared = {argument.name.literal for argument in file.arguments}
    for entity in file.root.walk() if file.root else ():
        for name, written in entity.attributes.items() if entity.name != "log" else ():
            for found in BARE.finditer(written.text) if name not in PROSE else ():
                if found.group(1) != "var" or found.group(2) in declared:
                    span = written.part(found.start(), found.end())
                    yield Fault(span, f"`{found.group()}` is text, and no substitution: write `${found.group()}`")


def substitution_faults(found: Substitution) -> Iterator[Fault]:
    """Yield what is wrong with the name of a substitution, and with the number of its arguments."""
    if found.name not in SUBSTITUTIONS:
        near = nearest(found.name, SUBSTITUTIONS, 1)
        if near:
            yield Fault(found.span, f"launch has no substitution `$({found.name} …)`; did you mean `$({near} …)`?")
        return
    count, (least, most) = len(found.arguments), SUBSTITUTIONS[found.name]
    if not least <= count <= most:
        wanted = str(least) if least == most else f"{least} to {most}"
        message = f"`$({found.name} …)` takes {wanted} argument{'s' * (most != 1)}, not {count}"
        yield Fault(found.span, f"{message}; quote an argument that holds blanks")


def quoted_arguments(root: Entity, used: frozenset[str]) -> Iterator[Fault]:
    """Yield `<param name="x" value="x"/>`, a literal value, where `x` is an argument of the file and used nowhere."""
    declared = {
        each.attributes["name"].text for each in root.walk() if each.name == "arg" and "name" in each.attributes
    }
    for each in root.walk():
        name, value = each.attributes.get("name"), each.attributes.get("value")
        if each.name == "param" and name and value and name.text == value.text and name.text in declared - used:
            message = f"the parameter is the string `{value.text}`, not the argument of that name, which nothing uses"
            yield Fault(value.span, f"{message}; write `$(var {value.text})`")
