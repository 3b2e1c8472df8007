"""XML108 invalid-url-type."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.manifest.schema_tests import SchemaTests
from ...edits.manifest_tags import remove_attribute, set_attribute
from ...example import XMLLINT, Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...ros.manifest import URL_MEANT, URL_TYPES
from ...rule import rule
from ...suggest import nearest

URL = '</license>\n  <url type="{0}">https://example.org</url>'
GOOD = manifest("  <test_depend>ament_xmllint</test_depend>\n").replace("</license>", URL.format("bugtracker"))
UNTESTED = manifest().replace("</license>", URL.format("bugtracker"))


@rule(
    "XML108",
    "invalid-url-type",
    over=SchemaTests,
    severity=Severity.WARNING,
    levels={Severity.INFO: "where no test compares package.xml with its schema"},
    examples=(
        Example(
            bad={"package.xml": GOOD.replace("bugtracker", "«issues»"), "test/test_xmllint.py": XMLLINT},
            good={"package.xml": GOOD},
            fix=Safety.SAFE,
        ),
        Example(
            bad={"package.xml": UNTESTED.replace("bugtracker", "«blog»")},
            good={"package.xml": UNTESTED.replace(' type="bugtracker"', "")},
            fix=Safety.SAFE,
        ),
    ),
)
def invalid_url_type(tests: SchemaTests) -> Iterator[Hit]:
    """
    ## What it does
    Finds a `type` of a `<url>` that is none of website, bugtracker and repository.
    The fix writes the type that is nearly so, if there is one; else it removes the attribute, which means website.

    ## Why is this bad?
    The schema refuses it (`ament_xmllint` fails in tests), and the package index shows no link.

    ## When it is quiet
    A `<url>` without a type is a website, and is left alone. Where no test compares package.xml with its schema, for
    which it must declare ament_xmllint or ament_lint_common and name the schema, it is an info.

    ## References
    - [REP-149, url](https://ros.org/reps/rep-0149.html)
    """
    manifest = tests.manifest
    for element in manifest.all("url"):
        attribute = element.attributes.get("type")
        if attribute is None or attribute.value.strip() in URL_TYPES:
            continue
        word = attribute.value.strip().lower()
        intended = word if word in URL_TYPES else URL_MEANT.get(word) or nearest(word, URL_TYPES)
        if intended:
            fix = Fix(f"Write `{intended}`", (set_attribute(manifest, element, "type", intended),))
        else:
            fix = Fix("Remove the type", (remove_attribute(manifest, element, "type"),))
        hint = f"write `{intended}`" if intended else "remove the attribute"
        message = f"`{attribute.value}` is no type of a url ({', '.join(URL_TYPES)}): {tests.harm}; {hint}"
        level = None if tests.is_tested else Severity.INFO
        yield Hit(manifest.path, attribute.value_span if attribute.value else attribute.span, message, level, fix=fix)
