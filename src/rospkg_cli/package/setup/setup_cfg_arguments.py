"""The options of `[metadata]` and `[options…]` in setup.cfg, as arguments of setup()."""

from __future__ import annotations

import posixpath
from collections.abc import Mapping
from functools import cached_property

from ...languages.python.evaluate.sandbox_filesystem import MAGIC, OutsideError, SandboxFilesystem
from ...languages.python.evaluate.values import Unknown
from ...light_dataclasses import dataclass
from ...source import Span
from .data_files import DataEntry, DataFile
from .entry_point import EntryPoint, parse_entry_point
from .find_packages import find
from .setup_cfg import CfgOption, SetupCfg
from .setup_text import SetupText

METADATA = {
    "home_page": "url", "summary": "description", "classifier": "classifiers", "platform": "platforms",
}  # fmt: skip
"""Old names of options, as setuptools still takes them."""

FIND = {"find:": False, "find_namespace:": True}


@dataclass(frozen=True)
class SetupCfgArguments:
    cfg: SetupCfg | None
    folder: SandboxFilesystem

    def option(self, name: str) -> CfgOption | None:
        """Return the option that gives an argument of setup()."""
        if self.cfg is None:
            return None
        for section in ("metadata", "options"):
            for option in self.cfg.options(section):
                if METADATA.get(option.name, option.name) == name:
                    return option
        return None

    def text(self, name: str) -> SetupText | None:
        option = self.option(name)
        if option is None or option.value.text.startswith(("attr:", "file:")):
            return None
        return option.value

    def texts(self, name: str) -> tuple[SetupText, ...]:
        """Return the items of a list: one a line, or separated by commas."""
        option = self.option(name)
        if option is None or option.value.text.startswith(("attr:", "file:")):
            return ()
        if name == "packages" and option.value.text.strip() in FIND:
            found = self.found_packages
            return tuple(SetupText("setup.cfg", package, option.value.span) for package in found or ())
        return tuple(items_of(option.value))

    @cached_property
    def unknown(self) -> Mapping[str, Unknown]:
        """The arguments that are given by a directive which is not followed."""
        found: dict[str, Unknown] = {}
        for name in ("name", "version", "packages", "py_modules", "scripts", "data_files", "entry_points"):
            option = self.option(name)
            if option and option.value.text.startswith(("attr:", "file:")):
                found[name] = Unknown(Span(0, 0), f"`{option.value.text}` in setup.cfg is not followed")
        packages = self.option("packages")
        if packages and packages.value.text.strip() in FIND and self.found_packages is None:
            found["packages"] = Unknown(Span(0, 0), f"`{packages.value.text}` in setup.cfg is not followed")
        return found

    @cached_property
    def found_packages(self) -> tuple[str, ...] | None:
        """What `packages = find:` finds; None where that is unknown."""
        packages = self.option("packages")
        if packages is None or self.cfg is None:
            return None
        find_options = {option.name: option for option in self.cfg.options("options.packages.find")}
        where = find_options["where"].value.text if "where" in find_options else "."
        include = (
            [text.text for text in items_of(find_options["include"].value)] if "include" in find_options else ["*"]
        )
        exclude = [text.text for text in items_of(find_options["exclude"].value)] if "exclude" in find_options else []
        try:
            inside = self.folder.inside(where)
            namespace = FIND[packages.value.text.strip()]
            return tuple(find(self.folder, inside, tuple(include), tuple(exclude), namespace=namespace))
        except OutsideError:
            return None

    @cached_property
    def package_dir(self) -> Mapping[str, str]:
        option = self.option("package_dir")
        pairs = [text.text.partition("=") for text in items_of(option.value)] if option else []
        return {key.strip(): value.strip() for key, sign, value in pairs if sign}

    @cached_property
    def package_data(self) -> Mapping[str, tuple[str, ...]]:
        options = self.cfg.options("options.package_data") if self.cfg else ()
        return {option.key: tuple(text.text for text in items_of(option.value)) for option in options}

    @property
    def extras(self) -> set[str]:
        """The names of `[options.extras_require]`."""
        return {option.key for option in self.cfg.options("options.extras_require")} if self.cfg else set()

    @cached_property
    def entry_points(self) -> tuple[EntryPoint, ...]:
        options = self.cfg.options("options.entry_points") if self.cfg else ()
        return tuple(parse_entry_point(option.key, line) for option in options for line in option.value.lines())

    @cached_property
    def data_entries(self) -> tuple[DataEntry, ...]:
        options = self.cfg.options("options.data_files") if self.cfg else ()
        return tuple(self.data_entry(option, index) for index, option in enumerate(options))

    def data_entry(self, option: CfgOption, index: int) -> DataEntry:
        into = SetupText("setup.cfg", option.key, option.key_span, option.key_span)
        files = [
            self.data_file(text, source, into, index) for text in items_of(option.value) for source in self.glob(text)
        ]
        return DataEntry("setup.cfg", option.span, option.span, into, None, tuple(files))

    def glob(self, text: SetupText) -> list[str]:
        try:
            return self.folder.glob(text.text, recursive=True) if MAGIC.search(text.text) else [text.text]
        except OutsideError:
            return []

    def data_file(self, text: SetupText, source: str, into: SetupText, index: int) -> DataFile:
        try:
            inside: str | None = self.folder.inside(source)
        except OutsideError:
            inside = None
        target = posixpath.normpath(posixpath.join(into.text, posixpath.basename(source)))
        return DataFile(text, text.span, inside, target, index, is_absolute=source.startswith("/"))


def items_of(value: SetupText) -> list[SetupText]:
    """Return the items of a list value: one a line where there are lines, else separated by commas."""
    if "\n" in value.text:
        return value.lines()
    found, at = [], 0
    for piece in value.text.split(","):
        item = value.part(at, at + len(piece)).stripped()
        at += len(piece) + 1
        if item.text:
            found.append(item)
    return found
