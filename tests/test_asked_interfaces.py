"""Messages, services and actions as they are typed."""

from __future__ import annotations

import pytest
from planned import plan, texts

from rospkg_cli.scaffold import ScaffoldError
from rospkg_cli.scaffold.interface import interfaces_of


def one(form: str, *asked: str) -> dict[str, str]:
    return {each.path: each.text for each in interfaces_of({form: asked})}


ASKED = {
    ("msg", "RobotStatus:float32 battery_level, string current_task"): "float32 battery_level\nstring current_task\n",
    ("msg", "A:int32[2] v [1, 2]; string s \"a,b;c\"; string t 'x'"):
        "int32[2] v [1, 2]\nstring s \"a,b;c\"\nstring t 'x'\n",
    ("msg", "A:uint8 OK=0,uint8   BAD = 1\n  uint8 state"): "uint8 OK=0\nuint8 BAD = 1\nuint8 state\n",
    ("msg", "A:string label \"two  blanks\""): "string label \"two  blanks\"\n",
    ("msg", "A:"): "",
    ("srv", "Go:float32 x --- bool ok, string why"): "float32 x\n---\nbool ok\nstring why\n",
    ("srv", "Ping:---"): "---\n",
    ("srv", "Ping:\n---\nbool ok\n"): "---\nbool ok\n",
    ("action", "Fly:float32 height---bool ok---float32 left"): None,
    ("action", "Fly:float32 height --- bool ok --- float32 left"): "float32 height\n---\nbool ok\n---\nfloat32 left\n",
}  # fmt: skip


@pytest.mark.parametrize("form, asked", [key for key, text in ASKED.items() if text is not None])
def test_fields_become_lines(form: str, asked: str) -> None:
    [(path, text)] = one(form, asked).items()
    assert path == f"{form}/{asked.partition(':')[0]}.{form}"
    assert text == ASKED[form, asked]


@pytest.mark.parametrize("form, separators", [("msg", 0), ("srv", 1), ("action", 2)])
def test_what_has_no_fields_gets_some(form: str, separators: int) -> None:
    [text] = one(form, "Thing").values()
    assert text.splitlines().count("---") == separators
    assert len(text.splitlines()) > separators


REFUSED = {
    ("msg", "robot_status"): "try `RobotStatus`",
    ("msg", "Robot-Status"): "try `RobotStatus`",
    ("msg", "2D"): "uppercase letter first",
    ("msg", "A:int x"): "write `int32`",
    ("msg", "A:Header header"): "std_msgs/Header",
    ("msg", "A:time stamp"): "builtin_interfaces/Time",
    ("msg", "A:string"): "in `string`",
    ("msg", "A:Pose pose"): "write `geometry_msgs/Pose`",
    ("msg", "A:Path path"): "write `nav_msgs/Path`",
    ("msg", "A:Thing thing"): "--msg Thing",
    ("msg", "A:int32 x --- int32 y"): "no `---`",
    ("srv", "A:int32 x"): "one `---`",
    ("action", "A:int32 x --- int32 y"): "two `---`",
}


@pytest.mark.parametrize("form, asked", REFUSED)
def test_what_rosidl_would_not_take_is_refused(form: str, asked: str) -> None:
    with pytest.raises(ScaffoldError, match=REFUSED[form, asked]):
        plan("my_interfaces", template="interfaces", **{form + "s": (asked,)})


def test_faults_that_only_the_linter_knows_are_the_users_too() -> None:
    with pytest.raises(ScaffoldError, match=r"msg/A.msg: .*`class`"):
        plan("my_interfaces", template="interfaces", msgs=("A:int32 class",))


def test_a_name_stands_for_one_file() -> None:
    with pytest.raises(ScaffoldError, match="twice"):
        one("msg", "A", "A:int32 x")
    assert set(texts(plan("my_interfaces", template="interfaces", msgs=("A",), srvs=("A",)))) > {
        "msg/A.msg",
        "srv/A.srv",
    }


def test_messages_may_use_each_other() -> None:
    files = texts(
        plan("my_interfaces", template="interfaces", msgs=("Path:Pose[] poses", "Pose:my_interfaces/A a", "A:"))
    )
    assert files["msg/Path.msg"] == "Pose[] poses\n"
    assert "<depend>" not in files["package.xml"]


def test_what_is_used_is_declared_found_and_passed_on() -> None:
    used = ("A:geometry_msgs/Pose[] p, std_msgs/Header header",)
    files = texts(plan("my_interfaces", template="interfaces", msgs=used, depends=("nav_msgs", "std_msgs")))
    for name in ("geometry_msgs", "nav_msgs", "std_msgs"):
        assert files["package.xml"].count(f"<depend>{name}</depend>") == 1
        assert files["CMakeLists.txt"].count(f"find_package({name} REQUIRED)\n") == 1
        assert files["CMakeLists.txt"].count(f"  {name}\n") == 1


@pytest.mark.parametrize("distro", ["humble", "jazzy"])
def test_actions_want_action_msgs_declared(distro: str) -> None:
    files = texts(plan("my_interfaces", template="interfaces", actions=("Fly",), distro=distro))
    assert files["package.xml"].count("<depend>action_msgs</depend>") == 1
    files = texts(plan("my_interfaces", template="interfaces", msgs=("Height:float32 x",), distro=distro))
    assert "action_msgs" not in files["package.xml"]


@pytest.mark.parametrize("form", ["msg", "srv", "action"])
def test_elsewhere_they_are_refused_with_the_command_to_run(form: str) -> None:
    command = f"rospkg new my_robot_nav_interfaces --type interfaces --{form} 'Status:int32 x'"
    with pytest.raises(ScaffoldError, match=command):
        plan(**{form + "s": ("Status:int32 x",)})


@pytest.mark.parametrize("template", ["interfaces", "description"])
def test_a_package_that_only_has_data_has_no_nodes(template: str) -> None:
    with pytest.raises(ScaffoldError, match="rospkg new my_robot_nodes --node talker"):
        plan(f"my_robot_{template}", template=template, nodes=("talker",))
