"""Edits of data_files in setup.py: add an entry, remove a file, widen a glob."""

from __future__ import annotations

from fnmatch import fnmatchcase

from ..finding import Create, Edit, Operation
from ..languages.python.evaluate.values import GlobResult, Sequence, Symbol
from ..lazy_regex import regex
from ..package.setup.data_files import DataFile
from ..package.setup.setup_py import SetupPy
from ..package.setup.setup_text import SetupText
from ..source import Span
from . import python_list as commas
from .setup_py import add_argument, add_item, import_standard, name_code, own_arguments, quoted, replace_text

SHARE = regex(
    r"""\bf["']share/\{(?P<name>\w+)\}|(?P<join>[\w.]*\bjoin)\(\s*["']share["']\s*,\s*(\w+)"""
    r"""|["']share/["']\s*\+\s*(\w+)"""
)
"""The ways in which destinations below `share/` are written."""


def share_code(setup: SetupPy, name: str, *below: str) -> str:
    """Return the expression for a folder below `share/<name>`, as the last entry before it writes one."""
    own = name_before_entries(setup, name)
    rest = "".join(f"/{part}" for part in below)
    if own.isidentifier():
        style = share_style(setup, own)
        if style == "f":
            return "f" + quoted(setup, f"share/{{{own}}}{rest}")
        if style:
            return f"{style}({', '.join([quoted(setup, 'share'), own, *(quoted(setup, part) for part in below)])})"
        start = f"{quoted(setup, 'share/')} + {own}"
        return f"{start} + {quoted(setup, rest)}" if rest else start
    return quoted(setup, f"share/{name}{rest}")


def replace_destination(setup: SetupPy, name: str, said: SetupText, right: str) -> tuple[Edit, ...]:
    """Write another destination: built as the others are, where it is a plain text and they are not."""
    share, own, *below = [*right.split("/"), ""]
    variable = name_before_entries(setup, name)
    is_plain = said.literal is not None and said.literal.end - said.literal.start + 2 == said.span.end - said.span.start
    if is_plain and (share, own) == ("share", name) and variable.isidentifier() and share_style(setup, variable):
        return (Edit(said.path, said.span, share_code(setup, name, *filter(None, below))),)
    return replace_text(said, right)


def share_style(setup: SetupPy, own: str) -> str:
    """Return how the last entry builds its destination of a variable: "f", the function that joins paths, or ""."""
    entries = setup.value("data_files")
    code = setup.source.slice(entries.span) if entries is not None else ""
    found = [each for each in SHARE.finditer(code) if own in each.groups()]
    return ("f" if found[-1]["name"] else found[-1]["join"] or "") if found else ""


def name_before_entries(setup: SetupPy, name: str) -> str:
    """Return the expression for the package's name in data_files: no variable that is set behind that list."""
    code, entries = name_code(setup, name), setup.value("data_files")
    held = setup.names.get(code)
    late = held is not None and entries is not None and held.span.start > entries.span.start
    return quoted(setup, name) if late else code


def add_data_entry(setup: SetupPy, destination: str, sources: str) -> tuple[Edit, ...]:
    """Install more: both are code."""
    code = f"({destination}, {sources})"
    value = setup.value("data_files")
    if isinstance(value, Sequence):
        return add_item(setup, value, code)
    if value is not None or setup.argument("data_files") is not None:
        return ()
    arguments = [each.span.start for each in own_arguments(setup)]
    if not arguments or not commas.begins_line(setup.source, arguments[-1]):
        return add_argument(setup, f"data_files=[{code}]")
    indent = commas.indent_of(setup.source, arguments[-1])
    return add_argument(setup, f"data_files=[\n{commas.deeper(indent)}{code},\n{indent}]")


def install_marker(setup: SetupPy, name: str, wrong: DataFile | None, *, absent: bool) -> tuple[Operation, ...]:
    """Install `resource/<name>` as the marker, in the place of another one where there is one."""
    create = (Create(f"resource/{name}", ""),) if absent else ()
    if wrong is not None:
        edits = replace_text(wrong.setup_text, f"resource/{name}")
        return (*edits, *create) if edits else ()
    own = name_before_entries(setup, name)
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
    imported = import_standard(setup, "from glob import glob") if setup.names.get("glob") is None else ()
    return (*edits, *imported) if edits else ()


def glob_is_known(setup: SetupPy) -> bool:
    """Return whether `glob` is the function, the module, or still free."""
    bound = setup.names.get("glob")
    return bound is None or (isinstance(bound, Symbol) and bound.name in ("glob", "glob.glob"))


def glob_code(setup: SetupPy) -> str:
    bound = setup.names.get("glob")
    return "glob.glob" if isinstance(bound, Symbol) and bound.name == "glob" else "glob"


def widen_glob(setup: SetupPy, glob: GlobResult, path: str) -> tuple[Edit, ...]:
    """Let a glob of launch files find one more, where its pattern is a plain text."""
    code = setup.source.slice(glob.span)
    at = code.find(glob.pattern)
    if not fnmatchcase(path, LAUNCH_GLOB) or path.count("/") != 1 or at == -1 or code.count(glob.pattern) != 1:
        return ()
    if not all(fnmatchcase(match, LAUNCH_GLOB) for match in glob.matches):
        return ()
    start = glob.span.start + at
    return (Edit(setup.path, Span(start, start + len(glob.pattern)), LAUNCH_GLOB),)


def remove_source(setup: SetupPy, file: DataFile) -> tuple[Edit, ...]:
    """Remove a file from data_files, with its entry where it is the only one of it."""
    value = setup.value("data_files")
    if file.setup_text.path != setup.path or not isinstance(value, Sequence) or not value.is_display:
        return ()
    entry = setup.data_entries[file.entry]
    if len(entry.files) == 1:
        inside = value.span.start < entry.position.start < value.span.end
        return (commas.remove(setup.source, entry.position),) if inside else ()
    sources = entry.sources
    inside = sources is not None and sources.is_display and sources.span.start < file.position.start < sources.span.end
    return (commas.remove(setup.source, file.position),) if inside else ()
