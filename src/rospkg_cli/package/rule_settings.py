"""The settings in a user's config that rules use; all others are used by the engine."""

from __future__ import annotations

from ..light_dataclasses import dataclass


@dataclass(frozen=True)
class RuleSettings:
    build_types: frozenset[str] = frozenset()
    """Build types that are accepted in addition to those of `ros.manifest`."""
    plugins: tuple[str, ...] = ()
    """Installed packages of rules, which every process of a run must load."""
