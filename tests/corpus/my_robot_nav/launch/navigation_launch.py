from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='my_robot_nav', executable='nav_node', parameters=['config/nav_params.yaml']),
        Node(package='my_robot_nav', executable='path_planner'),
    ])
