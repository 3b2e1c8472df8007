"""From a template and answers to files in memory."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from jinja2 import Environment

from ..light_dataclasses import dataclass
from ..tree import TreeEntry
from . import ScaffoldError
from .answers import Answers
from .bounds import MAX_FILES, text_of
from .template import Template, TemplateFile
from .template_context import template_context
from .template_environment import make_environment
from .template_errors import in_value

LONGEST_NAME = 200
"""Bytes of a file's name; most disks take 255, and a temporary name is longer."""

DEEPEST = 20


@dataclass(frozen=True)
class RenderedFile:
    """One file that is to be written; `path` is relative to the package."""

    path: str
    entry: TreeEntry
    about: str


def render(template: Template, answers: Answers, more: Mapping[str, object] | None = None) -> tuple[RenderedFile, ...]:
    """Return every file, sorted by path; raises ScaffoldError where two have one path.

    `more` are values for the files in addition to the answers.
    """
    environment = make_environment(template)
    bracketed = make_environment(template, brackets=True)
    values = {**template_context(answers), **(more or {})}
    files: dict[str, RenderedFile] = {}
    for file in template.files:
        for extra in items(environment, file, values):
            one = render_file(environment, file, {**values, **extra}, bracketed if file.brackets else environment)
            if len(files) >= MAX_FILES:
                raise ScaffoldError(f"the template would write more than {MAX_FILES} files")
            if one.path in files:
                raise ScaffoldError(f"two files would have the name `{one.path}`; choose other names for the nodes")
            files[one.path] = one
    return tuple(files[path] for path in sorted(files))


def items(environment: Environment, file: TemplateFile, values: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Yield the additional values of a file, once for each time that it is written."""
    singular = file.each.rpartition("_")[2].removesuffix("s")
    for extra in [{singular: item} for item in values[file.each]] if file.each else [{}]:
        with in_value(file.when):
            wanted = not file.when or holds(environment, file.when, {**values, **extra})
        if wanted:
            yield extra


def render_file(
    environment: Environment, file: TemplateFile, values: dict[str, Any], of_source: Environment
) -> RenderedFile:
    source = rendered(environment, file.source, values)
    text = text_of(of_source, "", values, source + ".j2")
    path = inside(rendered(environment, file.path, values))
    about = rendered(environment, file.about, values)
    mode = 0o755 if text.startswith("#!") else 0o644
    return RenderedFile(path, TreeEntry("file", text.encode(), mode), about)


def holds(environment: Environment, condition: str, values: dict[str, Any]) -> bool:
    return bool(environment.compile_expression(condition, undefined_to_none=False)(**values))


def rendered(environment: Environment, value: str, values: dict[str, Any]) -> str:
    """Return a value of template.toml with its answers filled in; raises ScaffoldError for what is no line of text."""
    with in_value(value):
        line = text_of(environment, value, values)
    if not line.isprintable():
        raise ScaffoldError(f"the template has {line!a} where a line of text is wanted")
    return line


def inside(path: str) -> str:
    """Return a path; raises ScaffoldError where it leads out of the package, or into what git keeps there."""
    parts = path.split("/")
    if {"", ".", ".."} & set(parts) or any(map(is_of_git, parts)) or set(path) & set('\\:*?"<>|'):
        raise ScaffoldError(f"the template would write `{path}`, which is no path inside of the package")
    if max(len(part.encode()) for part in parts) > LONGEST_NAME or len(parts) > DEEPEST:
        raise ScaffoldError(f"the template would write `{path}`, which is too long for a path")
    return path


def is_of_git(name: str) -> bool:
    """Return whether a disk that ignores case, or dots and blanks at the end, takes a name for `.git`."""
    return name.rstrip(". ").casefold() in (".git", "git~1")


def render_line(template: Template, line: str, answers: Answers) -> str:
    """Return a line of template.toml with its answers filled in."""
    return rendered(make_environment(template), line, template_context(answers))
