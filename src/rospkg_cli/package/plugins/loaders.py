"""Loaders of plugins: pluginlib::ClassLoader with a literal package and base class."""

from __future__ import annotations

from collections.abc import Iterator

from ...files import PackageFiles, ReaderInput
from ...languages.cpp.call import CppArgument, CppCall
from ...languages.cpp.file import CppFile, read_cpp
from ...languages.cpp.read import SUFFIXES
from ...light_dataclasses import dataclass
from ...unreadable import UnreadableError
from ..file_role import role_of

LOADER = "ClassLoader"
TEMPLATE = b"ClassLoader<"


@dataclass(frozen=True)
class PluginLoader:
    path: str
    package: CppArgument
    base: CppArgument

    @property
    def names(self) -> tuple[str, str]:
        """The package and the base class."""
        return self.package.literal or "", self.base.literal or ""


@dataclass(frozen=True)
class PluginLoaders:
    """The loaders of a package; `complete` says whether the arguments of all of them are literals."""

    loaders: tuple[PluginLoader, ...] = ()
    is_complete: bool = True


def read_plugin_loaders(reading: ReaderInput) -> Iterator[PluginLoaders]:
    """Read the sources that use loaders; the others are not parsed, and without any none is decoded."""
    if not any(reading.files.holds(path, TEMPLATE) for path in source_paths(reading.files)):
        yield PluginLoaders()
        return
    texts = dict(sources(reading.files))
    declaring = [read_cpp(reading.files.source(path)) for path, text in texts.items() if LOADER + "<" in text]
    members = {call.variable for file in declaring for call in file.calls_to(LOADER) if call.arguments is None}
    others = [
        read_cpp(reading.files.source(path))
        for path, text in texts.items()
        if LOADER + "<" not in text and any(f"{name}(" in text or f"{name}{{" in text for name in members if name)
    ]
    found = [loader for file in (*declaring, *others) for loader in loaders_in(file, members)]
    direct = [call for file in declaring for call in file.calls_to(LOADER) if call.arguments]
    literal = all(loader_of("", call) is not None for call in direct)
    yield PluginLoaders(tuple(found), literal and (bool(found) or not members))


def source_paths(files: PackageFiles) -> Iterator[str]:
    return (path for path in files.paths if path.endswith(SUFFIXES) and role_of(path) == "run")


def sources(files: PackageFiles) -> Iterator[tuple[str, str]]:
    for path in source_paths(files):
        try:
            yield path, files.source(path).text
        except UnreadableError:
            continue


def loaders_in(file: CppFile, members: set[str]) -> Iterator[PluginLoader]:
    for call in file.calls:
        if call.name == LOADER or call.name in members:
            loader = loader_of(file.path, call)
            if loader is not None:
                yield loader


def loader_of(path: str, call: CppCall) -> PluginLoader | None:
    """Return the loader that a call makes; None where its first two arguments are no literals."""
    if call.arguments is None or len(call.arguments) < 2:
        return None
    package, base = call.arguments[:2]
    return PluginLoader(path, package, base) if package.literal and base.literal else None
