/// fwd.h - names of the data model without their definitions.
#pragma once

#include <memory>

namespace murosimf {

class Algorithm;
class Chain;
class Entity;
class Model;
class Setup;
class World;
using ModelPtr = std::shared_ptr<const Model>;

}  // namespace murosimf
