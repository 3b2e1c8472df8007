"""PRM001: a missing or misspelt `ros__parameters:` below the name of a node."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.yaml.nodes import MappingNode, ScalarNode
from ...lazy_regex import regex
from ...package.params.node_entries import KEY, below, is_key, is_misspelt_key
from ...package.params.parameter_file import ParameterFile
from ...source import Source, Span
from ..enumeration import in_ticks
from ..fault import Fault, TextRepair, joined
from .rcl_values import REFUSES

COMMENT = regex(r"[ \t]*(?:#.*)?\r?")
TITLE = f"write `{KEY}:`"


def key_faults(file: ParameterFile, *, is_parsed_by_launch: bool = False) -> Iterator[Fault]:
    """Yield each misspelt key, and the blocks without one as one fault: rcl refuses the file at the first."""
    lacking: list[tuple[str, Fault]] = []
    for entry in file.entries:
        key, value = entry.key, entry.value
        if not isinstance(key, ScalarNode):
            continue
        if entry.kind == "block" and not is_key(key):
            repair = TextRepair(TITLE, ((key.span, KEY),))
            how = "" if "__" in key.text else ", with two `_`"
            yield Fault(key.span, f"`{key.text}` is written `{KEY}`{how}; {REFUSES}", repair=repair)
        elif entry.kind == "no block" and isinstance(value, MappingNode) and not is_parsed_by_launch:
            lacking.append((key.text, Fault(key.span, "", repair=added_key(file.source, key, value))))
    for key in nested_slips(file):
        message = f"`{key.text}` is written `{KEY}`, as in the other blocks here; what looks for it finds no block"
        yield Fault(key.span, message, "warning", TextRepair(TITLE, ((key.span, KEY),)))
    if lacking:
        blocks = in_ticks(name for name, _ in lacking)
        start = f"the block of {blocks} has" if len(lacking) == 1 else f"the blocks of {blocks} have"
        yield joined([fault for _, fault in lacking], f"{start} no `{KEY}:` above the values; {REFUSES}", TITLE)


def nested_slips(file: ParameterFile) -> Iterator[ScalarNode]:
    """Yield the misspelt keys among the values of a node that hold blocks for others, as system_modes has them."""
    for block in file.blocks:
        mappings = [each for each in below(block.value) if isinstance(each, MappingNode)]
        keys = [key for each in mappings for key, value in each.entries if isinstance(value, MappingNode)]
        if any(is_key(key) for key in keys):
            yield from (key for key in keys if isinstance(key, ScalarNode) and is_misspelt_key(key))


def added_key(source: Source, key: ScalarNode, value: MappingNode) -> TextRepair | None:
    """Return the repair that writes `ros__parameters:` above a block; None where the block is in braces.

    A namespace may be intended.
    """
    text, first = source.text, value.entries[0][0].span.start
    start = text.rfind("\n", 0, first) + 1
    if text[value.span.start] == "{" or text[start:first].strip() or start <= key.span.end:
        return None
    end = first + len(text[first : value.span.end].rstrip())
    indent = text[start:first]
    while (last := text.rfind("\n", start, end)) != -1 and COMMENT.fullmatch(text, last + 1, end):
        if len(text[last + 1 : end]) - len(text[last + 1 : end].lstrip()) >= len(indent):
            break  # a comment of the block
        end = len(text[:last].rstrip())
    lines = [f"  {line}" if line.strip() else line for line in text[start:end].split("\n")]
    return TextRepair(TITLE, ((Span(start, end), "\n".join([f"{indent}{KEY}:", *lines])),), is_certain=False)
