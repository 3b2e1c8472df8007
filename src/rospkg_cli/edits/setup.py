"""How setup.py is changed: a text, an argument, an item of a list; everything else stays as it stands."""

from __future__ import annotations

import re
from fnmatch import fnmatchcase

from ..finding import Create, Edit, Operation
from ..model.evaluate.values import Argument, Globbed, Mapping, Sequence, Symbol, Text
from ..model.setup.data_files import DataFile
from ..model.setup.packages import Search
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


def install_marker(setup: SetupPy, name: str, wrong: DataFile | None, *, absent: bool) -> tuple[Operation, ...]:
    """Install `resource/<name>` as the marker, in the place of another one where there is one."""
    create = (Create(f"resource/{name}", ""),) if absent else ()
    if wrong is not None:
        edits = replace_text(wrong.said, f"resource/{name}")
        return (*edits, *create) if edits else ()
    own = name_code(setup, name)
    source = f"{quoted(setup, 'resource/')} + {own}" if own.isidentifier() else quoted(setup, f"resource/{name}")
    edits = add_data_entry(setup, quoted(setup, "share/ament_index/resource_index/packages"), f"[{source}]")
    return (*edits, *create) if edits else ()


LAUNCH_GLOB = "launch/*launch.[pxy][yma]*"
"""The pattern of the ROS 2 documentation: `x.launch.py`, `x_launch.py`, XML and YAML."""


def install_folder(setup: SetupPy, name: str, folder: str, files: tuple[str, ...]) -> tuple[Edit, ...]:
    """Install the files of a folder by a glob; no edit where some lie deeper than that."""
    if any(file.count("/") != folder.count("/") + 1 for file in files):
        return ()
    suffixes = {file.rpartition(".")[2] for file in files}
    pattern = f"{folder}/*.{suffixes.pop()}" if len(suffixes) == 1 else f"{folder}/*"
    if folder == "launch" and all(fnmatchcase(file, LAUNCH_GLOB) for file in files):
        pattern = LAUNCH_GLOB
    if not glob_is_known(setup):
        return ()
    edits = add_data_entry(setup, share_code(setup, name, folder), f"{glob_code(setup)}({quoted(setup, pattern)})")
    return (*edits, *import_code(setup, "glob", "glob")) if edits else ()


def glob_is_known(setup: SetupPy) -> bool:
    """Return whether `glob` is the function, the module, or still free."""
    bound = setup.names.get("glob")
    return bound is None or (isinstance(bound, Symbol) and bound.name in ("glob", "glob.glob"))


def glob_code(setup: SetupPy) -> str:
    bound = setup.names.get("glob")
    return "glob.glob" if isinstance(bound, Symbol) and bound.name == "glob" else "glob"


def widen_glob(setup: SetupPy, glob: Globbed, path: str) -> tuple[Edit, ...]:
    """Let a glob of launch files find one more, where its pattern is a plain text."""
    code = setup.source.slice(glob.span)
    at = code.find(glob.pattern)
    if not fnmatchcase(path, LAUNCH_GLOB) or path.count("/") != 1 or at < 0 or code.count(glob.pattern) != 1:
        return ()
    if not all(fnmatchcase(match, LAUNCH_GLOB) for match in glob.matches):
        return ()
    start = glob.span.start + at
    return (Edit(setup.path, Span(start, start + len(glob.pattern)), LAUNCH_GLOB),)


def drop_source(setup: SetupPy, file: DataFile) -> tuple[Edit, ...]:
    """Take a file out of data_files, with its entry where it is the only one of it."""
    value = setup.value("data_files")
    if file.said.path != setup.path or not isinstance(value, Sequence) or not value.display:
        return ()
    entry = setup.data_entries[file.entry]
    if len(entry.files) == 1:
        inside = value.span.start < entry.place.start and entry.place.end < value.span.end
        return (commas.remove(setup.source, entry.place),) if inside else ()
    sources = entry.sources
    inside = sources is not None and sources.display and sources.span.start < file.place.start < sources.span.end
    return (commas.remove(setup.source, file.place),) if inside else ()


def drop_item(setup: SetupPy, argument: str, said: Said) -> tuple[Edit, ...]:
    """Take a text out of a list that is written out in setup.py."""
    value = setup.value(argument)
    if said.path != setup.path or not isinstance(value, Sequence) or not value.display:
        return ()
    places = [place for item, place in zip(value.items, value.places, strict=True) if item.span == said.span]
    inside = [place for place in places if value.span.start < place.start and place.end < value.span.end]
    return tuple(commas.remove(setup.source, place) for place in inside[:1])


def exclude_packages(setup: SetupPy, search: Search, names: list[str]) -> tuple[Edit, ...]:
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
    key = quoted(setup, "test")
    extras = setup.value("extras_require")
    if extras is None and setup.argument("extras_require") is None:
        return replace_argument(setup, "tests_require", f"extras_require={{{key}: {code}}}")
    removed = remove_argument(setup, "tests_require")
    if not isinstance(extras, Mapping) or not extras.display or not removed:
        return ()
    spans = [Span(name.span.start, value.span.end) for name, value in extras.items.values()]
    if not all(extras.span.start < span.start < span.end < extras.span.end for span in spans):
        return ()
    return (*removed, *commas.append(setup.source, extras.span, spans, f"{key}: {code}"))
