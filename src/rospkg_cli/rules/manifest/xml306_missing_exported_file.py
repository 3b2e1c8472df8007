"""XML306 missing-exported-file."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...checks.manifest.manifest_inputs import ManifestAndInstalls
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Severity
from ...languages.rep149_condition import may_hold
from ...ros.plugins import RQT
from ...rule import rule
from ...suggest import nearest

GOOD = manifest(build_type="ament_cmake").replace(
    "  </export>", '    <rqt_gui plugin="${prefix}/plugin.xml"/>\n  </export>'
)

INSTALLED = CMAKE.replace("ament_package", "install(FILES plugin.xml DESTINATION share/${PROJECT_NAME})\nament_package")
CODE = (".py", ".cpp", ".cc", ".hpp", ".h")
CORE = GOOD.replace("rqt_gui", "nav2_core")


@rule(
    "XML306",
    "missing-exported-file",
    over=ManifestAndInstalls,
    severity=Severity.ERROR,
    levels={Severity.INFO: "it is not for rqt: ROS 2 does not read the line; or the package has no plugin of rqt"},
    examples=(
        Example(
            on="ament_cmake",
            bad={
                "package.xml": GOOD.replace("${prefix}/plugin.xml", "«${prefix}/plugins.xml»"),
                "plugin.xml": "<library path='x'/>\n",
            },
            good={"package.xml": GOOD, "CMakeLists.txt": INSTALLED},
        ),
        Example(
            on="ament_cmake",
            bad={
                "package.xml": GOOD.replace("${prefix}/plugin.xml", "«${prefix}/plugin.xml»"),
                "plugin.xml": "<library path='x'/>\n",
            },
            good={"package.xml": GOOD, "CMakeLists.txt": INSTALLED},
        ),
        Example(
            on="ament_cmake",
            bad={
                "package.xml": GOOD.replace("${prefix}/plugin.xml", "«${prefix}/plugin.ml»"),
                "plugin.xml": "<library path='x'/>\n",
            },
            good={"package.xml": GOOD, "CMakeLists.txt": INSTALLED},
        ),
        Example(
            on="ament_cmake",
            bad={"package.xml": CORE.replace("${prefix}/plugin.xml", "«${prefix}/old.xml»")},
            good={"package.xml": CORE, "plugin.xml": "<library path='x'/>\n"},
        ),
    ),
)
def missing_exported_file(package: ManifestAndInstalls) -> Iterator[Hit]:
    """
    ## What it does
    Finds `<export>` entries whose plugin description does not exist or is not installed.
    They are named by `plugin="${prefix}/…"`; that the file is installed is checked for rqt.

    ## Why is this bad?
    `${prefix}` is the package's share directory. rqt reads that file, doesn't find it, and the plugin is not in its
    menu; nothing fails at build time. For others (pluginlib, rviz) ROS 2 uses
    `pluginlib_export_plugin_description_file` in CMakeLists.txt: there the line is stale and misleading.

    ## When it is quiet
    Entries under a condition that excludes the targets, and paths with other variables, are left alone. Only rqt reads
    these lines in ROS 2: for all others the finding is an info, and so is a file that is not there, nor one of a near
    name, in a package without a plugin of rqt in its code.

    ## References
    - [REP-149, export](https://ros.org/reps/rep-0149.html)
    """
    manifest = package.manifest
    for element in manifest.exports:
        attribute = element.attributes.get("plugin")
        if attribute is None:
            continue
        path = posixpath.normpath(attribute.value.strip().replace("${prefix}", "").lstrip("/"))
        rqt = element.tag in RQT
        what = f"`{path}`, exported to `{element.tag}`,"
        if "$" in path or not may_hold(element.get("condition"), package.targets.environments()):
            continue
        if package.files.absent.is_expected(path) or not may_be_description(package, path):
            continue
        if not package.files.exists(path):
            near = suggested(package, path)
            hint = f" (did you mean `{near}`?)" if near else ""
            harm = "rqt will not offer the plugin; add the file or fix the line"
            if not rqt:
                harm = "ROS 2 does not read this line, but what CMake exports; remove the line"
            message = f"{what} does not exist{hint}: {harm}"
            is_missed = rqt and (near is not None or has_plugin(package))
            end = "" if is_missed or not rqt else "; no code here is a plugin of rqt"
            yield Hit(manifest.path, attribute.value_span, message + end, None if is_missed else Severity.INFO)
        elif rqt and package.is_installed(path) is False:
            place = f"share/{manifest.name}/{posixpath.dirname(path)}".rstrip("/")
            goes = package.table.destination_of(path) if package.table is not None else None
            wrong = f"is installed as `{goes}`" if goes else "is not installed"
            message = f"{what} {wrong}: rqt will not offer the plugin; install it to `{place}`"
            yield Hit(manifest.path, attribute.value_span, message)


def may_be_description(package: ManifestAndInstalls, path: str) -> bool:
    """Return whether a path is one of XML, or nearly that of a file of XML that is there."""
    return path.endswith(".xml") or nearest(path, [e for e in package.files.paths if e.endswith(".xml")]) is not None


def has_plugin(package: ManifestAndInstalls) -> bool:
    """Return whether code of the package may be a plugin of rqt; otherwise the line is an unused leftover."""
    return any(package.files.holds(path, b"qt_gui") for path in package.files.paths if path.endswith(CODE))


def suggested(package: ManifestAndInstalls, path: str) -> str | None:
    """Return the XML file to suggest: of the same name elsewhere, the only one in that folder, or of a similar name."""
    every = [each for each in package.files.paths if each.endswith(".xml") and each != "package.xml"]
    folder, name = posixpath.split(path)
    for alike in (
        [e for e in every if posixpath.basename(e) == name],
        [e for e in every if posixpath.dirname(e) == folder],
    ):
        if len(alike) == 1:
            return alike[0]
    return nearest(path, every)
