from setuptools import setup
import os
from glob import glob

package_name = 'my_robot_nav'

setup(
    name=package_name,
    version='1.0.0',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages',
            ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        (os.path.join('share', package_name, 'launch'), glob('launch/*.py')),
        (os.path.join('share', package_name, 'config'), glob('config/*.yaml')),
    ],
    install_requires=[
        'setuptools',
        'numpy',  # External Python library
        'scipy',  # Another external library
        'opencv-python'  # Computer vision library
    ],
    zip_safe=True,
    maintainer='Developer',
    maintainer_email='dev@robot.com',
    description='Navigation package for my robot',
    license='Apache-2.0',
    tests_require=['pytest'],
    entry_points={
        'console_scripts': [
            'nav_node = my_robot_nav.nav_node:main',
            'path_planner = my_robot_nav.path_planner:main',
            'nav_cli = my_robot_nav.nav_cli:main',
        ],
    },
)
