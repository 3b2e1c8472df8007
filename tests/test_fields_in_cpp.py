"""Fields of messages in C++ (IDL013): which variables hold a message, where, and what is judged of them."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.cpp.member_paths import member_paths
from rospkg_cli.checks.cpp.message_variables import message_variables
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files


def paths(text: str) -> dict[str, list[str]]:
    """Return what a text names of each message that a variable holds."""
    found = ((each, member_paths(text, each)) for each in message_variables(text))
    return {each.message: [".".join(path.names) for path in named] for each, named in found}


@pytest.mark.parametrize(
    "text, message, names",
    [
        ("void f() { a_msgs::msg::B b; b.c = 1; }", "a_msgs/msg/B", ["c"]),
        ("void f() { ::a_msgs::msg::B b{}; b.c.d = 1; }", "a_msgs/msg/B", ["c.d"]),
        ("void f() { auto b = a_msgs::msg::B(); b.c.size(); b.set__d(1); }", "a_msgs/msg/B", ["c"]),
        ("void f(const a_msgs::msg::B & b) { b.c; b.c[0].d; b->e; x.b.f; }", "a_msgs/msg/B", ["c", "c"]),
        ("void f(a_msgs::msg::B::ConstSharedPtr b) { b->c; b.get(); }", "a_msgs/msg/B", ["c"]),
        ("void f(const std::shared_ptr<const a::srv::B::Request> b) { b->c; }", "a/srv/B_Request", ["c"]),
        ("void f(a::action::B::Goal::SharedPtr b) { b->c; }", "a/action/B_Goal", ["c"]),
        ("void f() { auto b = std::make_unique<a::msg::B>(); b->c; }", "a/msg/B", ["c"]),
        ("void f() { for (a::msg::B & b : all) { b.c; } }", "a/msg/B", ["c"]),
        ("void f() { g([&](const a::msg::B & b) { b.c; }); }", "a/msg/B", ["c"]),
        ("void f() { { a::msg::B b; b.c; } b.d; }", "a/msg/B", ["c"]),
        ("void f(a::msg::B b) { b.c; }\nvoid g() { b.d; }", "a/msg/B", ["c"]),
        ("a::msg::B f() { a::msg::B b; b.c; return b; }", "a/msg/B", ["c"]),
        ("void f(a::msg::B::SharedPtr b) { b->c == b->a::msg::B::IDLE; }", "a/msg/B", ["c"]),
        ("void f(a::msg::B b) { b.c.a::msg::D::IDLE; b.B::IDLE; }", "a/msg/B", ["c"]),
    ],
)
def test_variables_that_hold_a_message(text: str, message: str, names: list[str]) -> None:
    assert paths(text) == {message: names}


@pytest.mark.parametrize(
    "text",
    [
        "void f(a::msg::B::SharedPtr b); void g() { b->c; }",
        "void f() { a::msg::B b; b.c; }\nvoid g() { Other b; b.d; }",
        "void f() { a::msg::B b; b.c; }\nvoid g(Other & b) { b.d; }",
        "void f(a::msg::B b) { g([](a::msg::D b) { b.d; }); b.c; }",
        "void f() { a::msg::B b; b.c; for (auto & [x, b] : all) { b.d; } }",
        "void f() { b.c; a::msg::B(); x::a::msg::B y; y.c; }",
    ],
)
def test_names_that_may_hold_something_else(text: str) -> None:
    assert not any(paths(text).values())


def test_the_same_name_in_two_places() -> None:
    text = "void f(a::msg::B b) { b.c; }\nvoid g(a::msg::D::SharedPtr b) { b->d; }\n"
    assert paths(text) == {"a/msg/B": ["c"], "a/msg/D": ["d"]}
    assert paths(f"{text}void h(a::msg::D b);") == paths(f"void h(a::msg::D b);\n{text}") == paths(text)


LINES = """\
find_package(std_msgs REQUIRED)
add_executable(talker src/talker.cpp)
target_link_libraries(talker PRIVATE ${std_msgs_TARGETS})
"""


def test_what_is_judged() -> None:
    def said(code: str, path: str = "src/talker.cpp") -> list[tuple[str, int, str]]:
        files = {
            "package.xml": manifest("  <depend>std_msgs</depend>\n", "ament_cmake"),
            "CMakeLists.txt": CMAKE.replace("ament_package", LINES + "ament_package"),
            "src/talker.cpp": "int main() {return 0;}\n",
            path: f"void f(std_msgs::msg::Header h, std_msgs::msg::String::SharedPtr s) {{\n  {code}\n}}\n",
        }
        found = lint_files(files, ["IDL013"]).findings
        return [(f.severity.value, len(f.related), f.message.partition(":")[0]) for f in found]

    near = "`std_msgs/msg/Header` has no field `stmp` (did you mean `stamp`?)"
    assert said("h.stamp.sec = 1; s->data = h.frame_id;") == []
    assert said("h.stmp.sec = 1; h.stmp.sec = 2;") == [("error", 1, near)]
    assert said("h.stmp.sec = 1;", "include/my_pkg/a.hpp") == [("info", 0, near)]
    assert said("h.stmp.sec = 1;", "docs/a.cpp") == []
    two = "h.stmp.sec = 1;\n}\nvoid g(std_msgs::msg::String h) {\n  h.{};"
    assert said(two.replace("{}", "data")) == [("error", 0, near)]
    assert said(two.replace("{}", "stmp")) == [("error", 0, near)]
    assert said(two.replace("{}", "dataa").replace("stmp", "stamp")) == [
        ("error", 0, "`std_msgs/msg/String` has no field `dataa` (did you mean `data`?)")
    ]
    assert said("h.something = 1;") == []
    assert said("h.seq = 1;") == [("error", 0, "`std_msgs/msg/Header` has no field `seq`")]
    assert said("h._data; s->_dat; // h.stmp\n") == []
    assert said("#if A\n h.stmp = 1;\n#endif") == []
