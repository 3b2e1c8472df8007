"""What only the schema of package.xml forbids, where tests compare it with the schema, and where they do not."""

from __future__ import annotations

import re

from rospkg_cli.example import CMAKE, XMLLINT, Example, manifest

TESTED = manifest("  <test_depend>ament_xmllint</test_depend>\n")
UNNAMED = re.sub(r"<\?xml-model[^>]*>\n", "", TESTED)
TEST = {"test/test_xmllint.py": XMLLINT}
NATIVE = manifest("  <test_depend>ament_lint_common</test_depend>\n", "ament_cmake")
LINTS = "find_package(ament_lint_auto)\n{}ament_lint_auto_find_test_dependencies()\n"
CALLS = (
    LINTS.format(""),
    LINTS.format("set(ament_cmake_xmllint_FOUND TRUE)\n"),
    LINTS.format("list(APPEND AMENT_LINT_AUTO_EXCLUDE ament_cmake_xmllint)\n"),
    "ament_xmllint()\n",
    "# ament_xmllint()\n",
    "find_package(autoware_cmake REQUIRED)\nautoware_package()\n",
    "",
)


def python(*swaps: tuple[str, str]) -> tuple[Example, ...]:
    def swapped(text: str) -> str:
        for old, new in swaps:
            text = text.replace(old, new)
        return text

    files = ({"package.xml": swapped(TESTED), **TEST}, {"package.xml": swapped(UNNAMED), **TEST})
    asked = {"package.xml": swapped(TESTED), "test/test_all.py": "LINTERS = ['ament_xmllint']\n"}
    untested = {"package.xml": swapped(TESTED), "test/test_all.py": "LINTERS = []\n"}
    return tuple(Example(bad={**each}, good={}, on="ament_python") for each in (*files, asked, untested))


SPACED = tuple(
    Example(
        bad={
            "package.xml": NATIVE.replace('format="3"', 'format=" 3 "'),
            "CMakeLists.txt": CMAKE.replace("ament_package", f"{call}ament_package"),
        },
        good={},
        on="ament_cmake",
    )
    for call in CALLS
)
CASES = {
    "XML001": python(("</license>\n", "</license>\n  stray words\n")),
    "XML003": python(('format="3"', 'format=" 3 "')) + SPACED,
    "XML004": python(
        ('format="3">', 'format="2">'),
        ("package_format3", "package_format2"),
        ("<version>", '<version compatibility="1.0.0">'),
    ),
    "XML103": python(("1.0.0", "1.02.0")),
    "XML205": python(("<test_depend>", '<test_depend version_gte="two">')),
}
