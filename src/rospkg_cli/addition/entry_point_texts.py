"""Entry points that are lines of a text: in setup.cfg, in pyproject.toml, in a string of setup.py."""

from __future__ import annotations

import re
from collections.abc import Sequence

from ..finding import Edit
from ..languages.python.evaluate.values import Text
from ..light_dataclasses import dataclass
from ..package.package import Package
from ..package.setup.setup_py import SetupPy
from ..source import Source, Span
from .part import Operations

SECTION = "options.entry_points"
TABLE = re.compile(r"^\[project\.scripts\][ \t]*(?:#.*)?$", re.MULTILINE)
PROJECT = re.compile(r"^\[project\]", re.MULTILINE)
NEXT_TABLE = re.compile(r"^[ \t]*\[", re.MULTILINE)


@dataclass(frozen=True)
class TextPlace:
    """A place in a text below whose last line another one is put."""

    source: Source
    at: int
    """Where the last line ends."""
    form: str
    """How a line is written, with `{name}` and `{target}`; it begins with what parts it from the line before."""

    def add(self, name: str, target: str) -> Operations:
        line = self.form.replace("{name}", name).replace("{target}", target)
        return (Edit(self.source.path, Span(self.at, self.at), line),)

    def removals(self, name: str) -> Sequence[Operations]:
        """Return the ways to take out the line of a name: with what `add` put before it, or the line alone."""
        head, _, _ = self.form.replace("{name}", name).partition("{target}")
        heads = [*header_forms(self.form, name), head]
        found: list[Operations] = []
        for each in heads:
            at = self.source.text.rfind(each)
            if at >= 0:
                end = self.source.text.find("\n", at + len(each))
                stop = len(self.source.text) if end < 0 else end
                found.append((Edit(self.source.path, Span(at, stop), ""),))
        return found


def header_forms(form: str, name: str) -> list[str]:
    """Return what precedes the target where the line was the first of its section."""
    line = form.rpartition("\n")[2].replace("{name}", name).partition("{target}")[0]
    return [
        f"\n\n[project.scripts]\n{line}",
        f"\n\n[{SECTION}]\nconsole_scripts =\n{line}",
        f"\nconsole_scripts =\n{line}",
    ]


def text_place(package: Package, setup: SetupPy) -> TextPlace | None:
    """Return where the entry points are lines of a text; None where they are a dict in setup.py, or belong there."""
    value = setup.value("entry_points")
    if isinstance(value, Text):
        return in_string(setup, value)
    if setup.argument("entry_points") is not None:
        return None
    return in_pyproject(package) or in_cfg(setup)


def in_string(setup: SetupPy, value: Text) -> TextPlace | None:
    """Return the place behind the last console script of a string in setup.py."""
    entries = [each for each in setup.entry_points if each.group == "console_scripts"]
    if value.literal is None or not entries or entries[-1].setup_text.literal is None:
        return None
    return below(setup.source, entries[-1].setup_text.span)


def below(source: Source, last: Span, indent: str | None = None) -> TextPlace:
    """Return the place below a line, whose indentation and blanks are kept."""
    line = source.line_span(source.position(last.start)[0])
    blanks = source.text[line.start : last.start] if indent is None else indent
    blank = "" if re.match(r"[^\s=]+=\S", source.slice(last)) else " "
    return TextPlace(source, last.end, f"\n{blanks}{{name}}{blank}={blank}{{target}}")


def in_cfg(setup: SetupPy) -> TextPlace | None:
    """Return the place in setup.cfg, where it has entry points, or setup() has no arguments of its own."""
    cfg = setup.cfg
    if cfg is None:
        return None
    section = cfg.sections.get(SECTION)
    option = section.options.get("console_scripts") if section else None
    if option is not None:
        lines = option.value.lines()
        if lines and "\n" in cfg.source.text[option.key_span.end : lines[-1].span.start]:
            return below(cfg.source, lines[-1].span)
        return below(cfg.source, lines[-1].span if lines else option.span, "    ")
    if section is not None:
        end = max([section.span.end, *(each.span.end for each in section.options.values())])
        return TextPlace(cfg.source, end, "\nconsole_scripts =\n    {name} = {target}")
    if setup.call is not None and not setup.call.arguments and setup.call.rest is None:
        end = len(cfg.source.text.rstrip())
        return TextPlace(cfg.source, end, f"\n\n[{SECTION}]\nconsole_scripts =\n    {{name}} = {{target}}")
    return None


def in_pyproject(package: Package) -> TextPlace | None:
    """Return the place in the table of scripts of pyproject.toml, where that has the metadata of the project."""
    if not package.files.exists("pyproject.toml"):
        return None
    source = package.files.source("pyproject.toml")
    found = TABLE.search(source.text)
    form = '{name} = "{target}"'
    if found is None:
        end = len(source.text.rstrip())
        return TextPlace(source, end, f"\n\n[project.scripts]\n{form}") if PROJECT.search(source.text) else None
    after = NEXT_TABLE.search(source.text, found.end())
    inside = source.text[found.end() : after.start() if after else len(source.text)]
    return TextPlace(source, found.end() + len(inside.rstrip()), f"\n{form}")
