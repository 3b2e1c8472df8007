"""Programs (`xterm`) that may come with another package of a launch file whose own dependencies are unknown."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...light_dataclasses import dataclass
from ..launch.package_reference import PackageReference
from ..launch.program_prefixes import PROGRAMS
from .brought_dependencies import Bringer, brought
from .undeclared_launch_packages import LaunchDependencies


@dataclass(frozen=True)
class BroughtPrograms:
    missing: Mapping[str, Sequence[PackageReference]]
    """Packages that are not declared, with the places that need them."""
    launch: LaunchDependencies

    def bringers(self) -> dict[str, Bringer]:
        """Return what may bring each program before nodes (`xterm -e`), where all files with it need such a package.

        The launch stops without that package: whoever launches the file has it, and all that was installed with it.
        """
        found = {}
        for name in PROGRAMS & self.missing.keys():
            with_it = [self.bringer_in(path) for path in {use.path for use in self.missing[name]}]
            if all(with_it):
                found[name] = Bringer(min(with_it), is_certain=False)
        return found

    def bringer_in(self, path: str) -> str:
        """Return the package that a launch file stops without and whose needs are not all known; "" for none."""
        needed = sorted(name for name, uses in self.missing.items() if any(stops(path, use) for use in uses))
        return next((name for name in needed if self.may_bring_any(name)), "")

    def may_bring_any(self, name: str) -> bool:
        """Return whether anything may come with a package: it, or one that it needs, is unknown and not misspelt."""
        is_open = bool(brought([name], (), self.launch.declared.workspace).unknown)
        return is_open and self.launch.unknown.intended(name) is None


def stops(path: str, use: PackageReference) -> bool:
    """Return whether a launch file stops without the package of a place, whatever its arguments are."""
    return use.path == path and use.fails == "launch" and not use.only_with
