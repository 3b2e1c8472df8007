"""Paths in somebody's home folder: what no example shows."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

from .setups import python

HOME = "/home/ada/ws/src/my_pkg"
LAUNCH = """\
<launch>
  <node pkg="a" exec="a">
    <param from="$(find-pkg-share my_pkg)/config/a.yaml"/>
  </node>
</launch>
"""
INSTALLS = "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package"
FILES = {"data/people.txt": "Ada\n"}

CASES = {
    "DEP118": (
        python(
            {
                **FILES,
                "my_pkg/talker.py": f"open('«{HOME}/data/people.txt»')\nopen('«/home/ada/out.txt»')\n",
                "my_pkg/listener.py": "# open('/home/ada/never.txt')\nopen('/Users/ada/code/data/people.txt')\n",
                "my_pkg/words.py": "open('/home/ubuntu/words.txt')\nopen(f'/home/ada/{name}.txt')\n",
            }
        ),
        python({"my_pkg/talker.py": "open('«/home/ubuntu/ws/src/my_pkg/data/people.txt»')\n", **FILES}),
        python({"my_pkg/talker.py": "open('«/home/ros2_ws/src/my_pkg/data/people.txt»')\n", **FILES}),
        python({"my_pkg/talker.py": "open('«/home/rover-docker/src/my_pkg/data/people.txt»')\n", **FILES}),
        python(
            {
                **FILES,
                "my_pkg/talker.py": f"if exists('«{HOME}/data/people.txt»'):\n    open('/home/ada/out.txt')\n",
            }
        ),
        python(
            {
                **FILES,
                "my_pkg/talker.py": "try:\n    a = find()\nexcept KeyError:\n    if a:\n"
                f"        a = '«{HOME}/data/people.txt»'\n",
                "my_pkg/words.py": "try:\n    a = find()\nexcept KeyError:\n    pass\nopen('/home/ada/a.txt')\n",
            }
        ),
        python(
            {
                "src/talker.cpp": f'auto a = open("«{HOME}/a.txt»");\n',
                "include/talker.hpp": "bool is_there = std::filesystem::exists(a);\n",
            }
        ),
        python({"CMakeLists.txt": f"link_directories(\n  «{HOME}/lib»)\nadd_executable(a {HOME}/src/a.cpp)\n"}),
        python(
            {
                "my_pkg/talker.py": "a = 1  # open('/home/ada/a.txt')\n'''\nopen('/home/ada/b.txt')\n'''\n"
                "if a:\n    \"see '/home/ada/c.txt'\"\n    open('«/home/ada/d.txt»')\n",
                "config/a.yaml": "a: 1 # '/home/ada/e.txt'\n",
            }
        ),
        python({"cad/draw.py": "save('«/home/ada/ws/src/my_pkg/data/people.txt»')\n", **FILES}),
        python({"rviz/a.rviz": "a:\n  File: «/home/ada/ws/src/my_pkg/data/people.txt»\n", **FILES}),
        python({"my_pkg/talker.py": f"import sys\nsys.path.append('«{HOME}/lib»')\nopen('/home/ada/a.txt')\n"}),
        python({"my_pkg/talker.py": f"import sys\nsys.path.append(\n    '«{HOME}/lib»')\nopen('/home/ada/a.txt')\n"}),
        python(
            {
                **FILES,
                "docker/Dockerfile": "RUN useradd -m rover\n",
                "my_pkg/talker.py": "open('«/home/rover/ws/src/my_pkg/data/people.txt»')\n",
            }
        ),
        python({"src/talker.cpp": f'/* "/home/ada/a.txt" */ auto a = open("«{HOME}/a.txt»");\n'}),
        python({"src/talker.cpp": f'auto say = "a:={HOME}/a.txt\\n"; auto a = open("«{HOME}/b.txt»");\n'}),
        python({"launch/a.launch.xml": f'<launch>\n  <let name="a" value="«{HOME}/a.yaml»"/>\n</launch>\n'}),
        python({"config/a.yaml": "a:\n  - «/home/ada/one.txt»\n  - '/home/ada/two.txt' # two\nb: see /home/ada/c\n"}),
        python({"config/a.yaml": f"a: «{HOME}/a.txt»\n"}),
        python({"config/a.yaml": f"a: «{HOME}/a.txt»\n", "my_pkg/talker.py": "open('config/a.yaml')\n"}),
        Example(
            on="",
            good={},
            bad={
                f"{name}/{path}": text.replace("share my_pkg)", f"share {first})")
                for name, first in (("first", "first"), ("copy", "first"), ("third", "third"))
                for path, text in {
                    "package.xml": manifest("", "ament_cmake").replace("<name>my_pkg", f"<name>{name}"),
                    "CMakeLists.txt": CMAKE.replace("(my_pkg)", f"({name})").replace("ament_package", INSTALLS),
                    "config/a.yaml": f"a:\n  ros__parameters:\n    yaml_filename: «/home/ada/{name}/a.txt»\n",
                    "a.txt": "",
                    "launch/a.launch.xml": LAUNCH if name != "third" else "<launch/>\n",
                }.items()
            },
        ),
        python({"CMakeLists.txt": "# /home/ada/a\ninclude_directories(«/home/ada/acme/include» /home/ada/${X})\n"}),
        python({"CMakeLists.txt": "set(WORDS\n  «/home/ada/ws/src/my_pkg/data/people.txt»)\n", **FILES}),
    )
}
