// Data derived from a model are computed once for all users; a changed copy of the model starts anew.
#include "murosimf/model/derived_data.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>
#include <vector>

#include "murosimf/model/model.h"
#include "murosimf/model/properties.h"

namespace murosimf {
namespace {

struct Counted {
  int value = 0;
};

TEST(DerivedData, IsMadeOnceForEachKeyAndType) {
  const DerivedData data;
  int made = 0;
  const auto make = [&] { return Counted{++made}; };
  const auto first = data.get<Counted>("a", make);
  EXPECT_EQ(data.get<Counted>("a", make), first);
  EXPECT_EQ(made, 1);
  EXPECT_EQ(data.get<Counted>("b", make)->value, 2);
  EXPECT_EQ(*data.get<int>("a", [] { return 7; }), 7) << "of another type";
  EXPECT_EQ(first->value, 1);
}

TEST(DerivedData, WhatCannotBeMadeIsNotKept) {
  const DerivedData data;
  const auto fail = []() -> int { throw std::runtime_error("no"); };
  EXPECT_THROW((void)data.get<int>("a", fail), std::runtime_error);
  EXPECT_EQ(*data.get<int>("a", [] { return 3; }), 3);
}

TEST(DerivedData, MayBeMadeFromOtherDerivedData) {
  const DerivedData data;
  const auto twice = [&] { return 2 * *data.get<int>("once", [] { return 21; }); };
  EXPECT_EQ(*data.get<int>("twice", twice), 42);
}

TEST(DerivedData, AChangedModelBeginsAnew) {
  const Model light("stone", Chain{}.base("stone").with(properties::mass, 1.0));
  const auto mass_of = [](const Model& model) {
    return *model.derived().get<double>("mass", [&] { return model.tree().mass; });
  };
  EXPECT_EQ(mass_of(light), 1);
  ConstantTable constants = light.constants();
  constants.set(properties::mass, 0, 2.5);
  EXPECT_EQ(mass_of(light.with(constants)), 2.5);
  EXPECT_EQ(mass_of(light), 1);
}

TEST(DerivedData, ThreadsGetOneAndTheSame) {
  const DerivedData data;
  std::vector<std::shared_ptr<const Counted>> found(8);
  std::vector<std::thread> threads;
  for (auto& mine : found) threads.emplace_back([&] { mine = data.get<Counted>("a", [] { return Counted{1}; }); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& mine : found) EXPECT_EQ(mine, found[0]);
}

}  // namespace
}  // namespace murosimf
