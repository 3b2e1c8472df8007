"""Values of options and arguments that a shell completes; what is needed for them is read when it asks."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

Completion = Callable[[str], Iterator[str]]
"""From what was typed of a value to the values that begin so."""


def choices(*values: str) -> Completion:
    """Return what completes one of some values."""
    return lambda incomplete: (each for each in values if each.startswith(incomplete))


def listed(values: Callable[[], Iterable[str]]) -> Completion:
    """Return what completes the last name of a list with commas."""

    def completed(incomplete: str) -> Iterator[str]:
        before, comma, last = incomplete.rpartition(",")
        names = set(before.split(","))
        return (f"{before}{comma}{each}" for each in values() if each.startswith(last) and each not in names)

    return completed


def rule_codes() -> list[str]:
    """Return the codes of all rules, and the letters that those of a family begin with."""
    from ..rule_table import rule_entries

    codes = sorted(rule_entries())
    return [*dict.fromkeys(code[:3] for code in codes), *codes]


def rule_words(incomplete: str) -> Iterator[str]:
    """Complete a code in any case, or the name of a rule."""
    from ..rule_table import rule_entries

    codes = [code.lower() for code in rule_codes()] if incomplete.islower() else rule_codes()
    yield from (each for each in codes if each.startswith(incomplete))
    if incomplete:
        yield from sorted(entry.name for entry in rule_entries().values() if entry.name.startswith(incomplete.lower()))


def distro_names() -> list[str]:
    from ..ros.distros import DISTROS

    return [each.name for each in DISTROS]


def format_names() -> Iterable[str]:
    from ..report import FORMATS

    return FORMATS


def license_names() -> Iterable[str]:
    from ..ros.licenses import LICENSES

    return [each.spdx for each in LICENSES]


def dependency_names() -> Iterator[str]:
    """Yield the names of packages and rosdep keys that are built in or were fetched."""
    from .lint.session import known_names

    yield from sorted(set(known_names().all()))


def plugin_words(incomplete: str) -> Iterator[str]:
    """Complete KIND, or the kind in NAME:KIND."""
    from ..scaffold.plugin_kinds import plugin_kinds

    name, colon, kind = incomplete.rpartition(":")
    yield from (f"{name}{colon}{each}" for each in plugin_kinds() if each.startswith(kind))


def node_kinds(incomplete: str) -> Iterator[str]:
    """Complete the kind in NAME:KIND."""
    name, colon, kind = incomplete.partition(":")
    if colon and ":" not in kind:
        from ..scaffold.node_kinds import offered_kinds

        yield from (f"{name}:{each}" for each in offered_kinds() if each.startswith(kind))


def package_names(incomplete: str) -> Iterator[str]:
    """Yield the names of the folders of packages below the current one."""
    from ..current_folder import current_folder
    from ..engine.discovery.discover import packages_below

    yield from sorted({each.name for each in packages_below(current_folder()) if each.name.startswith(incomplete)})
