"""XML306 missing-exported-file."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...example import Example, manifest
from ...finding import Hit, Severity
from ...model.manifest_slices import ManifestAndFiles
from ...rule import rule
from ...suggest import nearest

GOOD = manifest(build_type="ament_cmake").replace(
    "  </export>", '    <rqt_gui plugin="${prefix}/plugin.xml"/>\n  </export>'
)

CORE = GOOD.replace("rqt_gui", "nav2_core")
READ_BY_RQT = ("rqt_gui", "qt_gui")


@rule(
    "XML306",
    "missing-exported-file",
    over=ManifestAndFiles,
    severity=Severity.ERROR,
    levels={Severity.WARNING: "it is not for rqt: pluginlib goes by what CMake exports, and the line is stale"},
    examples=(
        Example(
            on="ament_cmake",
            bad={
                "package.xml": GOOD.replace("${prefix}/plugin.xml", "«${prefix}/plugins.xml»"),
                "plugin.xml": "<library path='x'/>\n",
            },
            good={"package.xml": GOOD},
        ),
        Example(
            on="ament_cmake",
            bad={"package.xml": CORE.replace("${prefix}/plugin.xml", "«${prefix}/old.xml»")},
            good={"package.xml": CORE, "plugin.xml": "<library path='x'/>\n"},
        ),
    ),
)
def missing_exported_file(package: ManifestAndFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds `<export>` entries whose `plugin="${prefix}/…"` names a file that is not there.

    ## Why is this bad?
    `${prefix}` is the package's share directory. rqt reads that file, doesn't find it, and the plug-in is not offered;
    nothing fails at build time. For others (pluginlib, rviz) ROS 2 goes by `pluginlib_export_plugin_description_file`
    in CMakeLists.txt: there the line is a left-over that misleads.

    ## References
    - [REP-149, export](https://ros.org/reps/rep-0149.html)
    """
    manifest = package.manifest
    for element in manifest.exports:
        attribute = element.attributes.get("plugin")
        if attribute is None or not attribute.value.endswith(".xml"):
            continue
        path = posixpath.normpath(attribute.value.strip().replace("${prefix}", "").lstrip("/"))
        if package.files.exists(path) or "$" in path:
            continue
        meant = suggested(package, path)
        hint = f" (did you mean `{meant}`?)" if meant else ""
        level = None if element.tag in READ_BY_RQT else Severity.WARNING
        harm = "rqt will not offer the plug-in" if level is None else "ROS 2 goes by what CMake exports"
        message = f"`{path}`, exported to `{element.tag}`, is not there{hint}: {harm}; add the file or mend the line"
        yield Hit(manifest.path, attribute.value_span, message, level)


def suggested(package: ManifestAndFiles, path: str) -> str | None:
    """Return the XML file that is meant: of the same name elsewhere, of a near name, or the only one in that folder."""
    every = [each for each in package.files.paths if each.endswith(".xml") and each != "package.xml"]
    folder, name = posixpath.split(path)
    for alike in (
        [e for e in every if posixpath.basename(e) == name],
        [e for e in every if posixpath.dirname(e) == folder],
    ):
        if len(alike) == 1:
            return alike[0]
    return nearest(path, every)
