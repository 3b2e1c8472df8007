"""Rule input: the version limits of package.xml, and which tools enforce them (XML205)."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ..repository.released import Release
from .schema_tests import SchemaTests


@dataclass(frozen=True)
class VersionLimits:
    tests: SchemaTests
    release: Release
