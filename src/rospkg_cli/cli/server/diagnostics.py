"""Findings as an editor shows them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from lsprotocol import types
from pygls.workspace import PositionCodec

from ...finding import Finding, Location, Severity
from ...rule_address import web_address
from ...source import Source
from .positions import to_range

SEVERITIES = {
    Severity.ERROR: types.DiagnosticSeverity.Error,
    Severity.WARNING: types.DiagnosticSeverity.Warning,
    Severity.INFO: types.DiagnosticSeverity.Information,
}

Sources = Callable[[str], Source]
"""From a path below the root to the text that was linted."""


def diagnostic(finding: Finding, root: Path, sources: Sources, codec: PositionCodec) -> types.Diagnostic:
    """Return a finding as a diagnostic of its file; `related` places lead to theirs, its code to the rule's page."""
    page = web_address(finding.code)
    return types.Diagnostic(
        to_range(codec, sources(finding.location.path), finding.location),
        finding.message,
        severity=SEVERITIES[finding.severity],
        code=finding.code,
        code_description=types.CodeDescription(page) if page else None,
        source="rospkg",
        related_information=[related(root, at, why, sources, codec) for at, why in finding.related] or None,
    )


def related(
    root: Path, at: Location, why: str, sources: Sources, codec: PositionCodec
) -> types.DiagnosticRelatedInformation:
    place = types.Location((root / at.path).as_uri(), to_range(codec, sources(at.path), at))
    return types.DiagnosticRelatedInformation(place, why)
