"""Changing packages that exist: in memory first, judged by lint before and after, then all of it or nothing."""

from __future__ import annotations

from ..light_dataclasses import dataclass
from ..user_error import UserError


class ChangeError(UserError):
    """What can't be done as asked: one sentence that says why and what to do, and perhaps lines to show below it."""

    def __init__(self, sentence: str, details: tuple[str, ...] = ()) -> None:
        super().__init__(sentence)
        self.details = details


@dataclass(frozen=True)
class Paste:
    """Lines for a person to put into a file."""

    path: str
    lines: str


class NotUnderstoodError(ChangeError):
    """A file whose form is not understood: what to paste into it is shown, and nothing is written."""

    def __init__(self, sentence: str, *pastes: Paste) -> None:
        super().__init__(sentence, tuple(line for paste in pastes for line in shown_paste(paste)))


def shown_paste(paste: Paste) -> list[str]:
    return [f"{paste.path}:", *(f"    {line}".rstrip() for line in paste.lines.split("\n"))]
