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


@rule(
    "XML306",
    "missing-exported-file",
    over=ManifestAndFiles,
    severity=Severity.ERROR,
    examples=(
        Example(
            on="ament_cmake",
            bad={
                "package.xml": GOOD.replace("${prefix}/plugin.xml", "«${prefix}/plugins.xml»"),
                "plugin.xml": "<library path='x'/>\n",
            },
            good={"package.xml": GOOD},
        ),
    ),
)
def missing_exported_file(package: ManifestAndFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds `<export>` entries whose `plugin="${prefix}/…"` names a file that is not there.

    ## Why is this bad?
    `${prefix}` is the package's share directory. Whoever looks for plug-ins (rqt, pluginlib, rviz) reads that file,
    doesn't find it, and the plug-in is not offered; nothing fails at build time.

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
        alike = [each for each in package.files.paths if each.endswith(".xml") and each != "package.xml"]
        same = [each for each in alike if posixpath.basename(each) == posixpath.basename(path)]
        meant = same[0] if len(same) == 1 else nearest(path, alike)
        hint = f" (did you mean `{meant}`?)" if meant else ""
        message = f"`{path}`, exported to `{element.tag}`, is not there{hint}: the plug-in will not be found; add it"
        yield Hit(manifest.path, attribute.value_span, message)
