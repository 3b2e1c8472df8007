#pragma once
#include "geometry_msgs/msg/pose_stamped.hpp"
namespace geometry_msgs::msg {struct Twist {Vector3 linear, angular;};}
