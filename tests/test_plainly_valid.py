"""What is taken for valid without the schema is valid; most packages are."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from rospkg_cli.languages.xml.elements import Document
from rospkg_cli.package.manifest import manifest_of
from rospkg_cli.package.schema.plainly_valid import LONGEST, is_plainly_valid
from rospkg_cli.package.schema.schema import accepts
from rospkg_cli.source import Source

LINES = [
    "<name>my_pkg</name>", "<version>1.20.3</version>", "<description>Drives, &amp; \n waits</description>",
    '<maintainer email="ada@example.org">Ada L.</maintainer>', "<license>Apache-2.0</license>",
    "<license>MIT</license>", '<url type="repository">https://example.org/a-b/c.git/</url>',
    "<url>http://example.org</url>", '<author email="b@example.org">Bob</author>',
    "<buildtool_depend>ament_cmake</buildtool_depend>", "<depend>rclcpp</depend>", "<test_depend>a</test_depend>",
    "<depend>b</depend>", "<group_depend>a_group</group_depend>", "<member_of_group>a_group</member_of_group>",
    '<export><build_type>ament_cmake</build_type><!-- x --><x y="${prefix}/z"/></export>',
]  # fmt: skip
OF_2 = [line for line in LINES if "group" not in line]
OTHER = [
    "words", "<!-- words -->", "<![CDATA[ ]]>", "<bogus/>", "<run_depend>a</run_depend>", "<name/>",
    "<name>My_Pkg</name>", "<name>a b</name>", "<version>1.0</version>", "<version>01.0.0</version>", "<version/>",
    '<version compatibility="1.0.0">1.2.0</version>', "<description>a <b>c</b></description>", "<license> </license>",
    '<description lang="en">a</description>', "<maintainer>Ada</maintainer>", '<maintainer email="a">Ada</maintainer>',
    '<maintainer email="a@b.org" url="c">Ada</maintainer>', "<maintainer email='a@b.org'><b/></maintainer>",
    '<license file="LICENSE">MIT</license>', "<license/>", "<license><b/></license>", "<url>http://a b</url>",
    '<url type="home">http://a.org</url>', '<url kind="website">http://a.org</url>', "<url>http://a.org:x/%zz</url>",
    '<url type="website" x="y">http://a.org</url>', "<author>Bob</author>", '<author name="b">Bob</author>',
    '<author email="a">Bob</author>', '<depend version_gte="1.x">a</depend>', '<depend condition="1">a</depend>',
    "<depend>a<b/></depend>", "<depend>a<!-- b --></depend>", "<depend/>", "<depend>ä</depend>",
    "<member_of_group>A B</member_of_group>", '<member_of_group x="1">a</member_of_group>', "<group_depend/>",
    "<export>words</export>", '<export x="1"/>', "<export><a><b/></a></export>", "<export/>",
    '<export><a:b xmlns:a="c"/></export>',
    f"<description>{'x' * LONGEST}</description>",
]  # fmt: skip


def document(lines: list[str], attributes: str = ' format="3"') -> Document:
    return manifest_of(Source("package.xml", f"<package{attributes}>\n{chr(10).join(lines)}\n</package>\n")).document


def is_both(found: Document, format: int) -> tuple[bool, bool]:
    return is_plainly_valid(found, format), accepts(found.source.text, format)


@pytest.mark.parametrize("format, lines", [(3, LINES), (2, OF_2), (3, OF_2[:5]), (2, OF_2[:5])])
def test_a_plain_one_is_valid(format: int, lines: list[str]) -> None:
    assert is_both(document(lines, f' format="{format}"'), format) == (True, True)


@pytest.mark.parametrize("format, lines", [(3, LINES), (2, OF_2), (2, LINES)])
def test_what_is_plainly_valid_is_valid(format: int, lines: list[str]) -> None:
    for index in range(len(lines)):
        others = [*lines[:index], *lines[index + 1 :]]
        texts = [others, *([*lines[: index + 1], more, *lines[index + 1 :]] for more in (*lines, *OTHER))]
        texts += [[*lines[:index], more, *lines[index + 1 :]] for more in OTHER]
        for each in texts:
            plainly, really = is_both(document(each, f' format="{format}"'), format)
            assert really or not plainly, each


@pytest.mark.parametrize("more", [*OTHER[:1], *OTHER[3:]])
def test_what_is_not_plain_is_left_to_the_schema(more: str) -> None:
    tag = more[1:].partition(">")[0].partition(" ")[0].strip("/")
    others = [line for line in LINES if not line.startswith((f"<{tag}>", f"<{tag} "))]
    place = next((at for at, line in enumerate(LINES) if line.startswith((f"<{tag}>", f"<{tag} "))), len(others))
    lines = [*others[:place], more, *others[place:]]
    assert is_plainly_valid(document(lines), 3) == (more == "<export/>")


@pytest.mark.parametrize(
    "attributes, format",
    [("", 3), ("", 1), (' format="3"', 2), (' format="2"', 3), (' format="3" x="y"', 3), (' format="1"', 1)],
)
def test_the_format_is_that_of_the_schema(attributes: str, format: int) -> None:
    assert not is_plainly_valid(document(OF_2, attributes), format)


def test_a_lint_of_a_plain_package_does_without_libxml2() -> None:
    code = (
        "import sys; sys.argv = ['rospkg', 'lint', '--no-cache', '--format', 'json', '.']\n"
        "from rospkg_cli.__main__ import main; main(); sys.exit('lxml' in sys.modules)"
    )
    folder = Path(__file__).parent / "corpus" / "my_robot_nav"
    assert subprocess.run([sys.executable, "-c", code], cwd=folder, capture_output=True).returncode == 0
