"""What only the schema of package.xml forbids, where tests run ament_xmllint, and where no line names the schema."""

from __future__ import annotations

import re

from rospkg_cli.example import Example, manifest

TESTED = manifest("  <test_depend>ament_lint_common</test_depend>\n")
UNNAMED = re.sub(r"<\?xml-model[^>]*>\n", "", TESTED)


def both(old: str, new: str) -> tuple[Example, ...]:
    texts = (text.replace(old, new) for text in (TESTED, UNNAMED))
    return tuple(Example(bad={"package.xml": text}, good={}, on="ament_python") for text in texts)


CASES = {
    "XML001": both("</license>\n", "</license>\n  stray words\n"),
    "XML003": both('format="3"', 'format=" 3 "'),
    "XML004": tuple(
        Example(bad={"package.xml": each.bad["package.xml"].replace("<version>", '<version compatibility="1.0.0">')},
                good={}, on="ament_python")
        for each in both('format="3">', 'format="2">')
    ),
    "XML103": both("1.0.0", "1.02.0"),
    "XML205": both("<test_depend>", '<test_depend version_gte="two">'),
}  # fmt: skip
