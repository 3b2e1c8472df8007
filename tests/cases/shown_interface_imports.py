"""Sentences about imports of interfaces that no example shows."""

from __future__ import annotations

from rospkg_cli.example import INTERFACES_BODY, INTERFACES_CMAKE, SETUP_PY, Example, manifest

from .setups import python

STD = manifest("  <exec_depend>std_msgs</exec_depend>\n  <exec_depend>my_ifs</exec_depend>\n")

UNKNOWN = SETUP_PY.replace("find_packages(exclude=['test'])", "found()")
NO_SRV = INTERFACES_CMAKE.replace('  "srv/SetMode.srv"\n', "")
PLAIN = manifest(INTERFACES_BODY, "cmake").replace("my_pkg", "my_ifs")


def importing(line: str, **files: str | None) -> Example:
    paths = {name.replace("__", "/").replace("_DOT_", "."): each for name, each in files.items()}
    return python({"package.xml": STD, "my_pkg/talker.py": line, **paths})


def beside(line: str, cmake: str = INTERFACES_CMAKE, **files: str | None) -> Example:
    """A package that imports from a package of interfaces in the workspace."""
    mine = {f"a/{path}": text for path, text in importing(line, **files).bad_files().items()}
    others = {
        "b/package.xml": manifest(INTERFACES_BODY, "ament_cmake").replace("my_pkg", "my_ifs"),
        "b/CMakeLists.txt": cmake.replace("my_pkg", "my_ifs"),
        "b/msg/Status.msg": "float32 battery\nuint8 IDLE=0\n",
        "b/srv/SetMode.srv": "string mode\n---\nbool success\n",
    }
    return Example(on="", bad={**mine, **others}, good={})


CASES = {
    "IDL011": (
        importing("from std_msgs.msg import string, _string, Color, Int65, Bool\n"),
        beside("from my_ifs.msg import Status\nfrom my_ifs.srv import SetMode\n", NO_SRV),
        beside("def f():\n    from my_ifs.srv import SetMode_Request\n    return SetMode_Request\n", NO_SRV),
        # the file may be in the variable, be another one by its name, or of the branch for ROS 1
        beside("from my_ifs.srv import SetMode\n", NO_SRV.replace('"msg/', '${EXTRA} "msg/')),
        beside("from my_ifs.srv import SetMode\n", NO_SRV.replace('"msg/', '"srv/Set_Mode.srv" "msg/')),
        beside("from my_ifs.srv import SetMode\n", "add_service_files(FILES SetMode.srv)\n" + NO_SRV),
        importing("from std_msgs.msg import *\n"),
        importing("from std_srvs.srv import Empty, EmptyRequest, SetBoolResponse, TakeRequest, Empty_Request\n"),
        importing("import rospy\nfrom std_srvs.srv import EmptyRequest\n"),
        importing("try:\n    from std_srvs.srv import EmptyRequest\nexcept ImportError:\n    pass\n"),
        importing("from std_msgs.msg._string import Strin\nfrom .std_msgs.msgs import a\n"),
        importing("from std_msgs.message import String\nimport std_srvs.service\nfrom std_msgs.srvs import a\n"),
        importing("from std_srvs.msg import Trigger\nfrom std_srvs.srv import SetBool_Request, Triger\n"),
        importing(
            "from nav_msgs.srv import Odometry\nfrom unknown_msgs.msgs import A\nfrom unknown_msgs.msg import B\n"
        ),
        importing("from nav2_msgs.action import NavigateToPos, NavigateToPose_Feedback\n"),
        importing("try:\n    from std_msgs.msg import Sting\nexcept ImportError:\n    pass\n"),
        importing("def f():\n    from std_msgs.msg import Sting\n    return Sting\n"),
        importing("import rospy\nfrom std_msgs.msg import Sting\n"),
        importing("print(1)\n", tools__a_DOT_py="from std_msgs.msg import Sting\n"),
        importing("import my_pkg.srv\nfrom my_pkg.action import Drive\n"),
        importing("from my_pkg.msg import A\n", my_pkg__msg_DOT_py="A = 1\n"),
        python({"my_pkg/talker.py": "from my_pkg.msg import A\n", "setup.py": UNKNOWN}),
        beside("from my_ifs.msg import Statu, Status\nfrom my_ifs.srv import SetMode_Response, SetModes, SetMode\n"),
        beside("from my_ifs.msg import Unlike\nfrom my_ifs.srv import Status\nfrom my_ifs.action import Drive\n"),
        beside("from my_ifs.msgs import Status\nfrom my_ifs.utils import a\nfrom my_ifs.actions import b\n"),
        beside("from my_pkg.msg import Status\nfrom my_pkg.msg import Status, Unlike\nfrom my_pkg.srv import *\n"),
        importing("from std_msgs import String, Sting, msg\nimport std_msgs.Bool\nimport std_msgs\n"),
        importing("from std_srvs import Trigger, SetBool as S\nfrom unknown_msgs import A\nfrom . import String\n"),
        importing("def f():\n    from std_msgs import String\n    return String\n"),
        importing("import rospy\nfrom std_msgs import String\n"),
        importing("from my_pkg import Status\n", my_pkg____init___DOT_py="Status = 1\n"),
        beside("from my_ifs import Status, SetMode, other\nimport my_ifs.Status\n"),
        beside("from my_ifs import Status\n", INTERFACES_CMAKE + "ament_python_install_package(my_ifs)\n"),
        beside("from my_ifs.msg import Statu\n", INTERFACES_CMAKE + "rosidl_generate_interfaces(other ${FILES})\n"),
        Example(on="", bad={**beside("from my_ifs.msg import Statu\n").bad, "b/package.xml": PLAIN}, good={}),
    ),
}
