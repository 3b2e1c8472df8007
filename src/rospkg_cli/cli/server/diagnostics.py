"""Findings as an editor shows them."""

from __future__ import annotations

from typing import Protocol

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


class LintedTexts(Protocol):
    """The texts that were linted, by their paths below the root."""

    def source(self, path: str) -> Source: ...

    def uri(self, path: str) -> str: ...


def diagnostic(finding: Finding, texts: LintedTexts, codec: PositionCodec) -> types.Diagnostic:
    """Return a finding as a diagnostic of its file; `related` places lead to theirs, its code to the rule's page."""
    page = web_address(finding.code)
    return types.Diagnostic(
        to_range(codec, texts.source(finding.location.path), finding.location),
        finding.message,
        severity=SEVERITIES[finding.severity],
        code=finding.code,
        code_description=types.CodeDescription(page) if page else None,
        source="rospkg",
        related_information=[related(at, why, texts, codec) for at, why in finding.related] or None,
    )


def related(at: Location, why: str, texts: LintedTexts, codec: PositionCodec) -> types.DiagnosticRelatedInformation:
    place = types.Location(texts.uri(at.path), to_range(codec, texts.source(at.path), at))
    return types.DiagnosticRelatedInformation(place, why)
