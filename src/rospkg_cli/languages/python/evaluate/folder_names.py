"""The name of the package's own folder in what setup.py passes: the evaluated code runs in a folder of no such name."""

from __future__ import annotations

from ....light_dataclasses import replace
from .sandbox_filesystem import ROOT
from .values import Call, Mapping, Sequence, Text, Unknown, Value

NAME = ROOT.lstrip("/")
DEEPEST = 20
"""How deep lists are looked through; `data_files` has three levels."""
WHY = "the folder's name is not known here"


def without_folder_names(call: Call) -> Call:
    """Return a call in which every text that holds the folder's name is unknown; absolute paths are as they were."""
    return replace(call, arguments=tuple(replace(each, value=cleared(each.value)) for each in call.arguments))


def cleared(value: Value, depth: int = 0) -> Value:
    if isinstance(value, Text):
        return Unknown(value.span, WHY) if holds_name(value.text) else value
    if depth == DEEPEST or not holds_any(value, depth):
        return value
    if isinstance(value, Sequence):
        return replace(value, items=[cleared(each, depth + 1) for each in value.items])
    if isinstance(value, Mapping):
        items = {key: (name, cleared(each, depth + 1)) for key, (name, each) in value.items.items()}
        return replace(value, items=items)
    return value


def holds_any(value: Value, depth: int) -> bool:
    if isinstance(value, Text):
        return holds_name(value.text)
    if depth == DEEPEST:
        return False
    inner = value.items if isinstance(value, Sequence) else []
    inner = [each for _, each in value.items.values()] if isinstance(value, Mapping) else inner
    return any(holds_any(each, depth + 1) for each in inner)


def holds_name(text: str) -> bool:
    return NAME in (text[len(ROOT) :] if text.startswith(ROOT) else text)
