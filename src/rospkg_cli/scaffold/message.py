"""The message, service or action that a node uses."""

from __future__ import annotations

import re

from ..light_dataclasses import dataclass

CALLED = {"msg": "message", "srv": "service", "action": "action"}


@dataclass(frozen=True)
class MessageField:
    """A field that a node sets: where, what it is, and the first value in each language."""

    path: str
    type: str
    python: str
    cpp: str


@dataclass(frozen=True)
class Message:
    package: str
    name: str
    parts: tuple[tuple[MessageField, ...], ...] = ()
    """The fields of a message, of request and response, or of goal, result and feedback: as far as they are known, and
    as far as a node knows what to write there."""
    form: str = "msg"
    """`msg`, `srv` or `action`."""

    def part(self, number: int) -> tuple[MessageField, ...]:
        return self.parts[number] if number < len(self.parts) else ()

    @property
    def topic(self) -> str:
        """The name of its topic, service or action, where no other one was asked for."""
        return self.header

    @property
    def header(self) -> str:
        """The name in lower case, as rosidl makes it for the header."""
        words = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", self.name)
        return re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", words).lower()

    @property
    def full_name(self) -> str:
        return f"{self.package}/{self.form}/{self.name}"


def is_message(word: str) -> bool:
    """Return whether a part of a node's description names an interface, and no kind and no language."""
    word = word.partition("@")[0]
    return "/" in word or word[:1].isupper()


def a_form(form: str) -> str:
    return f"an {CALLED[form]}" if form == "action" else f"a {CALLED[form]}"


def called(message: Message) -> str:
    return CALLED[message.form]
