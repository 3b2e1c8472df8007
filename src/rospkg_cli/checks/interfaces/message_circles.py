"""Messages that contain themselves, directly or by way of others of their package."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.interfaces.interface_file import FieldType, InterfaceFile
from .package_interfaces import PackageInterfaces

Step = tuple[InterfaceFile, FieldType]
"""A message, and its field that leads on."""


@dataclass(frozen=True)
class MessageCircles:
    package: PackageInterfaces

    def all(self) -> Iterator[tuple[Step, ...]]:
        """Yield the shortest circle of each message that is in one, unless a message of it was in one before."""
        seen: set[str] = set()
        for name in sorted(self.messages):
            circle = self.circle(name) if name not in seen else ()
            if circle and seen.isdisjoint(message.name for message, _ in circle):
                yield circle
            seen |= {message.name for message, _ in circle}

    def circle(self, name: str) -> tuple[Step, ...]:
        """Return the steps from a message back to itself; nothing where it contains no circle."""
        ways: dict[str, tuple[Step, ...]] = {}
        waiting: list[tuple[str, tuple[Step, ...]]] = [(name, ())]
        while waiting:
            at, way = waiting.pop(0)
            for kind in self.parts(at):
                on = (*way, (self.messages[at], kind))
                if kind.base == name:
                    return on
                if kind.base not in ways:
                    ways[kind.base] = on
                    waiting.append((kind.base, on))
        return ()

    def parts(self, name: str) -> Iterator[FieldType]:
        """Yield the types of the fields of a message that are messages of the package."""
        for kind in self.messages[name].types:
            if kind.package in ("", self.package.generation.package.name) and kind.base in self.messages:
                yield kind

    @cached_property
    def messages(self) -> dict[str, InterfaceFile]:
        return {each.name: each for each in self.package.read() if each.kind == "msg"}
