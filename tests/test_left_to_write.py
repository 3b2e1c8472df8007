"""What an exercise leaves blank at the top of a file: a comment names it, or asks for the code of the file."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.python.left_blank import asks_at_the_top, has_task, is_asked_for
from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

PYTHON = {
    **existing_files(BACKDROPS["ament_python"]),
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n  <exec_depend>ros2launch</exec_depend>\n"),
    "setup.py": setup_py(scripts("go = my_pkg.go:main")),
}
CPP = {
    **existing_files(BACKDROPS["ament_cmake"]),
    "CMakeLists.txt": CMAKE.replace(
        "ament_package", "add_executable(go src/go.cpp)\ninstall(TARGETS go DESTINATION lib/my_pkg)\nament_package"
    ),
}
LAUNCHES = {
    **CPP,
    "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
    "CMakeLists.txt": CMAKE.replace(
        "ament_package", "install(DIRECTORY launch DESTINATION share/my_pkg)\nament_package"
    ),
}
NODE = "import rclpy\n\n\n{comment}\n\n\ndef main():\n    rclpy.init()\n    rclpy.spin(Listener())\n"
IMPORTS = "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n{comment}\n"


def level(files: dict[str, str], code: str) -> tuple[str, bool]:
    (found,) = lint_files(files, [code]).findings
    return found.severity.value, "still to be" in found.message


NAMING = [
    "# TODO: implement a class Listener",
    "# TODO: Implementar una clase Listener que herede de Node y que:\n#  - imprima",
    "# Exercise 2:\n#   write the class `Listener`",
    "# Aufgabe: Erstelle eine Klasse Listener",
    "# TODO : créer la classe Listener",
    "# 課題: class Listener を作成する",
    "# TODO: 实现 Listener 类\n# TODO: class Listener",
]


@pytest.mark.parametrize("comment", NAMING)
def test_a_class_that_a_comment_asks_for(comment: str) -> None:
    assert level({**PYTHON, "my_pkg/go.py": NODE.format(comment=comment)}, "DEP117") == ("info", True)


@pytest.mark.parametrize("comment", ["# TODO: tune this", "# Listener is made below", "# TODO: add a talker", "# done"])
def test_a_class_that_no_comment_asks_for(comment: str) -> None:
    assert level({**PYTHON, "my_pkg/go.py": NODE.format(comment=comment)}, "DEP117") == ("error", False)


CODE = [
    "# YOUR CODE HERE",
    "# Add your code below",
    "# 以下にコードを追加してください",
    "# 在此处添加你的代码",
    "# 请在下面编写代码",
    "# 여기에 코드를 작성하세요",
    "# Hier deinen Code einfügen",
    "# Escribe tu código aquí",
    "# Écrivez votre code ici",
    "# Scrivi qui il tuo codice",
    "# TODO: define generate_launch_description",
    "# TODO: write main()",
]


@pytest.mark.parametrize("comment", CODE)
def test_a_file_that_is_a_blank(comment: str) -> None:
    assert level({**LAUNCHES, "launch/a.launch.py": IMPORTS.format(comment=comment)}, "LCH001") == ("info", True)
    assert level({**PYTHON, "my_pkg/go.py": f"import rclpy\n\n{comment}\n"}, "SET102") == ("info", True)


@pytest.mark.parametrize("comment", ["# TODO: tune the rate", "# the node of the arm", "# add it later"])
def test_a_file_without_a_task(comment: str) -> None:
    text = f"{IMPORTS.format(comment=comment)}\nnode = Node(package='a', executable='b')\n"
    assert level({**LAUNCHES, "launch/a.launch.py": text}, "LCH001") == ("error", False)
    assert level({**PYTHON, "my_pkg/go.py": f"import rclpy\n\n{comment}\n"}, "SET102") == ("error", False)


def test_holes_in_commented_code() -> None:
    text = "# class Go:\n#     def go(self):\n#         self.pub = self.create_publisher(???, 10)\n"
    assert level({**PYTHON, "my_pkg/go.py": text}, "SET102") == ("info", True)
    assert level({**PYTHON, "my_pkg/go.py": text + "x = [1]\n"}, "SET102") == ("error", False)


def test_an_import_of_what_a_module_leaves_blank() -> None:
    go = "from my_pkg.arm import move\n\n\ndef main():\n    move()\n"
    files = {**PYTHON, "my_pkg/go.py": go}
    assert level({**files, "my_pkg/arm.py": "import math\n\n# TODO: write the function move\n"}, "DEP109") == (
        "info",
        True,
    )
    assert level({**files, "my_pkg/arm.py": "import math\n\n# TODO: make it faster\n"}, "DEP109") == ("error", False)


def test_a_name_in_a_launch_file() -> None:
    text = (
        "from launch import LaunchDescription\n\n\ndef generate_launch_description():\n"
        "    {comment}\n    return LaunchDescription([talker])\n"
    )
    files = {**LAUNCHES, "launch/a.launch.py": text.format(comment="# TODO: create the node of the talker")}
    assert level(files, "LCH013") == ("info", True)
    files = {**LAUNCHES, "launch/a.launch.py": text.format(comment="# TODO: later")}
    assert level(files, "LCH013") == ("error", False)


@pytest.mark.parametrize(
    ("comment", "expected"),
    [
        ("// TODO: write the main function", ("info", True)),
        ("// YOUR CODE HERE", ("info", True)),
        ("// the talker", ("error", False)),
    ],
)
def test_a_program_of_cpp(comment: str, expected: tuple[str, bool]) -> None:
    text = f"#include <cstdio>\n\n{comment}\n"
    assert level({**CPP, "src/go.cpp": text}, "CMK125") == expected


def test_names_that_are_words() -> None:
    assert is_asked_for("# TODO: write the class listener", "listener")
    assert is_asked_for("# TODO: create `listener`", "listener")
    assert not is_asked_for("# TODO: add a listener of another kind", "listener")
    assert not is_asked_for("# TODO: import listeners", "Listen")


def test_comments_in_a_block_ask_for_no_file() -> None:
    assert asks_at_the_top("import a\n# your code here\n")
    assert not asks_at_the_top("def a():\n    # your code here\n    pass\n")
    assert not has_task("# what does it do?\n")


SETUP = PYTHON["setup.py"]
TASKED = [
    (
        {**PYTHON, "setup.py": SETUP.replace("'go = ", "# TODO: create go.py\n            'go = ")},
        "SET101",
        "# TODO: create go.py",
    ),
    (
        {
            **CPP,
            "CMakeLists.txt": CPP["CMakeLists.txt"].replace("add_exec", "# TODO: write go.cpp\nadd_exec"),
        },
        "CMK102",
        "# TODO: write go.cpp",
    ),
    (
        {
            **PYTHON,
            "package.xml": manifest("  <!-- TODO: add the dependencies of your node -->\n"),
            "my_pkg/go.py": "import rclpy\n\n\ndef main():\n    rclpy.init()\n",
        },
        "DEP101",
        "<!-- TODO: add the dependencies of your node -->",
    ),
    (
        {
            **PYTHON,
            "my_pkg/go.py": "import rclpy\nfrom rclpy.node import Node\n\n\nclass Go(Node):\n    def __init__(self):\n"
            "        super().__init__('go')\n        # TODO: declare the parameter `speed`\n"
            "        self.speed = self.get_parameter('speed').value\n\n\n"
            "def main():\n    rclpy.init()\n    rclpy.spin(Go())\n",
        },
        "PRM007",
        "# TODO: declare the parameter `speed`",
    ),
    (
        {
            **CPP,
            "CMakeLists.txt": CMAKE.replace(
                "ament_package",
                "find_package(rclcpp REQUIRED)\nadd_executable(go src/go.cpp)\n"
                "target_link_libraries(go rclcpp::rclcpp)\n# TODO: install the executables\nament_package",
            ),
            "src/go.cpp": "#include <rclcpp/rclcpp.hpp>\n\nint main(int argc, char ** argv)\n{\n"
            '  rclcpp::init(argc, argv);\n  rclcpp::spin(std::make_shared<rclcpp::Node>("go"));\n}\n',
        },
        "CMK103",
        "# TODO: install the executables",
    ),
]


@pytest.mark.parametrize(("files", "code", "task"), TASKED, ids=[code for _, code, _ in TASKED])
def test_what_a_comment_beside_it_asks_for(files: dict[str, str], code: str, task: str) -> None:
    assert level(files, code) == ("info", True)
    plain = "<!-- TODO: tune this -->" if task.startswith("<!") else "# TODO: tune this"
    assert level({path: text.replace(task, plain) for path, text in files.items()}, code)[0] != "info"


def test_a_method_whose_name_a_comment_spells_out() -> None:
    assert is_asked_for("# TODO: write the timer callback", "timer_callback")
    assert is_asked_for("# TODO: add my talker here", "MyTalker")
    assert not is_asked_for("# TODO: write the callback of a timer", "timer_callback")


def test_a_docstring_that_asks_for_the_module() -> None:
    text = '"""Exercise 3.\n\nImplement a node that listens.\n"""\n'
    assert level({**PYTHON, "my_pkg/go.py": text}, "SET102") == ("info", True)


@pytest.mark.parametrize(
    ("page", "is_mild"),
    [
        ("In exercise 2 you create `src/go.cpp`.\n", True),
        ("touch src/go.cpp\n", True),
        ("Write the node in go.cpp, then build.\n", True),
        ("`go.cpp` is the node, which we wrote to create maps.\n", False),
        ("Create a workspace.\n\n- src/go.cpp: the node\n", False),
    ],
)
def test_a_source_that_a_page_has_people_write(page: str, is_mild: bool) -> None:
    (found,) = lint_files({**CPP, "README.md": page}, ["CMK102"]).findings
    assert (found.severity.value, found.message.endswith("; a page has people write it")) == (
        ("info", True) if is_mild else ("error", False)
    )


@pytest.mark.parametrize(("hole", "expected"), [("???", "info"), ("<MESSAGE_TYPE>", "info"), ("a b", "error")])
def test_a_line_of_python_with_a_blank(hole: str, expected: str) -> None:
    text = f"import rclpy\n\n\ndef main():\n    rclpy.init()\n    print({hole}, 10)\n"
    (found,) = lint_files({**PYTHON, "my_pkg/go.py": text}, ["RPK001"]).findings
    assert found.severity.value == expected


@pytest.mark.parametrize(
    ("comment", "expected"), [("# TODO: add the fields x and y", ("info", True)), ("# TODO: rename", ("error", False))]
)
def test_fields_that_a_message_is_still_to_get(comment: str, expected: tuple[str, bool]) -> None:
    go = "from a_msgs.msg import Pose2\n\n\ndef main():\n    pose = Pose2()\n    pose.x = 1.0\n    print(pose)\n"
    generate = 'find_package(rosidl_default_generators REQUIRED)\nrosidl_generate_interfaces(a_msgs "msg/Pose2.msg")\n'
    own = {f"my_pkg/{path}": text for path, text in {**PYTHON, "my_pkg/go.py": go}.items()}
    messages = {
        "a_msgs/package.xml": manifest("", "ament_cmake", "a_msgs"),
        "a_msgs/CMakeLists.txt": CMAKE.replace("my_pkg", "a_msgs").replace("ament_package", generate + "ament_package"),
        "a_msgs/msg/Pose2.msg": f"{comment}\n",
    }
    assert level({**own, **messages}, "IDL010") == expected
