"""Hostile texts and names for `new`, made from a seed."""

from __future__ import annotations

import random
from dataclasses import replace
from typing import Any

from rospkg_cli.scaffold.answers import Request
from rospkg_cli.scaffold.template import template_names

PIECES = (
    *("'", '"', "\\", "`", "'''", '"""', "\\n", "\\", "\\\\", "%s", "{0}", "%", "$", "${X}", "$ENV{HOME}", "$(id)"),
    *("</description>", "<b>", "<!--", "-->", "--", "]]>", "<![CDATA[", "&amp;", "&", "&#0;", "<?xml ?>", "<", ">"),
    *("{{ 7*7 }}", "{% raw %}", "{#", "#}", "}}", "{{", "[[ name ]]", "[% if %]", "%]"),
    *("(", ")", "[", "]", "{", "}", ";", ",", "#", "# noqa", "//", "/*", "*/", "#[[", "]]", "#endif", "??/", "\\u0041"),
    *(": ", "- ", "? ", "*a", "&a", "!!x", "|", "@", "~", "null", "yes", "1e3", "0x1", "=", "---", "..."),
    *("\n", "\r", "\r\n", "\t", "\0", "\x0b", "\x0c", "\x1b[31m", "\x7f", "\x85", "\x9b", "\u2028", "\u2029"),
    *("\u202e", "\u2066", "\u200b", "\u200e", "\ufeff", "\u00a0", "\u3000", "\u00ad", "\ufffe", "\uffff", "\ud800"),
    *("\udcff", "\ue000", "e\u0301", "é", "ß", "İ", "机器人", "🤖", "𝔘", "\U000e0001", "\U0010ffff", "ﷺ"),
    *("../", "/", "..", ".", "~/", "-", "--help", "coding: latin-1", "coding=x", "-*- coding: x -*-"),
    *("rospkg: ignore", "TODO", "http://a.b/c?d=e&f", "a@b.c", "Copyright 1999 Bob", "All rights reserved"),
)
WORDS = ("a", "robot", "that", "drives", "Ada", "of", "the", "Lovelace", "1", "x" * 70, "w" * 130)
NAMES = (
    *("self", "cls", "main", "node", "rclpy", "std_msgs", "test", "launch", "setup", "rclcpp", "params", "logic"),
    *("talker", "string", "math", "os", "class_", "match", "type", "int", "std", "auto", "my_node", "node_node"),
    *("data", "msg", "index", "value", "time", "logging", "param", "test_talker", "conftest", "init", "lib", "nan"),
    *("timer", "publisher", "parameter", "lifecycle", "component", "static", "signed", "x" * 55, "a1_b2", "y" * 60),
    *("true", "null", "on", "e1", "ab", "none", "print", "rclpy_components", "default", "context", "goal", "result"),
)
KINDS = ("publisher", "subscriber", "service", "client", "timer", "lifecycle", "component", "empty", "action_server")
FIELDS = ("int32 x", "string text", "float64[] values", "bool<=3 b", "geometry_msgs/Pose p", "uint8 A=1", "Time t")


def text(chance: random.Random) -> str:
    """Return a text of hostile pieces among plain words."""
    if chance.random() < 0.03:
        return chance.choice(PIECES) * chance.choice((200, 10_000))
    parts = [chance.choice(PIECES if chance.random() < 0.55 else WORDS) for _ in range(chance.randint(1, 8))]
    return chance.choice(("", " ")).join(parts)


def name(chance: random.Random) -> str:
    """Return a name: odd and right, or a right one that a hostile piece was put into."""
    found = chance.choice(NAMES)
    if chance.random() < 0.5:
        found = f"{found}_{chance.choice(NAMES)}"[:60].rstrip("_")
    if chance.random() < 0.06:
        at = chance.randint(0, len(found))
        found = found[:at] + chance.choice(PIECES) + found[at:]
    return found


def node(chance: random.Random) -> str:
    words = [chance.choice((*KINDS, "cpp", "python")) for _ in range(chance.choice((0, 0, 0, 1)))]
    if chance.random() < 0.2:
        words[:] = [chance.choice(("publisher", "subscriber")), f"{name(chance)}/{message(chance)}"]
    return ":".join([name(chance), *words])


def message(chance: random.Random) -> str:
    return "".join(word[:1].upper() + word[1:] for word in name(chance).split("_"))


def interface(chance: random.Random, parts: int) -> str:
    """Return `Name` or `Name:FIELDS`, with defaults and comments that are hostile."""
    if chance.random() < 0.2:
        return message(chance)
    rows = []
    for _ in range(parts):
        fields = [chance.choice(FIELDS) for _ in range(chance.randint(0, 3))]
        if chance.random() < 0.5:
            fields.append(f"string {name(chance)} '{text(chance)}'" if chance.random() < 0.5 else f"# {text(chance)}")
        if chance.random() < 0.3:
            fields.append(f"{chance.choice(('int8', 'string', 'float32'))} {name(chance)} {text(chance)}")
        rows.append(", ".join(fields))
    return f"{message(chance)}:{' --- '.join(rows)}"


def request(chance: random.Random) -> Request:
    """Return a request of any type in which one to three answers are hostile."""
    asked = Request(
        "my_robot_nav",
        template=chance.choice(template_names()),
        maintainer="Ada Lovelace",
        email="ada@example.org",
        year=2026,
        tests=chance.choice(("ament", "minimal", "none")),
        extras=chance.choice(((), ("ci", "docs"), ("pre-commit",), ("docker",))),
        license=chance.choice(("", "MIT", "BSD-3-Clause", "Apache-2.0", "GPL-3.0-only")),
        params=chance.random() < 0.8,
        distro=chance.choice(("humble", "jazzy", "lyrical", "rolling")),
    )
    if asked.template not in ("interfaces", "description") and chance.random() < 0.6:
        asked = replace(asked, launch=chance.choice(("py", "xml", "yaml")))
    for _ in range(chance.choice((1, 1, 2, 3))):
        asked = chance.choice(SPOILERS if chance.random() < 0.95 else (one_word,))(asked, chance)
    return asked


def some_interfaces(asked: Request, chance: random.Random) -> Request:
    forms = {"msgs": 1, "srvs": 2, "actions": 3}
    form = chance.choice(tuple(forms))
    found: Any = tuple(interface(chance, forms[form]) for _ in range(chance.randint(1, 3)))
    return replace(asked, template="interfaces", launch="", **{form: found})


def some_names(asked: Request, chance: random.Random) -> Request:
    named = tuple(name(chance) for _ in range(chance.randint(1, 4)))
    return replace(asked, depends=named) if chance.random() < 0.5 else replace(asked, name=named[0])


def some_nodes(asked: Request, chance: random.Random) -> Request:
    if asked.template == "bringup":
        return replace(asked, nodes=tuple(f"{name(chance)}/{name(chance)}" for _ in range(chance.randint(1, 4))))
    template = asked.template if asked.template.startswith("ament") else chance.choice(("ament_python", "ament_cmake"))
    return replace(asked, template=template, nodes=tuple(node(chance) for _ in range(chance.randint(1, 3))))


def one_word(asked: Request, chance: random.Random) -> Request:
    field = chance.choice(("license", "version", "distro", "launch", "tests", "email", "template", "email"))
    word: Any = text(chance) if field != "email" else f"{text(chance)}@{text(chance)}"
    return replace(asked, **{field: word})


def described(asked: Request, chance: random.Random) -> Request:
    return replace(asked, description=text(chance))


def written_by(asked: Request, chance: random.Random) -> Request:
    return replace(asked, maintainer=text(chance))


SPOILERS = (described, described, written_by, written_by, some_names, some_nodes, some_nodes, some_interfaces)
