"""The kinds of files that are attacked, and what can be nested in each."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import PurePosixPath

KINDS = (
    "manifest",
    "setup.py",
    "setup.cfg",
    "CMakeLists.txt",
    ".cmake",
    "launch.py",
    "launch.xml",
    "launch.yaml",
    "parameters",
    "interface",
    "robot",
    "plugins",
    "C++",
    "Python",
    "changelog",
    "config",
    "tree",
)
"""`tree` is no file: there the working tree itself is odd."""

SPARE = {
    "config": b"""select = ["XML", "SET", "DEP", "RPK"]
extend-select = ["CMK101"]
exclude = ["test/*", "**/old"]
target = ["humble", "jazzy"]
fail-on = "error"
pedantic = true
required-version = ">=0.1"
ignore = { XML301 = "we know" }
[severity]
SET101 = "info"
[per-package."*_msgs"]
ignore = { DEP101 = "made by a tool" }
[per-path."test/**"]
severity = { CMK101 = "off" }
[new]
license = "MIT"
""",
    "launch.yaml": b"launch:\n- arg:\n    name: rate\n    default: '10'\n- node:\n    pkg: demo_nodes_cpp\n"
    b"    exec: talker\n"
    b"    name: talker\n    param:\n    - name: rate\n      value: $(var rate)\n"
    b"- include:\n    file: $(find-pkg-share demo_nodes_cpp)/launch/all.launch.py\n",
    "launch.xml": b'<launch>\n  <arg name="rate" default="10"/>\n'
    b'  <node pkg="demo_nodes_cpp" exec="talker" name="talker">\n'
    b'    <param name="rate" value="$(var rate)"/>\n  </node>\n</launch>\n',
    "plugins": b'<library path="one">\n  <class name="a/B" type="a::B" base_class_type="b::Base">\n'
    b"    <description>One</description>\n  </class>\n</library>\n",
    "parameters": b"/**:\n  ros__parameters:\n    rate: 10.0\n    names: [a, b]\n",
    "setup.cfg": b"[develop]\nscript_dir=$base/lib/a\n[install]\ninstall_scripts=$base/lib/a\n[metadata]\nname = a\n"
    b"[options.entry_points]\nconsole_scripts =\n    talk = a.talk:main\n",
    ".cmake": b'macro(one name)\n  if(${name} MATCHES "a|b")\n    set(found ${ARGN} PARENT_SCOPE)\n'
    b"  endif()\nendmacro()\n",
    "robot": b'<robot name="a" xmlns:xacro="http://www.ros.org/wiki/xacro">\n  <link name="b"/>\n'
    b'  <xacro:property name="w" value="${1 + 2}"/>\n</robot>\n',
    "changelog": b"Changelog for package a\n^^^^^^^^^^^^^^^^^^^^^^^\n\n"
    b"0.1.0 (2024-01-02)\n------------------\n* First\n",
}
"""What to begin with where the given folders hold no file of a kind, and (sometimes) where they do."""

NEW_PATH = {
    "config": "rospkg.toml",
    "changelog": "CHANGELOG.rst",
    "launch.yaml": "launch/spare.launch.yaml",
    "launch.xml": "launch/spare.launch.xml",
    "plugins": "plugins.xml",
    "parameters": "config/spare.yaml",
    "setup.cfg": "setup.cfg",
    ".cmake": "cmake/spare.cmake",
    "robot": "urdf/spare.urdf.xacro",
}


def kind_of(path: str) -> str | None:
    """Return the kind of a file of a package by its name; None for what is not attacked."""
    at = PurePosixPath(path)
    name, suffix = at.name, at.suffix
    known = {"package.xml": "manifest", "rospkg.toml": "config", "CHANGELOG.rst": "changelog"}
    if name in known or name in ("setup.py", "setup.cfg", "CMakeLists.txt"):
        return known.get(name, name)
    for ending, kind in ENDINGS.items():
        if name.endswith(ending):
            return kind
    if suffix == ".xml":
        return "launch.xml" if "launch" in at.parts else "plugins"
    if suffix == ".py":
        return "launch.py" if "launch" in at.parts or "launch" in at.stem else "Python"
    return None


ENDINGS = {
    ".cmake": ".cmake",
    ".cmake.in": ".cmake",
    ".launch.xml": "launch.xml",
    ".launch.yaml": "launch.yaml",
    ".launch.yml": "launch.yaml",
    ".yaml": "parameters",
    ".yml": "parameters",
    ".msg": "interface",
    ".srv": "interface",
    ".action": "interface",
    ".urdf": "robot",
    ".xacro": "robot",
    ".cpp": "C++",
    ".hpp": "C++",
    ".h": "C++",
    ".cc": "C++",
}


def around(before: str, after: str) -> Callable[[int], str]:
    return lambda count: before * count + "x" + after * count


def steps(line: str, last: str, indent: str = " ") -> Callable[[int], str]:
    """Return what nests by indentation; it is quadratic in size, so at most 1,000 levels are made."""
    return lambda count: (
        "".join(f"{indent * n}{line}\n" for n in range(min(count, 1000))) + (indent * min(count, 1000) + last + "\n")
    )


XML = (around("<a>", "</a>"), around('<group ns="a">', "</group>"), around("<", ">"), around("<!--", "-->"))
PYTHON = (
    around("(", ")"),
    around("[", "]"),
    around("{1: ", "}"),
    around("f(", ")"),
    around("not -", " + x"),
    around("lambda: ", ""),
    around("", ".join(x)"),
    around("'a' + ", ""),
    steps("if x:", "pass"),
    steps("def f():", "pass"),
)
CMAKE = (
    around("if(A)\n", "\nendif()"),
    around("${", "}"),
    around("$<1:", ">"),
    around("set(a (", "))"),
    around("foreach(i a b)\n", "\nendforeach()"),
    around("function(f)\n", "\nendfunction()"),
    lambda count: f"if({'(' * count}A{')' * count})\nendif()\n",
    lambda count: f"if({'NOT ' * count}A)\nendif()\n",
    lambda count: "set(x aa)\n" + 'set(x "${x}${x}")\n' * min(count, 200),
)
YAML = (around("[", "]"), around("{a: ", "}"), steps("a:", "b: 1"), around("- ", ""), around("&a [*a, ", "]"))
NESTS: dict[str, tuple[Callable[[int], str], ...]] = {
    **dict.fromkeys(("manifest", "launch.xml", "robot", "plugins"), (*XML, around("$(find ", ")"), around("${", "}"))),
    **dict.fromkeys(("setup.py", "launch.py", "Python"), PYTHON),
    **dict.fromkeys(("CMakeLists.txt", ".cmake"), CMAKE),
    **dict.fromkeys(("launch.yaml", "parameters"), (*YAML, around("$(var ", ")"))),
    "C++": (around("{", "}"), around("<", ">"), around("(", ")"), around("namespace a {\n", "\n}"), around("/*", "*/")),
    "config": (around("[", "]"), around("{a=", "}"), around("[a.", "]")),
}
PLAIN_NESTS = (around("(", ")"), around("[", "]"), steps("a =", "b"), around('"', "'"))
