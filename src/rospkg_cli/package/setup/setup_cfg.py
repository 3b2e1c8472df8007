"""setup.cfg: its sections and options, with their positions."""

from __future__ import annotations

from ...light_dataclasses import dataclass, field
from ...source import Source, Span
from .setup_text import SetupText

COMMANDS = frozenset(
    "alias bdist bdist_dumb bdist_egg bdist_rpm bdist_wheel build build_clib build_ext build_py build_scripts check"
    " clean develop dist_info easy_install editable_wheel egg_info install install_data install_egg_info"
    " install_headers install_lib install_scripts register rotate saveopts sdist setopt test upload upload_docs".split()
)
"""The commands of distutils and setuptools, whose options are in sections of that name."""

FREE_KEYS = frozenset({"options.extras_require", "options.data_files", "options.entry_points", "options.package_data"})
"""Sections whose keys are names of the user's own."""


@dataclass(frozen=True)
class CfgOption:
    """One option, with a key in the spelling of the file."""

    key: str
    key_span: Span
    value: SetupText
    """All lines of it, without white space at both ends."""
    span: Span
    """From the first character of the key to the end of the last line of the value."""

    @property
    def name(self) -> str:
        """The key as setuptools takes it: lower case, underscores."""
        return self.key.lower().replace("-", "_")


@dataclass(frozen=True)
class CfgSection:
    name: str
    span: Span
    """Of `[name]`."""
    options: dict[str, CfgOption] = field(default_factory=dict)
    """By key as it is spelled, in order."""

    @property
    def read_by_setuptools(self) -> bool:
        """Whether its keys are options of setuptools: other tools may spell theirs as they like."""
        return self.name in COMMANDS or (self.name.startswith(("metadata", "options")) and self.name not in FREE_KEYS)


@dataclass(frozen=True)
class SetupCfg:
    source: Source
    sections: dict[str, CfgSection]

    @property
    def path(self) -> str:
        return self.source.path

    @property
    def span(self) -> Span:
        """The span of the first section's name, where findings on missing options are placed."""
        return next((section.span for section in self.sections.values()), Span(0, 0))

    def get(self, section: str, option: str) -> CfgOption | None:
        """Return an option by its name; of several spellings the last, as setuptools takes it."""
        return next((each for each in reversed(self.options(section)) if each.name == option), None)

    def options(self, section: str) -> tuple[CfgOption, ...]:
        found = self.sections.get(section)
        return tuple(found.options.values()) if found else ()
