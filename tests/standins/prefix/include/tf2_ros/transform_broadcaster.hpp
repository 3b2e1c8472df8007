// The name of the header from Lyrical on.

#ifndef TF2_ROS__TRANSFORM_BROADCASTER_HPP_
#define TF2_ROS__TRANSFORM_BROADCASTER_HPP_

#include "tf2_ros/transform_broadcaster.h"

#endif  // TF2_ROS__TRANSFORM_BROADCASTER_HPP_
