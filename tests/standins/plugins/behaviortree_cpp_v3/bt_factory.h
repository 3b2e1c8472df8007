#pragma once
#include "behaviortree_cpp/bt_factory.h"
