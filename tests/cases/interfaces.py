"""Sentences about interfaces that no example shows."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, INTERFACES_CMAKE, Example, manifest
from rospkg_cli.rules.interfaces import idl012_unknown_interface_in_cpp as idl012
from rospkg_cli.rules.interfaces import idl013_unknown_field_in_cpp as idl013

STATUS = '  "msg/Status.msg"\n'
CALL = "rosidl_generate_interfaces(${PROJECT_NAME}\n"


def listed(old: str, new: str, **files: str) -> Example:
    """A package of interfaces with another list, and messages by their names."""
    named = {f"msg/{name}.msg": text for name, text in files.items()}
    return Example(bad={"CMakeLists.txt": INTERFACES_CMAKE.replace(old, new), **named}, good={}, on="interfaces")


def perhaps(text: str, name: str = "Status") -> tuple[Example, ...]:
    """A message that is listed under a condition, by something unknown, in a comment, and not at all."""
    asked = f"if(SOMETHING)\n  list(APPEND files msg/{name}.msg)\nendif()\n{CALL}  ${{files}}\n"
    return (
        listed(CALL + STATUS, asked, **{name: text}),
        listed(STATUS, "  ${FILES_OF_ANOTHER}\n", **{name: text}),
        listed(STATUS, f'  # "msg/{name}.msg"\n', **{name: text}),
        listed(STATUS, "", **{name: text}),
    )


OLD = {"srvs/Pause.srv": "---\n", "srvs/Clear.srv": "---\n", "msg/srv/Reset.srv": "---\n"}
OLD_CMAKE = INTERFACES_CMAKE.replace('srv/SetMode.srv"', 'srvs/Pause.srv" "srvs/Clear.srv" "msg/srv/Reset.srv"')

WAYS = (
    "add_executable(more src/more.cpp)\n",
    "if(WITH_MORE)\n  add_executable(more src/more.cpp)\nendif()\n",
    "if(BUILD_TESTING)\n  add_executable(more src/more.cpp)\nendif()\n",
)
"""How a file is compiled: by every build, by those that are asked for it, with the tests."""


def compiled(lines: str, source: str, files: dict[str, str]) -> Example:
    """A package with lines more in its CMakeLists.txt, and a source for them beside a faultless one."""
    text = files.get("CMakeLists.txt", CMAKE).replace("ament_package", f"{lines}ament_package")
    main = {"src/talker.cpp": "int main() {return 0;}\n"}
    return Example(bad={**files, "CMakeLists.txt": text, **main, "src/more.cpp": source}, good={}, on="ament_cmake")


CASES = {
    "IDL001": (*perhaps("int a\n"), *perhaps("Header header\n")),
    "IDL002": (
        *perhaps("int32 a\n", "a_status"),
        listed("Status", "8", **{"8": "int32 a\n"}),
        Example(bad={"CMakeLists.txt": OLD_CMAKE, "srv/SetMode.srv": None, **OLD}, good={}, on="interfaces"),
        Example(
            bad={"CMakeLists.txt": INTERFACES_CMAKE.replace("msg/Status", "Status"), "Status.msg": "int32 a\n"},
            good={},
            on="interfaces",
        ),
        listed(STATUS, '  "msg/${KIND}/Diag.msg"\n', **{"a/Diag": "int32 a\n", "b/Diag": "int32 a\n"}),
    ),
    "IDL003": (*perhaps("int32 from\nint32 A\nint32 b\nint32 b\nint32 sequence\n"),),
    "IDL004": (*perhaps("Nothing a\n"),),
    "IDL005": (
        listed(STATUS, f'  # "msg/Zone.msg"\n{STATUS}', Zone="int32 a\n"),
        listed(STATUS, f'  # "msg/Zones.msg"\n{STATUS}', Zone="int32 a\n"),
        listed("rosidl_gen", "include(${x_DIR}/x.cmake)\nrosidl_gen", Zone="int32 a\n"),
        Example(bad={".gitignore": "msg/Zone.msg\n", "msg/Zone.msg": "int32 a\n"}, good={}, on="interfaces"),
        listed("rosidl_gen", "add_message_files(FILES Zone.msg)\nrosidl_gen", Zone="int32 a\n"),
        Example(
            bad={
                "CMakeLists.txt": INTERFACES_CMAKE.replace(
                    STATUS, f'{STATUS}  "${{CMAKE_CURRENT_SOURCE_DIR}}/ros2:msg/Zone.msg"\n'
                ),
                "msg/Zone.msg": "int32 a\n",
                "ros2/msg/Zone.msg": "int32 a\n",
            },
            good={},
            on="interfaces",
        ),
    ),
    "IDL007": (*perhaps("std_msgs/Header a\n"),),
    "IDL008": (
        Example(bad={f"msg/{name}.msg": "int32 a\n" for name in "ABCD"}, good={}),
        Example(bad={"msg/A.msg": "int32 a\n", "msg/B.msg": "int32 a\n", "data/msg/C.msg": "int32 a\n"}, good={}),
        *(
            Example(
                bad={
                    "a/package.xml": manifest(name="a"),
                    "a/setup.py": "",
                    "a/msg/A.msg": "int32 a\n",
                    "b/package.xml": manifest(build_type="ament_cmake", name="b"),
                    "b/CMakeLists.txt": INTERFACES_CMAKE.replace("my_pkg", "b"),
                    "b/msg/A.msg": "int32 a\n",
                    **more,
                },
                good={},
                on="",
            )
            for more in ({}, {"a/a/talk.py": "from b.msg import A\n"}, {"a/a/talk.py": "from a.msg import A\n"})
        ),
    ),
    "IDL013": (
        *(compiled(lines, idl013.VALUE.replace("text.data", "text.daat"), idl013.FILES) for lines in WAYS),
        Example(
            bad={
                **idl013.FILES,
                "include/my_pkg/a.hpp": idl013.VALUE.replace("text.data", "text.daat"),
                "src/talker.cpp": "int main() {return 0;}\n",
            },
            good={},
            on="ament_cmake",
        ),
        Example(
            bad={
                **idl013.FILES,
                "src/talker.cpp": idl013.VALUE.replace("return text.data", "text.dta; return text.dta"),
            },
            good={},
            on="ament_cmake",
        ),
        Example(
            bad={**idl013.FILES, "src/talker.cpp": idl013.POINTER.replace("stamp.sec", "seq")},
            good={},
            on="ament_cmake",
        ),
    ),
    "IDL012": (
        Example(
            bad={
                **idl012.FILES,
                "src/talker.cpp": "int main() {return 0;}\n",
                "include/my_pkg/a.hpp": "#include <std_msgs/msg/strng.hpp>\n",
            },
            good={},
            on="ament_cmake",
        ),
        *(compiled(lines, "#include <std_msgs/msg/strng.hpp>\n", idl012.FILES) for lines in WAYS),
        Example(
            bad={
                "CMakeLists.txt": INTERFACES_CMAKE.replace('  "srv/SetMode.srv"\n', "").replace(
                    "ament_package", "add_library(a src/a.cpp)\nament_package"
                ),
                "src/a.cpp": "#include <my_pkg/msg/status.hpp>\n#include <my_pkg/srv/set_mode.hpp>\n",
            },
            good={},
            on="interfaces",
        ),
        compiled(
            "",
            "",
            {"package.xml": idl012.FILES["package.xml"], "include/my_pkg/a.hpp": "#include <std_msgs/msg/strng.hpp>\n"},
        ),
        Example(
            bad={
                "CMakeLists.txt": INTERFACES_CMAKE.replace("ament_package", "add_library(a src/a.cpp)\nament_package"),
                "src/a.cpp": "#include <my_pkg/msg/other.hpp>\n#include <my_pkg/srv/setmode.hpp>\n",
            },
            good={},
            on="interfaces",
        ),
    ),
}
