"""The entry point of an executable: in setup.py, in setup.cfg, or in pyproject.toml, wherever the others are."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ..change import ChangeError, NotUnderstoodError, Paste
from ..edits.list_item import append_item, removals
from ..edits.setup_py import own_arguments, quoted
from ..languages.python.evaluate.values import Mapping, Sequence
from ..light_dataclasses import dataclass
from ..package.package import Package
from ..package.setup.entry_point import EntryPoint
from ..package.setup.setup_py import SetupPy
from ..source import Span
from .entry_point_texts import text_place
from .part import Operations

GROUP = "console_scripts"


@dataclass(frozen=True)
class ExecutableEntry:
    """`name = module:attribute` among the console scripts."""

    name: str
    module: str
    attribute: str = "main"

    def add(self, package: Package) -> Operations:
        """Return the edits; raises ChangeError where the name is taken, NotUnderstoodError with the line to paste."""
        setup = setup_of(package)
        found = next((each for each in setup.entry_points if each.is_script and each.name == self.name), None)
        if found is not None:
            if (found.module, found.attribute) != (self.module, self.attribute):
                raise ChangeError(f"{found.path} has an executable `{self.name}` already; choose another name")
            return ()
        if self.is_pasted(package):
            return ()
        text = text_place(package, setup)
        if text is not None:
            return text.add(self.name, f"{self.module}:{self.attribute}")
        edits = self.in_list(setup) or self.in_mapping(setup) or self.in_call(setup)
        if not edits:
            line = f"'{self.name} = {self.module}:{self.attribute}',"
            raise NotUnderstoodError(
                f"`{self.name}` can't be put among the entry points, which are computed: put the lines where they "
                "belong, and run the command again",
                Paste("setup.py, in entry_points['console_scripts']", line),
            )
        return edits

    def is_pasted(self, package: Package) -> bool:
        """Return whether a file that is not understood holds the line."""
        wanted = rf"{re.escape(self.name)}\s*=\s*[\"']?{re.escape(self.module)}:{self.attribute}\b"
        files = ("setup.py", "setup.cfg", "pyproject.toml")
        return any(re.search(wanted, package.files.readable_text(path)) for path in files if package.files.exists(path))

    def code(self, setup: SetupPy, like: EntryPoint | None) -> str:
        """Return the string in the quotes and with the blanks of another one."""
        blank = " "
        if like is not None and like.setup_text.literal is not None:
            before = like.text[: like.text.find("=") + 2]
            blank = "" if re.match(r"\S+=\S", before) else " "
            literal = like.setup_text.literal
            quote = setup.source.text[literal.start - 1 : literal.start]
            if quote in ("'", '"'):
                return f"{quote}{self.name}{blank}={blank}{self.module}:{self.attribute}{quote}"
        return quoted(setup, f"{self.name}{blank}={blank}{self.module}:{self.attribute}")

    def in_list(self, setup: SetupPy) -> Operations:
        """Return the edit of a list that is written out: that of the last console script, or an empty one."""
        scripts = [each for each in setup.entry_points if each.group == GROUP and each.list_value is not None]
        like = scripts[-1] if scripts else None
        target = like.list_value if like else self.empty_list(setup)
        if target is None or not is_written(setup, target):
            return ()
        return append_item(setup.source, target.span, target.places, self.code(setup, like))

    def empty_list(self, setup: SetupPy) -> Sequence | None:
        value = setup.value("entry_points")
        found = value.get(GROUP) if isinstance(value, Mapping) else None
        return found if isinstance(found, Sequence) and not found.items else None

    def in_mapping(self, setup: SetupPy) -> Operations:
        """Return the edit of a dict that is written out and has no console scripts yet."""
        value = setup.value("entry_points")
        if not isinstance(value, Mapping) or value.rest or GROUP in value.items or not is_written(setup, value):
            return ()
        spans = [Span(key.span.start, item.span.end) for key, item in value.items.values()]
        return append_item(setup.source, value.span, spans, f"{quoted(setup, GROUP)}: [{self.code(setup, None)}]")

    def in_call(self, setup: SetupPy) -> Operations:
        """Return a new argument of setup()."""
        if setup.call is None or setup.argument("entry_points") is not None or setup.call.rest is not None:
            return ()
        if setup.value("entry_points") is not None:
            return ()
        start = setup.source.text.index("(", setup.call.span.start)
        code = f"entry_points={{{quoted(setup, GROUP)}: [{self.code(setup, None)}]}}"
        spans = [argument.span for argument in own_arguments(setup)]
        return append_item(setup.source, Span(start, setup.call.span.end), spans, code)

    def remove(self, package: Package) -> Iterator[Operations]:
        """Yield the ways to take out the entry, with its list, dict or argument where it is alone in it."""
        setup = setup_of(package)
        text = text_place(package, setup)
        if text is not None and (found := text.removals(self.name)):
            yield from found
            return
        for entry in setup.entry_points:
            if entry.is_script and entry.name == self.name and entry.list_value is not None:
                yield from self.wider_removals(setup, entry, entry.list_value)

    def wider_removals(self, setup: SetupPy, entry: EntryPoint, place: Sequence) -> Iterator[Operations]:
        """Yield the removal of the item, of the key and of the argument that hold nothing else: the likeliest first."""
        if entry.path != setup.path or not is_written(setup, place):
            return
        value, source = setup.value("entry_points"), setup.source
        ways = [removals(source, entry.position)]
        if len(place.items) == 1 and isinstance(value, Mapping) and is_written(setup, value):
            key, item = value.items[GROUP]
            of_key = Span(key.span.start, item.span.end)
            ways.append(removals(source, of_key))
            alone = len(value.items) == 1
            whole = [each.span for each in own_arguments(setup) if each.name == "entry_points" and alone]
            ways += [removals(source, span) for span in whole]
            if not alone or any("\n" not in source.slice(span) for span in whole):
                ways.reverse()  # as `add` writes it where there is none: the group, or the argument, in one line
        for way in ways:
            yield from way


def setup_of(package: Package) -> SetupPy:
    """Return setup.py; raises ChangeError where it can't be read."""
    setup = package.parts(SetupPy).only
    if setup is None:
        raise ChangeError("the package has no setup.py that can be read; `rospkg lint` says why")
    return setup


def is_written(setup: SetupPy, value: Sequence | Mapping) -> bool:
    """Return whether a list or dict is written out, with its brackets, in setup.py."""
    ends = setup.source.text[value.span.end - 1 : value.span.end]
    return value.is_display and ends in ("]", ")", "}")
