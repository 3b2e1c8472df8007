// The name of the header from Lyrical on.

#ifndef TF2_ROS__BUFFER_HPP_
#define TF2_ROS__BUFFER_HPP_

#include "tf2_ros/buffer.h"

#endif  // TF2_ROS__BUFFER_HPP_
