"""Classes that C++ sources register as components: `RCLCPP_COMPONENTS_REGISTER_NODE(ns::Class)`."""

from __future__ import annotations

from collections.abc import Iterable

from ...languages.cpp.call import CppArgument
from ...languages.cpp.file import CppFile
from ...light_dataclasses import dataclass
from ...source import Span

MACRO = "RCLCPP_COMPONENTS_REGISTER_NODE"


@dataclass(frozen=True)
class RegisteredClass:
    """`RCLCPP_COMPONENTS_REGISTER_NODE(ns::Class)` in a file."""

    name: str
    path: str
    span: Span

    @property
    def unregistered(self) -> str:
        start = f"`{self.name}` is registered here and by no `rclcpp_components_register_node(…)`"
        return f"{start}: it can't be loaded by its name; register it in CMakeLists.txt too"


def registered_classes(sources: Iterable[CppFile]) -> tuple[RegisteredClass, ...]:
    """Return the classes that some sources register, in order."""
    found = []
    for file in sources:
        for call in file.calls_to(MACRO):
            for argument in (call.arguments or ())[:1]:
                found.append(RegisteredClass(name_of(argument), file.path, argument.span))
    return tuple(found)


def has_own_macro(sources: Iterable[CppFile]) -> bool:
    """Return whether a macro of the package's own registers classes: then it is unknown which."""
    sources = tuple(sources)
    bodies = [define.body for file in sources for define in file.defines]
    is_in_macro = any(MACRO in body or "CLASS_LOADER_REGISTER" in body for body in bodies)
    return is_in_macro or any(True for file in sources for _ in file.calls_to("CLASS_LOADER_REGISTER_CLASS"))


def name_of(argument: CppArgument) -> str:
    return "".join(argument.text.split())
