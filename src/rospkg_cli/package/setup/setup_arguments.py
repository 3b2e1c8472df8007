"""The arguments of setup() that setup.py and setup.cfg give, and their positions."""

from __future__ import annotations

from functools import cached_property

from ...languages.python.evaluate.sandbox_filesystem import SandboxFilesystem
from ...languages.python.evaluate.values import Argument, Call, Constant, Sequence, Text, Unknown, Value
from ...languages.python.file import PythonFile
from ...light_dataclasses import dataclass
from ...source import Source, Span
from .misspelt_names import MisspeltArgument, misspelt_arguments
from .setup_cfg import SetupCfg
from .setup_cfg_arguments import SetupCfgArguments
from .setup_text import SetupText


@dataclass(frozen=True)
class SetupArguments:
    file: PythonFile
    folder: SandboxFilesystem
    call: Call | None
    """The call of setup(); None where it is unknown."""
    call_unknown: Unknown | None
    """Why the call is unknown."""
    cfg: SetupCfg | None
    cfg_broken: bool
    """Whether setup.cfg is there and can't be read, or pyproject.toml may say more."""

    @property
    def source(self) -> Source:
        return self.file.source

    @property
    def path(self) -> str:
        return self.file.path

    @property
    def span(self) -> Span:
        """The span of the name `setup` in its call."""
        return Span(self.call.span.start, self.call.span.start + 5) if self.call else Span(0, 0)

    def argument(self, name: str) -> Argument | None:
        return self.call.argument(name) if self.call else None

    def name_span(self, name: str) -> Span:
        """Return the span of an argument's name; that of `setup` where the call does not have it."""
        found = self.argument(name)
        if found is None or self.call is None or not self.call.span.start < found.span.start < self.call.span.end:
            return self.span
        return Span(found.span.start, found.span.start + len(name))

    def value_span(self, name: str) -> Span:
        """Return the span of an argument's value; that of `setup` where the call does not have it."""
        found, name_at = self.argument(name), self.name_span(name)
        if found is None or name_at == self.span:
            return self.span
        equals = self.source.text.index("=", name_at.end) + 1
        blanks = len(self.source.text[equals:]) - len(self.source.text[equals:].lstrip())
        return Span(equals + blanks, found.span.end)

    def value(self, name: str) -> Value | None:
        """Return the value of an argument; None where setup.py lacks it; Unknown where it can't be evaluated."""
        if self.call is None:
            return self.call_unknown
        found = self.call.get(name)
        if found is None:
            return self.call.rest
        return None if isinstance(found, Constant) and not found.value else found

    def may_be_given_elsewhere(self, name: str) -> Unknown | None:
        """Return why a missing argument may be given in another file."""
        if self.cfg_broken:
            return Unknown(self.span, "setup.cfg can't be read, or pyproject.toml says more")
        meaning = (each.argument for each in self.misspelt_arguments if each.intended == name)
        return next((Unknown(each.span, f"`{each.name}` may stand for `{name}`") for each in meaning), None)

    @cached_property
    def misspelt_arguments(self) -> tuple[MisspeltArgument, ...]:
        """The arguments that setuptools ignores and that are misspellings of one that is not given."""
        return tuple(misspelt_arguments(self.call.arguments)) if self.call else ()

    def setup_text(self, name: str) -> SetupText | None:
        """Return a text of the metadata in setup.py or setup.cfg; None where it is unknown."""
        value = self.value(name)
        if value is None and self.cfg is not None:
            return self.from_cfg.text(name)
        return SetupText.of(self.path, value) if isinstance(value, Text) else None

    @cached_property
    def from_cfg(self) -> SetupCfgArguments:
        return SetupCfgArguments(self.cfg, self.folder)

    def texts(self, name: str) -> tuple[SetupText, ...]:
        """Return the texts of a list: those that are known."""
        value = self.value(name)
        if value is None:
            return self.from_cfg.texts(name)
        if isinstance(value, Text):
            return (SetupText.of(self.path, value),)
        items = value.items if isinstance(value, Sequence) else []
        return tuple(SetupText.of(self.path, item) for item in items if isinstance(item, Text))
