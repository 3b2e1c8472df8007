#pragma once
namespace rclcpp {class Time {};}
