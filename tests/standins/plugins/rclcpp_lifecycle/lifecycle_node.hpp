#pragma once

#include <memory>
#include <string>
#include <vector>

#include "rclcpp_lifecycle/state.hpp"

namespace rclcpp
{
class Parameter
{
public:
  template<typename T>
  T get_value() const {return T();}
  double as_double() const {return 0.0;}
  std::vector<std::string> as_string_array() const {return {};}
};
}  // namespace rclcpp

namespace rclcpp_lifecycle
{
namespace node_interfaces
{
class LifecycleNodeInterface
{
public:
  enum class CallbackReturn {SUCCESS, FAILURE, ERROR};
  virtual ~LifecycleNodeInterface() = default;
  virtual CallbackReturn on_configure(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_activate(const State &) {return CallbackReturn::SUCCESS;}
};
}  // namespace node_interfaces

class LifecycleNode
{
public:
  using WeakPtr = std::weak_ptr<LifecycleNode>;
  bool has_parameter(const std::string &) const {return false;}
  template<typename T>
  T declare_parameter(const std::string &, const T & value) {return value;}
  rclcpp::Parameter get_parameter(const std::string &) const {return {};}
};
}  // namespace rclcpp_lifecycle
