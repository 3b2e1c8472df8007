"""The rule names in a config: those that name no rule, and the ignores that nothing needs."""

from __future__ import annotations

from collections.abc import Iterator, Set

from ...config.file import Config, Keys
from ...edits import toml
from ...package.run_events import UnknownRuleName, UnusedSuppression
from ...source import Span
from ...suggest import nearest
from ..selection import codes_named, rule_names


def rule_name_events(
    config: Config, path: str, text: str, used: Set[Keys], ran: Set[str]
) -> Iterator[UnknownRuleName | UnusedSuppression]:
    """Yield the names that no rule has, and the ignores that matched nothing although all of their rules ran.

    `text` is what the config file holds now; names that a fix took out of it are not spoken of.
    """
    for keys in rule_name_keys(config):
        found = toml.find_entry(text, (*config.table, *keys))
        span = found[0] if found else first_occurrence(text, keys[-1])
        if span is None:
            continue
        codes = codes_named(keys[-1])
        if not codes:
            yield UnknownRuleName(path, span, keys[-1], nearest(keys[-1], rule_names()))
        elif "ignore" in keys[:-1] and keys not in used and codes <= ran:
            yield UnusedSuppression(path, span, keys[-1], found[1] if found else None)


def rule_name_keys(config: Config) -> Iterator[Keys]:
    """Yield the keys of every rule name in the config."""
    for key, names in (("select", config.select), ("extend-select", config.extend_select)):
        yield from ((key, name) for name in names)
    yield from (("ignore", name) for name in config.ignore)
    yield from (("severity", name) for name in config.severity)
    for section in (*config.per_package, *config.per_path):
        yield from ((section.key, section.pattern, "ignore", name) for name in section.ignore)
        yield from ((section.key, section.pattern, "severity", name) for name in section.severity)


def first_occurrence(text: str, name: str) -> Span | None:
    at = text.find(name)
    return Span(at, at + len(name)) if at != -1 else None
