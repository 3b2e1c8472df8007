// The name of the header from Lyrical on.

#ifndef TF2_ROS__TRANSFORM_LISTENER_HPP_
#define TF2_ROS__TRANSFORM_LISTENER_HPP_

#include "tf2_ros/transform_listener.h"

#endif  // TF2_ROS__TRANSFORM_LISTENER_HPP_
