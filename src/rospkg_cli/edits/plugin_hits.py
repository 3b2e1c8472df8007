"""What PLG002 says of several classes of one cause at once."""

from __future__ import annotations

from collections.abc import Iterator

from ..checks.plugins.export_advice import PluginExports
from ..checks.plugins.exported_classes import ExportedClass
from ..finding import Hit, Related, Severity


def undefined_classes(exports: PluginExports) -> Iterator[Hit]:
    """Yield one hit for all entries of a description whose classes the package does not have."""
    entries = [each for each in exports.package.without_source() if exports.is_nowhere(each)]
    for file in dict.fromkeys(each.description.file for each in entries):
        first, *others = alike = [each for each in entries if each.description.file == file]
        again = tuple(Related(file, each.plugin.type.value_span, f"`{each.type}`") for each in others)
        text, level = exports.undefined(alike)
        yield Hit(file, first.plugin.type.value_span, text, Severity(level), again)


def undescribed_classes(exports: PluginExports) -> Iterator[Hit]:
    """Yield one hit for all exported classes that no description has, and one for each that is a base of another."""
    lost: list[ExportedClass] = []
    for each in exports.package.undescribed():
        if derived := exports.derived(each):
            yield Hit(each.path, each.span, exports.base_alone(each, derived), Severity.INFO)
        elif not exports.is_described_elsewhere(each):
            lost.append(each)
    if lost:
        first, *others = lost
        again = tuple(Related(each.path, each.span, f"`{each.type}`") for each in others)
        yield Hit(first.path, first.span, exports.undescribed(lost), Severity.WARNING, again)
