"""The name of the package's own folder in what setup.py passes: the evaluated code runs in a folder of no such name."""

from __future__ import annotations

from operator import is_

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
    """Return a value, itself where nothing in it holds the name."""
    if isinstance(value, Text) and holds_name(value.text):
        return Unknown(value.span, WHY)
    if isinstance(value, Sequence) and depth < DEEPEST:
        items = [cleared(each, depth + 1) for each in value.items]
        return value if all(map(is_, items, value.items)) else replace(value, items=items)
    if isinstance(value, Mapping) and depth < DEEPEST:
        pairs = {key: (name, cleared(each, depth + 1)) for key, (name, each) in value.items.items()}
        is_same = all(pairs[key][1] is each for key, (_, each) in value.items.items())
        return value if is_same else replace(value, items=pairs)
    return value


def holds_name(text: str) -> bool:
    return NAME in (text[len(ROOT) :] if text.startswith(ROOT) else text)
