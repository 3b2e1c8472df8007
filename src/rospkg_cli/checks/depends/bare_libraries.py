"""Libraries that package.xml declares by a key without headers, though the build includes or links them (DEP115)."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...ros.libraries import is_named_among, keys_of_header
from ...source import Span
from .compiled_sources import compiled_sources
from .linked_libraries import LinkedLibraries, LinkedLibrary

UNSURE = frozenset({"libfreetype6", "libreadline", "libx11"})
"""Keys that may bring headers on a release."""


@dataclass(frozen=True, slots=True)
class BareLibrary:
    key: str
    """What package.xml declares."""
    wanted: str
    """The key with headers."""
    what: str
    """The header, or the library, that the build needs."""
    testing: bool
    path: str
    span: Span
    may_be_brought: bool
    """Whether a dependency that is not known may bring it."""


@dataclass(frozen=True)
class BareLibraries:
    libraries: LinkedLibraries

    def all(self) -> Iterator[BareLibrary]:
        """Yield each library once, where it is used first, unless something else brings it for the build."""
        includes = self.libraries.includes
        declared, seen = includes.declared, set[str]()
        bare = {name for name in declared.names if self.is_bare(name)} if declared.is_checked else set[str]()
        for each in self.used() if bare else ():
            key = next((key for key in each.keys if key in bare), "")
            whole = [name for name in each.keys if not self.is_bare(name)]
            others = declared.names - bare
            is_there = declared.has(whole) or is_named_among(each.name, others) or is_named_among(key, others)
            if not key or key in seen or is_there or is_named_among(each.name, includes.providers.fetched):
                continue
            seen.add(key)
            bringer = declared.bringer(whole, runs=False)
            if f"{key}-dev" in whole and not (bringer and bringer.is_certain):
                yield BareLibrary(key, f"{key}-dev", each.name, each.testing, each.path, each.span, bringer is not None)

    def is_bare(self, key: str) -> bool:
        return key not in UNSURE and self.libraries.includes.find_packages.provided.is_for_run_time(key)

    def used(self) -> Iterator[LinkedLibrary]:
        """Yield what CMake needs for certain, and what is included under no condition, for tests last."""
        found = [*self.libraries.used(), *self.included()]
        yield from sorted(found, key=lambda each: each.testing)

    def included(self) -> Iterator[LinkedLibrary]:
        includes = self.libraries.includes
        for source, role in compiled_sources(includes.cmake, includes.sources):
            for each in source.includes if role != "aside" and source.path not in includes.included.guarded else ():
                keys = () if each.is_conditional or includes.providers.is_own(each.path) else keys_of_header(each.path)
                if keys:
                    yield LinkedLibrary(each.path, keys, role == "test", source.path, each.span)
