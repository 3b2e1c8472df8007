"""Sentences and silences of the rules for parameter files and definitions of parameters."""

from __future__ import annotations

from rospkg_cli.example import Example
from rospkg_cli.rules.params import prm009_invalid_parameter_library as prm009

NODE = "talker:\n  ros__parameters:\n"


def config(text: str) -> Example:
    return Example(bad={"config/robot.yaml": text}, good={}, on="config")


def values(*lines: str) -> Example:
    return config(NODE + "".join(f"    {line}\n" for line in lines))


def called(*names: str) -> Example:
    return config("".join(f"{name}:\n  ros__parameters:\n    a: 1\n" for name in names))


NUMBERS = (
    "1e-9",
    "1E9",
    "+1e9",
    "-1.e9",
    ".5e3",
    "1.5e+3",
    "1.5e3",
    "nan",
    "Inf",
    "-inf",
    "+INF",
    ".nan",
    ".inf",
    "1_000",
    "0b11",
    "1:30",
    "0x_1",
    "010",
    "-010",
    "+010",
    "00",
    "0",
    "08",
    "-09",
    "0o17",
    "0x1f",
    "0x1F",
    "1.",
    "-.5",
    "e5",
    "01e5",
    "010.5",
    "1_0.5",
    "[1e-9, 1e-8, 2]",
    "[010, 1_0]",
    "'010'",
    "!!str 010",
    "$(var x)",
    "12:30:45",
    "1__0",
    "190:20:30.15",
    "1_000.5",
    "0x1p3",
    "infinity",
    "[1.5, 1e5]",
)


def defined(*lines: str) -> Example:
    text = "talker:\n" + "".join(f"  p{number}: {{{each}}}\n" for number, each in enumerate(lines))
    return library(text)


def library(text: str) -> Example:
    return Example(bad={**prm009.FILES, "src/parameters.yaml": text}, good={}, on="ament_cmake")


CASES = {
    "PRM001": (
        config("talker:\n  ros_parameters:\n    a: 1\n"
               "listener:\n  ros__paramters: {a: 1}\nother:\n  Ros__Parameters:\n"),
        config("talker:\n  a: 1\n  b:\n    c: 1\n\n  # more\n  d: [1]\n"),
        config("talker: {a: 1}\nns:\n  talker:\n    a: 1\n"),
        config("talker:   {a: 1,\n  b: 2}\n? [x]\n: 1\ntalker2:\n  a: 1 # one\n"),
    ),
    "PRM004": (
        config("- a\n- b\n"),
        config("just text\n"),
        config("[x]: 1\ntalker:\n  ros__parameters:\n    a: 1\n  after: 1\n"),
        config("ros__parameters:\n  a: 1\n"),
        config(NODE + "    a: 1\n  ros__parameters:\n    b: 1\n"),
        config("talker:\n  ros__parameters:\n"),
        config("talker:\n  ros__parameters: ''\n"),
        config("talker:\n  ros__parameters: [1]\n"),
        config("talker:\n  ros__parameters: {}\n"),
        config("version: 2\nempty:\nanchored: &x 1\naliased: *x\n"
               "talker:\n  a: 1\n  b:\n  ros__parameters:\n    c: 1\n"),
        called("/**", "/*", "**", "*", "/", "a/", "//a", "/a//b", "a//b", "/a/b", "a/b", "9a", "/9/b", "a-b", "/**/a",
               "_a",
               "$(var x)", "a/$(var x)", "n" * 255, "m" * 256, "/ns/" + "k" * 256, '""'),
        config("/ns:\n  talker:\n    ros__parameters:\n      a: 1\n"
               "ns/:\n  talker:\n    ros__parameters:\n      a: 1\n"),
        values("a:", "b: ''", "c: ~", "'': 1", "[x]: 1", "d: {}", "e: {f: {}}", "g: 1"),
        values("a: 1", "b: {}"),
        values("a: &x 1", "b: *x", "c: [*x]", "d: {e: *x}"),
        values("a: []", "b: [1, 2.5]", "c: [1, x]", "d: [1, true]", "e: [1.5, '2']", "f: [true, yes]", "g: [x, 'y']",
               "h: [[1]]", "i: [{a: 1}, {b: 2}]", "j: [1, ]", "k: [1, '']", "l: [$(var x), 1, true]", "m: [1, 0x1f]",
               "n: [2.5, 1]", "o: [true, x]", "p: [1, 2.5, x]", "q: [~, 1]", "r: [y, 1]"),
        values("a:", "- 1", "-", "b:", "- - 1"),
        values("a: [{b: 1}]", "c: [{d: [1, 2.5]}]"),
    ),
    "PRM005": (values(*(f"p{number}: {each}" for number, each in enumerate(NUMBERS))),),
    "PRM009": (
        defined("default_value: 1", "type: int", "type: int, deflt: 1", "type: itn", "type: something",
                "type: int_array",
                "type: none", "type: int, default_value: 1.5", "type: int, default_value: x",
                "type: double, default_value: 1",
                "type: double, default_value: 1.5", "type: bool, default_value: yes", "type: bool, default_value: y",
                "type: bool, default_value: 'true'", "type: string, default_value: 1",
                "type: string, default_value: '1'",
                "type: string, default_value: on", "type: string, default_value: y", "type: int, default_value: ~",
                "type: int_array, default_value: [1, 2.5, x]", "type: int_array, default_value: 1",
                "type: int_array, default_value: ~", "type: string_array, default_value: [[a]]", "type: bool_array",
                "type: double_array, default_value: [1, 2.5]", "type: int, default_value: [1]",
                "type: string, default_value: ",
                "type: none, default_value: x", "type: string_array, default_value: []",
                "type: double, default_value: '1.5'", "type: int, default_value: !!str 1"),
        defined(*(f"type: double, validation: {{{each}}}" for each in (
            "bounds: [0, 1]", "bounds<>: [0, 1]", "bouds<>: [0, 1]", "gt_eq<>: [0]", "mine: 1", "my_ns::mine: 1",
            "my_ns::boundz<>: 1", "[x]: 1", "not_empty<>: []", "upper_bound<>: 1")),
            "type: int, validation: 1"),
        library("- a\n"),
        library("a: {b: {type: int}}\nc: {d: {type: int}}\n"),
        library("text\n"),
        library(""),
    ),
}  # fmt: skip
