#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "hardware_interface/handle.hpp"
#include "hardware_interface/hardware_info.hpp"
#include "hardware_interface/types/hardware_interface_return_values.hpp"
#include "rclcpp/duration.hpp"
#include "rclcpp/time.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace hardware_interface
{
class SystemInterface : public rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface
{
public:
  virtual return_type read(const rclcpp::Time &, const rclcpp::Duration &) = 0;
  virtual return_type write(const rclcpp::Time &, const rclcpp::Duration &) = 0;
#ifdef HUMBLE
  virtual CallbackReturn on_init(const HardwareInfo & info)
  {
    info_ = info;
    return CallbackReturn::SUCCESS;
  }
  virtual std::vector<StateInterface> export_state_interfaces() = 0;
  virtual std::vector<CommandInterface> export_command_interfaces() = 0;
#else
  bool has_state(const std::string &) const {return true;}
  template<typename T>
  void set_state(const std::string &, const T &) {}
  template<typename T = double>
  T get_state(const std::string &) const {return T();}
  template<typename T>
  void set_command(const std::string &, const T &) {}
  template<typename T = double>
  T get_command(const std::string &) const {return T();}
#endif

protected:
  HardwareInfo info_;
#ifndef HUMBLE
  std::unordered_map<std::string, InterfaceDescription> joint_state_interfaces_;
  std::unordered_map<std::string, InterfaceDescription> joint_command_interfaces_;
#endif
};
}  // namespace hardware_interface
