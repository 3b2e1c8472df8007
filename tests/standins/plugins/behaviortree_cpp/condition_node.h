#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>

namespace BT
{
enum class NodeStatus {IDLE, RUNNING, SUCCESS, FAILURE};
struct NodeConfiguration {};
struct PortInfo {};
using PortsList = std::unordered_map<std::string, PortInfo>;
using RuntimeError = std::runtime_error;

template<typename T = void>
std::pair<std::string, PortInfo> InputPort(const std::string & name, const char * = "") {return {name, {}};}

template<typename T = void>
std::pair<std::string, PortInfo> InputPort(const std::string & name, const T &, const char *) {return {name, {}};}

class ConditionNode
{
public:
  ConditionNode(const std::string &, const NodeConfiguration &) {}
  virtual ~ConditionNode() = default;
  virtual NodeStatus tick() = 0;
  template<typename T>
  std::optional<T> getInput(const std::string &) const {return T();}
};
}  // namespace BT
