#pragma once

#include <string>

namespace hardware_interface
{
class StateInterface
{
public:
  StateInterface(const std::string &, const std::string &, double * = nullptr) {}
};

class CommandInterface
{
public:
  CommandInterface(const std::string &, const std::string &, double * = nullptr) {}
  CommandInterface(const CommandInterface &) = delete;
  CommandInterface(CommandInterface &&) = default;
};

struct InterfaceDescription {std::string prefix_name;};
}  // namespace hardware_interface
