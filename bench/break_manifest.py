"""Break package.xml files in the ways that people break them, for the measures beside this file."""

from __future__ import annotations

import random
import re
from collections.abc import Callable

CHILD = re.compile(r"^[ \t]*<(\w+)[^<>]*?(?:/>|>[^<]*</\1>)[ \t]*\n", re.MULTILINE)
"""A child of <package> that fills a line of its own."""


def pick(text: str, chance: random.Random, pattern: str) -> re.Match[str] | None:
    found = list(re.finditer(pattern, text, re.MULTILINE))
    return chance.choice(found) if found else None


def swap_in(text: str, match: re.Match[str] | None, new: str, group: int = 0) -> str:
    return text if match is None else text[: match.start(group)] + new + text[match.end(group) :]


def drop_line(text: str, chance: random.Random) -> str:
    return swap_in(text, pick(text, chance, CHILD.pattern), "")


def double_line(text: str, chance: random.Random) -> str:
    found = pick(text, chance, CHILD.pattern)
    return text if found is None else swap_in(text, found, found.group() * 2)


def move_line(text: str, chance: random.Random) -> str:
    found = pick(text, chance, CHILD.pattern)
    if found is None:
        return text
    rest = swap_in(text, found, "")
    other = pick(rest, chance, CHILD.pattern)
    return text if other is None else rest[: other.start()] + found.group() + rest[other.start() :]


def rename_tag(text: str, chance: random.Random) -> str:
    names = [
        "run_depend",
        "exec_depend",
        "depends",
        "build_type",
        "member_of_group",
        "licence",
        "depend",
        "test_depend",
    ]
    found = pick(text, chance, CHILD.pattern)
    return text if found is None else swap_in(text, found, found.group().replace(found.group(1), chance.choice(names)))


def change_format(text: str, chance: random.Random) -> str:
    found = pick(text, chance, r"<package(\s+format=\"\d\")?")
    return swap_in(
        text, found, "<package" + chance.choice(["", *(f' format="{f}"' for f in ("1", "2", "3", "4", "x", ""))])
    )


def change_version(text: str, chance: random.Random) -> str:
    versions = ["1.0", "1.2.3-rc1", "01.0.0", "1a2b3", "0.0.0", "", "1.0.0.0", " 2.0.0 "]
    return swap_in(text, pick(text, chance, r"<version[^>]*>([^<]*)<"), chance.choice(versions), 1)


def change_name(text: str, chance: random.Random) -> str:
    names = ["a", "my__pkg", "my_pkg_", "My_Pkg", "my-pkg", "1pkg", "", "my pkg", "ok_name"]
    return swap_in(text, pick(text, chance, r"<name>([^<]*)<"), chance.choice(names), 1)


def change_email(text: str, chance: random.Random) -> str:
    emails = ["", 'email=""', 'email="a at b.c"', 'email="root@localhost"', 'email="o\'hara@x.org"', 'email="a@b.co"']
    return swap_in(text, pick(text, chance, r"<(?:maintainer|author) (email=\"[^\"]*\")"), chance.choice(emails), 1)


def empty_text(text: str, chance: random.Random) -> str:
    return swap_in(text, pick(text, chance, r"^[ \t]*<\w+[^<>]*>([^<\n]+)</"), chance.choice(["", "  ", "TODO"]), 1)


def add_attribute(text: str, chance: random.Random) -> str:
    attributes = [
        'condition="$ROS_VERSION == 2"', 'condition="$ROS_VERSION = 2"', "condition=\"$ROS_DISTRO == 'jazzy'\"",
        'condition="$X == &quot;3.8&quot;"', 'condition="ROS_VERSION == 2"', 'version_gte="1.2"', 'version_lt="1.x"',
        'version_gte="2" version_lt="1"', 'foo="1"', 'file="LICENSE"', 'compatibility="1.0.0"', 'compatibility="1"',
        'type="home"', 'xmlns:x="u" x:y="1"', 'condition=""',
    ]  # fmt: skip
    return swap_in(text, pick(text, chance, r"^[ \t]*<\w+()[^<>]*>"), " " + chance.choice(attributes), 1)


def add_line(text: str, chance: random.Random) -> str:
    lines = [
        "<bogus/>", "<member_of_group>rosidl_interface_packages</member_of_group>", "<group_depend>A B</group_depend>",
        "<depend>rclcpp</depend>", "<exec_depend>rclcpp</exec_depend>", "<build_depend>rclcpp</build_depend>",
        "<depend/>",
        "<run_depend>rclpy</run_depend>", "<url>http://a b</url>", "some words", "<name>again</name>", "<export/>",
        "<build_type>ament_cmake</build_type>", "<license>MIT<b/></license>", "<description><b>bold</b></description>",
        "<test_depend>rclcpp</test_depend>", "<!-- a comment -->", "<license/>", "<url type='bugtracker'>http://x.y</url>",
    ]  # fmt: skip
    found = pick(text, chance, CHILD.pattern)
    return text if found is None else swap_in(text, found, found.group() + f"  {chance.choice(lines)}\n")


def change_export(text: str, chance: random.Random) -> str:
    inside = [
        "words",
        "<build_type>ament_python</build_type>",
        "<x y='z'/>",
        "<build_type condition='$A'>cmake</build_type>",
    ]
    found = pick(text, chance, r"<export>()")
    return swap_in(text, found, chance.choice(inside), 1)


def damage(text: str, chance: random.Random) -> str:
    at = chance.randrange(len(text) + 1)
    return text[:at] + chance.choice(["<", "&", ">", '"', "</", "\x01", "]]>", "-->"]) + text[at:]


WAYS: tuple[Callable[[str, random.Random], str], ...] = (
    drop_line, double_line, move_line, rename_tag, change_format, change_version, change_name, change_email, empty_text,
    add_attribute, add_attribute, add_line, add_line, change_export, damage,
)  # fmt: skip


def break_manifest(text: str, chance: random.Random, faults: int = 1) -> str:
    """Return a text with some faults in it; it may come out unharmed where a way does not apply."""
    for _ in range(faults):
        text = chance.choice(WAYS)(text, chance)
    return text
