"""Which packages and rosdep keys provide what find_package() looks for."""

from __future__ import annotations

from collections.abc import Iterable
from fnmatch import fnmatchcase

from ...light_dataclasses import dataclass
from ...package.cmake.find_package import FoundPackage
from ...ros.aliases import NOTHING_NEEDED, keys_for_cmake
from ...ros.distros import Targets
from ...ros.names import NameKind
from ...ros.rosdep import NOT_THERE
from .declared_dependencies import DeclaredDependencies

BARE = frozenset({"protobuf"})
"""Keys of libraries without headers whose names do not begin with `lib`."""


@dataclass(frozen=True)
class FindPackageProviders:
    declared: DeclaredDependencies

    def of(self, name: str) -> tuple[str, ...]:
        """Return the names that provide find_package(name); () where they are unknown or need no declaration."""
        listed = keys_for_cmake(name)
        if NOTHING_NEEDED in listed:
            return ()
        is_known = name not in listed and self.declared.workspace.kind_of(name) in (NameKind.PACKAGE, NameKind.KEY)
        own = (name,) if is_known else ()
        itself = self.declared.facts.name
        known = tuple(each for each in (*own, *listed) if "*" not in each and each != itself)
        return (*known, *self.matching(name, self.declared.names)) if known else ()

    def matching(self, name: str, names: Iterable[str], *, of_run_time: bool = False) -> tuple[str, ...]:
        """Return those of some names that fit a pattern of the table, or are named as vendors or Debian name packages.

        `yaml-cpp` may come from `yaml_cpp_vendor`, and there may be a package and a key: `octomap`, `liboctomap-dev`.
        With `of_run_time`, keys of libraries without headers are returned, which no build can use.
        """
        patterns = [each for each in keys_for_cmake(name) if "*" in each]
        lower = name.lower()
        debian, own = lower.replace("_", "-"), lower.replace("-", "_")
        alike = {f"{own}_vendor", f"lib{debian}-dev", f"{debian}-dev", f"lib{debian}", *BARE.intersection((lower,))}
        is_alike = [n for n in names if n.lower() in alike or any(fnmatchcase(n, p) for p in patterns)]
        return tuple(n for n in is_alike if self.is_for_run_time(n) is of_run_time)

    def is_for_run_time(self, key: str) -> bool:
        """Return whether a key is that of a library without its headers, which another one has: `libboost-thread`."""
        index = self.declared.workspace.index
        is_bare = key in BARE or key.startswith("lib")
        return is_bare and index.is_key(f"{key}-dev") and not index.is_package(key)

    def of_components(self, found: FoundPackage) -> tuple[str, ...]:
        """Return the rosdep key of the one component of Boost that is required, or `boost` for several; () for none."""
        keys = [f"libboost-{each.text.replace('_', '-')}-dev" for each in found.components if found.name == "Boost"]
        known = [key for key in dict.fromkeys(keys) if self.declared.workspace.index.is_key(key)]
        return tuple(known) if len(known) < 2 else ("boost",)

    def is_installable(self, name: str) -> bool:
        """Return whether a name is a package, or a key with a rule for a distribution that is supported."""
        workspace = self.declared.workspace
        if workspace.is_available(name) or workspace.index.is_package(name):
            return True
        return any(workspace.index.installer(name, each) != NOT_THERE for each in Targets())
