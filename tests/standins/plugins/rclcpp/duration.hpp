#pragma once
namespace rclcpp {class Duration {};}
