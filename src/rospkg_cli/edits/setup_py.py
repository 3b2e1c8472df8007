"""Edits of setup.py: a text, an argument, an item of a list; everything else stays as it is."""

from __future__ import annotations

import ast

from ..finding import Edit
from ..languages.python.evaluate.values import Argument, Mapping, Sequence, Text
from ..lazy_regex import regex
from ..package.setup.find_packages import PackageSearch
from ..package.setup.setup_py import SetupPy
from ..package.setup.setup_text import SetupText
from ..source import Span
from . import python_list as commas
from .python_imports import import_lines, import_module

PLAIN = regex(r"[^\\'\"\n\r{}]*")
"""What may stand between any quotes as it is."""


def replace_text(said: SetupText, text: str) -> tuple[Edit, ...]:
    """Write another text between the quotes; no edit where the text was computed or would need escapes."""
    if said.literal is None or not PLAIN.fullmatch(text):
        return ()
    return (Edit(said.path, said.literal, text),)


def quoted(setup: SetupPy, text: str) -> str:
    """Return a string in the quotes that setup.py uses most."""
    double = setup.source.text.count('"') > setup.source.text.count("'")
    shown = repr(text)
    return f'"{shown[1:-1]}"' if double and shown.startswith("'") and '"' not in text else shown


def quoted_as(setup: SetupPy, code: str, text: str) -> str:
    """Return a string in the quotes of some code, or in those that setup.py uses most where it has both or none."""
    marks = {"'", '"'} & set(code)
    return f"{mark}{text}{mark}" if len(marks) == 1 and (mark := marks.pop()) not in text else quoted(setup, text)


def name_code(setup: SetupPy, name: str) -> str:
    """Return the expression for the package's name: the variable that holds it, if there is one."""
    for variable, value in setup.names.items():
        if isinstance(value, Text) and value.text == name and variable != "__name__":
            return variable
    return quoted(setup, name)


def add_item(setup: SetupPy, into: Sequence, code: str) -> tuple[Edit, ...]:
    """Add an item to a list that is written out in setup.py; no edit where it isn't."""
    if not into.is_display or setup.source.text[into.span.end - 1 : into.span.end] not in ("]", ")", "}"):
        return ()
    return commas.append(setup.source, into.span, into.places, code)


def add_argument(setup: SetupPy, code: str) -> tuple[Edit, ...]:
    """Give setup() another argument, behind its last one.

    The edit takes a character of the text with it, so that no two arguments are added at once: it might be the same.
    """
    if setup.call is None:
        return ()
    text, start = setup.source.text, setup.source.text.index("(", setup.call.span.start)
    brackets = Span(start, setup.call.span.end)
    *others, last = commas.append(setup.source, brackets, [argument.span for argument in own_arguments(setup)], code)
    if last.span.start < last.span.end:
        return (*others, last)
    at = last.span.start
    return (*others, Edit(last.path, Span(at - 1, at), text[at - 1 : at] + last.text))


def own_arguments(setup: SetupPy) -> list[Argument]:
    """Return the arguments that are written in the call itself."""
    call = setup.call
    return [a for a in call.arguments if call.span.start < a.span.start < call.span.end] if call else []


def replace_argument(setup: SetupPy, name: str, code: str) -> tuple[Edit, ...]:
    """Write another argument in the place of one that is written in the call itself."""
    return tuple(Edit(setup.path, argument.span, code) for argument in own_arguments(setup) if argument.name == name)


def remove_argument(setup: SetupPy, name: str) -> tuple[Edit, ...]:
    return tuple(
        commas.remove(setup.source, argument.span) for argument in own_arguments(setup) if argument.name == name
    )


def import_code(setup: SetupPy, module: str, name: str) -> tuple[Edit, ...]:
    """Import a name in alphabetical order among the imports, unless it is there."""
    bound = setup.names.get(name)
    if bound is not None:
        return ()
    line = f"from {module} import {name}\n"
    firsts = [(text, span) for text, span in import_lines(setup.file)]
    after = [span for text, span in firsts if text.split()[1] < module]
    at = (
        setup.source.line_starts[setup.source.position(after[-1].end)[0]]
        if after
        else firsts[0][1].start
        if firsts
        else 0
    )
    return (Edit(setup.path, Span(at, at), line),)


def import_name(setup: SetupPy, module: str, name: str) -> tuple[Edit, ...]:
    """Import a name with others of its module, where some are imported already, or by a line of its own."""
    for node in setup.file.tree.body:
        if isinstance(node, ast.ImportFrom) and node.module == module and not node.level:
            at = setup.file.span(node.names[0]).start
            return (Edit(setup.path, Span(at, at), f"{name}, "),)
    return import_code(setup, module, name)


def add_packages(setup: SetupPy, *names: str) -> tuple[Edit, ...]:
    """List other Python packages in `packages`; no edit where that is computed."""
    value = setup.value("packages")
    code = ", ".join(quoted(setup, name) for name in names)
    return add_item(setup, value, code) if isinstance(value, Sequence) else ()


def remove_item(setup: SetupPy, argument: str, said: SetupText) -> tuple[Edit, ...]:
    """Remove a text from a list that is written out in setup.py."""
    value = setup.value(argument)
    if said.path != setup.path or not isinstance(value, Sequence) or not value.is_display:
        return ()
    places = [place for item, place in zip(value.items, value.places, strict=True) if item.span == said.span]
    inside = [place for place in places if value.span.start < place.start and place.end < value.span.end]
    return tuple(commas.remove(setup.source, place) for place in inside[:1])


def exclude_packages(setup: SetupPy, search: PackageSearch, names: list[str]) -> tuple[Edit, ...]:
    """Let find_packages() pass over some names."""
    if search.call is None:
        return ()
    code = ", ".join(quoted(setup, name) for name in names)
    given = search.call.get("exclude", 1)
    if isinstance(given, Sequence):
        return add_item(setup, given, code)
    brackets = Span(setup.source.text.index("(", search.span.start), search.span.end)
    return commas.append(setup.source, brackets, [a.span for a in search.call.arguments], f"exclude=[{code}]")


def move_tests_require(setup: SetupPy) -> tuple[Edit, ...]:
    """Write what `tests_require` says into `extras_require`, under `test`."""
    code = setup.source.slice(setup.value_span("tests_require"))
    key = quoted_as(setup, code, "test")
    extras = setup.value("extras_require")
    if extras is None and setup.argument("extras_require") is None:
        return replace_argument(setup, "tests_require", f"extras_require={{{key}: {code}}}")
    removed = remove_argument(setup, "tests_require")
    if not isinstance(extras, Mapping) or not extras.is_display or not removed:
        return ()
    spans = [Span(name.span.start, value.span.end) for name, value in extras.items.values()]
    if not all(extras.span.start < span.start < span.end < extras.span.end for span in spans):
        return ()
    return (*removed, *commas.append(setup.source, extras.span, spans, f"{key}: {code}"))


def import_standard(setup: SetupPy, line: str) -> tuple[Edit, ...]:
    """Add an import of the standard library, at the start where setup.py has no other import."""
    return import_module(setup.file, line) or (Edit(setup.path, Span(0, 0), f"{line}\n"),)
