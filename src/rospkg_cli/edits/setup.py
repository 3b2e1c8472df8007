"""How setup.py is changed: a text, an argument, an item of a list; everything else stays as it stands."""

from __future__ import annotations

import re

from ..finding import Edit
from ..model.evaluate.values import Argument, Sequence, Text
from ..model.setup.said import Said
from ..model.setup.setup_py import SetupPy
from ..source import Span
from . import commas

PLAIN = re.compile(r"[^\\'\"\n\r{}]*")
"""What may stand between any quotes as it is."""


def replace_text(said: Said, text: str) -> tuple[Edit, ...]:
    """Write another text between the quotes; no edit where the text was computed or would need escapes."""
    if said.literal is None or not PLAIN.fullmatch(text):
        return ()
    return (Edit(said.path, said.literal, text),)


def quoted(setup: SetupPy, text: str) -> str:
    """Return a string in the quotes that setup.py uses most."""
    double = setup.source.text.count('"') > setup.source.text.count("'")
    shown = repr(text)
    return f'"{shown[1:-1]}"' if double and shown.startswith("'") and '"' not in text else shown


def name_code(setup: SetupPy, name: str) -> str:
    """Return the expression for the package's name: the variable that holds it, if there is one."""
    for variable, value in setup.names.items():
        if isinstance(value, Text) and value.text == name and variable != "__name__":
            return variable
    return quoted(setup, name)


def share_code(setup: SetupPy, name: str, *below: str) -> str:
    """Return the expression for a folder below `share/<name>`."""
    own = name_code(setup, name)
    rest = "".join(f"/{part}" for part in below)
    if own.isidentifier():
        start = f"{quoted(setup, 'share/')} + {own}"
        return f"{start} + {quoted(setup, rest)}" if rest else start
    return quoted(setup, f"share/{name}{rest}")


def add_item(setup: SetupPy, into: Sequence, code: str) -> tuple[Edit, ...]:
    """Put an item into a list that is written out in setup.py; no edit where it isn't."""
    if not into.display or setup.source.text[into.span.end - 1 : into.span.end] not in ("]", ")", "}"):
        return ()
    return commas.append(setup.source, into.span, into.places, code)


def add_argument(setup: SetupPy, code: str) -> tuple[Edit, ...]:
    """Give setup() another argument, behind its last one."""
    if setup.call is None:
        return ()
    start = setup.source.text.index("(", setup.call.span.start)
    brackets = Span(start, setup.call.span.end)
    return commas.append(setup.source, brackets, [argument.span for argument in own_arguments(setup)], code)


def own_arguments(setup: SetupPy) -> list[Argument]:
    """Return the arguments that are written in the call itself."""
    call = setup.call
    return [a for a in call.arguments if call.span.start < a.span.start and a.span.end < call.span.end] if call else []


def replace_argument(setup: SetupPy, name: str, code: str) -> tuple[Edit, ...]:
    """Write another argument in the place of one that is written in the call itself."""
    return tuple(Edit(setup.path, argument.span, code) for argument in own_arguments(setup) if argument.name == name)


def remove_argument(setup: SetupPy, name: str) -> tuple[Edit, ...]:
    return tuple(
        commas.remove(setup.source, argument.span) for argument in own_arguments(setup) if argument.name == name
    )


def add_data_entry(setup: SetupPy, destination: str, sources: str) -> tuple[Edit, ...]:
    """Install more: both are code."""
    code = f"({destination}, {sources})"
    value = setup.value("data_files")
    if isinstance(value, Sequence):
        return add_item(setup, value, code)
    return add_argument(setup, f"data_files=[{code}]") if value is None and setup.argument("data_files") is None else ()


def import_code(setup: SetupPy, module: str, name: str) -> tuple[Edit, ...]:
    """Import a name in alphabetical order among the imports, unless it is there."""
    bound = setup.names.get(name)
    if bound is not None:
        return ()
    line = f"from {module} import {name}\n"
    firsts = [(text, span) for text, span in import_lines(setup)]
    after = [span for text, span in firsts if text.split()[1] < module]
    at = (
        setup.source.line_starts[setup.source.position(after[-1].end)[0]]
        if after
        else firsts[0][1].start
        if firsts
        else 0
    )
    return (Edit(setup.path, Span(at, at), line),)


def import_lines(setup: SetupPy) -> list[tuple[str, Span]]:
    """Return the import statements at the top, as text and span."""
    found = []
    for node in setup.file.tree.body:
        span = setup.file.span(node)
        text = setup.source.slice(span)
        if text.startswith(("import ", "from ")):
            found.append((text, span))
        elif found:
            break
    return found


def add_package(setup: SetupPy, name: str) -> tuple[Edit, ...]:
    """List another Python package in `packages`; no edit where that is computed."""
    value = setup.value("packages")
    return add_item(setup, value, quoted(setup, name)) if isinstance(value, Sequence) else ()
