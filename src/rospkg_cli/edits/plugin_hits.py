"""Hits of PLG002 on classes that no source exports, or no description has; classes of one cause share a hit."""

from __future__ import annotations

from collections.abc import Iterator

from ..checks.fault import Level
from ..checks.plugins.export_advice import PluginExports
from ..checks.plugins.exported_classes import ExportedClass
from ..checks.plugins.plugin_package import DescribedPlugin
from ..checks.plugins.undescribed_classes import UndescribedClasses
from ..finding import Edit, Fix, Hit, Related, Safety, Severity
from .plain_names import only_plain_names


def undefined_classes(exports: PluginExports) -> Iterator[Hit]:
    """Yield one hit for all entries of a description whose classes the package does not have."""
    entries = [each for each in exports.package.without_source() if exports.is_nowhere(each)]
    for file in dict.fromkeys(each.description.file for each in entries):
        first, *others = alike = [each for each in entries if each.description.file == file]
        again = tuple(Related(file, each.plugin.type.value_span, f"`{each.type}`") for each in others)
        text, level = exports.undefined(alike)
        yield Hit(file, first.plugin.type.value_span, text, Severity(level), again)


def undescribed_classes(exports: PluginExports) -> Iterator[Hit]:
    """Yield one hit for all exported classes that no description has, by level, and one for each base of another."""
    lost: dict[tuple[Level, str], list[ExportedClass]] = {}
    classes = UndescribedClasses(exports.package, exports.workspace, exports.named)
    for each in exports.package.undescribed():
        if derived := classes.derived(each):
            yield Hit(each.path, each.span, classes.message_of_base(each, derived), Severity.INFO)
        elif not classes.is_described_elsewhere(each):
            lost.setdefault(classes.level(each), []).append(each)
    for (level, why), every in lost.items():
        first, *others = every
        again = tuple(Related(each.path, each.span, f"`{each.type}`") for each in others)
        yield Hit(first.path, first.span, classes.message(every) + why, Severity(level), again)


def without_source(exports: PluginExports, entry: DescribedPlugin) -> Hit:
    kind, file, meant = entry.plugin.type, entry.description.file, exports.package.suggestion(entry)
    if meant is None and (text := exports.unneeded(entry)):
        return Hit(file, kind.value_span, text, Severity.INFO)
    if meant is None:
        text, level = exports.weighed(*exports.advice(entry), [entry.plugin])
        return Hit(file, kind.value_span, text, Severity(level))
    related = (Related(meant.path, meant.span, "exported here"),)
    if text := exports.uncompiled(entry, meant):
        text, level = exports.weighed(text, "warning", [entry.plugin])
        return Hit(file, kind.value_span, text, Severity(level), related)
    safety = Safety.SAFE if entry.plugin.name is not None else Safety.UNSAFE
    message = (
        f"no source exports `{entry.type}`: `{meant.path}` exports `{meant.type}`, and pluginlib wants the same name "
        f"on both sides, so loading `{entry.plugin.lookup_name}` fails; write `{meant.type}`"
    )
    fix = Fix(f"write `{meant.type}`", (Edit(file, kind.value_span, meant.type),), safety)
    message, level = exports.weighed(message, "error", [entry.plugin])
    return Hit(file, kind.value_span, message, Severity(level), related, only_plain_names(fix, meant.type))
