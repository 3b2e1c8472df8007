#pragma once
#include "tf2_ros/buffer.h"
namespace nav2 {using TransformBuffer = tf2_ros::Buffer;}
