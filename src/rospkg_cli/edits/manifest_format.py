"""From format 1 or 2 of package.xml to format 3 (REP-140 and REP-149 say what changes)."""

from __future__ import annotations

from ..finding import Edit
from ..lazy_regex import regex
from ..package.manifest import Manifest
from ..ros.manifest import FORMATS, XML_MODEL
from ..source import Span
from .manifest import indentation, remove_element
from .manifest_tags import rename_tag, set_attribute

SCHEMA = regex(r"(?<=package_format)\d(?=\.xsd)")


def to_format_3(manifest: Manifest) -> tuple[Edit, ...]:
    """Return the edits that make a manifest one of format 3: the attribute, the schema's line, run_depend of format 1.

    In other formats run_depend has no meaning that could be kept.
    """
    newest = str(max(FORMATS))
    edits = [set_attribute(manifest, manifest.root, "format", newest), *schema_line(manifest, newest)]
    return (*edits, *(replace_run_depend(manifest) if manifest.schema_format == 1 else ()))


def schema_line(manifest: Manifest, format: str) -> tuple[Edit, ...]:
    """Return the edit that lets the `<?xml-model?>` line name the schema of a format, if there is such a line."""
    line = manifest.xml_model
    found = SCHEMA.search(manifest.source.slice(line.span)) if line else None
    if line is None or found is None or found.group() == format:
        return ()
    start = line.span.start + found.start()
    return (Edit(manifest.path, Span(start, start + 1), format),)


def add_schema_line(manifest: Manifest, format: int) -> Edit:
    """Put the line that names the schema right below the XML declaration, or at the top."""
    text = manifest.source.text
    end = text.find("?>") + 2 if text.startswith("<?xml ") else 0
    model = XML_MODEL.format(format)
    return Edit(manifest.path, Span(end, end), f"\n{model}" if end else f"{model}\n")


def replace_run_depend(manifest: Manifest) -> tuple[Edit, ...]:
    """Return the edits that replace run_depend.

    By depend where there is a build_depend too, else by build_export_depend and exec_depend.
    """
    edits: list[Edit] = []
    builds = {d.key: d for d in manifest.dependencies if d.tag == "build_depend"}
    for each in manifest.dependencies:
        if each.tag != "run_depend":
            continue
        if each.key in builds:
            edits += rename_tag(manifest, each.element, "depend")
            edits.append(remove_element(manifest, builds.pop(each.key).element))
            continue
        whole = manifest.source.slice(each.element.span)
        export, run = (whole.replace("run_depend", tag) for tag in ("build_export_depend", "exec_depend"))
        indent = indentation(manifest, each.element)
        edits.append(Edit(manifest.path, each.element.span, f"{export}\n{indent}{run}"))
    return tuple(edits)
