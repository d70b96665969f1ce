// CMA-ES against functions whose minimum is known, against itself turned and interrupted, and against the sides of its box.
#include "murosimf/studies/cma_es.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "murosimf/model/error.h"

namespace murosimf::studies {
namespace {

using Point = std::vector<double>;
using Function = std::function<double(const Point&)>;

double sphere(const Point& x) {
  double sum = 0;
  for (const double one : x) sum += one * one;
  return sum;
}

double ellipsoid(const Point& x) {  // condition number 1e6
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum += std::pow(1e6, static_cast<double>(i) / static_cast<double>(x.size() - 1)) * x[i] * x[i];
  }
  return sum;
}

double rosenbrock(const Point& x) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    sum += 100 * std::pow(x[i + 1] - x[i] * x[i], 2) + std::pow(1 - x[i], 2);
  }
  return sum;
}

std::vector<double> costs_of(const Function& f, const std::vector<Point>& points) {
  std::vector<double> costs;
  for (const Point& x : points) costs.push_back(f(x));
  return costs;
}

/// Evaluations until the cost is below 1e-9; `most` if it never is.
std::size_t evaluations(const Function& f, CmaEsOptions options, std::size_t most) {
  CmaEs search(options);
  std::size_t count = 0;
  while (count < most) {
    const std::vector<double> costs = costs_of(f, search.ask());
    count += costs.size();
    if (*std::min_element(costs.begin(), costs.end()) < 1e-9) return count;
    search.tell(costs);
  }
  return most;
}

/// Of the middle one of nine seeds.
std::size_t median_evaluations(const Function& f, CmaEsOptions options, std::size_t most) {
  std::vector<std::size_t> all;
  for (options.seed = 1; options.seed <= 9; ++options.seed) all.push_back(evaluations(f, options, most));
  std::ranges::sort(all);
  return all[4];
}

// How many evaluations: Hansen's own program (pycma 4.5, its defaults, same starts, n = 10) needs 1560 to 1690, 4050 to 4610 and 4590 to 6150
// for the three functions, medians 1640, 4220 and 4940 of nine seeds. It differs in details (when it takes C apart, the damping of its step size),
// so a sixth more is allowed. Without adaptation of C the ellipsoid takes some million.

TEST(CmaEs, FindsTheMiddleOfASphere) {
  const std::size_t count = median_evaluations(sphere, {.start = Point(10, 3.0), .sigma = 1}, 20000);
  EXPECT_LT(count, 1910u);
  EXPECT_GT(count, 800u);  // fewer would mean that it knows where the middle is
}

TEST(CmaEs, LearnsTheAxesOfAnEllipsoid) {
  EXPECT_LT(median_evaluations(ellipsoid, {.start = Point(10, 3.0), .sigma = 1}, 50000), 4920u);
}

TEST(CmaEs, FollowsTheValleyOfRosenbrock) {
  EXPECT_LT(median_evaluations(rosenbrock, {.start = Point(10, 0.0), .sigma = 0.5}, 50000), 5760u);
}

/// An orthogonal matrix of size 10: of the QR decomposition of numbers without a pattern.
Eigen::MatrixXd turning() {
  Eigen::MatrixXd numbers(10, 10);
  for (int i = 0; i < 10; ++i) {
    for (int k = 0; k < 10; ++k) numbers(i, k) = std::sin(1.0 + 7.0 * i + 3.7 * k * k);
  }
  return Eigen::HouseholderQR<Eigen::MatrixXd>(numbers).householderQ();
}

TEST(CmaEs, TurnedAxesCostNothing) {
  const Eigen::MatrixXd Q = turning();
  const Function turned = [&](const Point& x) {
    const Eigen::VectorXd y = Q * Eigen::Map<const Eigen::VectorXd>(x.data(), 10);
    return ellipsoid({y.begin(), y.end()});
  };
  const Eigen::VectorXd start = Q.transpose() * Eigen::VectorXd::Constant(10, 3.0);
  const std::size_t straight = median_evaluations(ellipsoid, {.start = Point(10, 3.0), .sigma = 1}, 50000);
  const std::size_t oblique = median_evaluations(turned, {.start = {start.begin(), start.end()}, .sigma = 1}, 50000);
  // other random numbers, the same distribution: medians of nine differ by some percent
  EXPECT_NEAR(static_cast<double>(oblique), static_cast<double>(straight), 0.15 * static_cast<double>(straight));
}

TEST(CmaEs, OnlyRanksCount) {
  CmaEs plain({.start = Point(4, 1.0)});
  CmaEs bent({.start = Point(4, 1.0)});
  for (int i = 0; i < 30; ++i) {
    plain.tell(costs_of(rosenbrock, plain.ask()));
    bent.tell(costs_of([](const Point& x) { return std::log(rosenbrock(x)); }, bent.ask()));
  }
  EXPECT_EQ(plain.state(), bent.state());
}

TEST(CmaEs, FindsAMinimumOnTheSidesOfItsBox) {
  const Point low{-1, 0.5, -2, 0, -1}, high{3, 2, -0.25, 1, 1};
  // of each number the nearest to 0, which for the second and third is a side; of the others the slope leads to a corner
  const Function f = [&](const Point& x) { return sphere(x) + 3 * x[3] - 4 * x[4]; };
  CmaEs search({.start = {1, 1, -1, 0.5, 0}, .sigma = 0.3, .low = low, .high = high});
  for (int i = 0; i < 600; ++i) {
    const std::vector<Point> points = search.ask();
    for (const Point& x : points) {
      for (std::size_t k = 0; k < x.size(); ++k) {
        ASSERT_GE(x[k], low[k]);
        ASSERT_LE(x[k], high[k]);
      }
    }
    search.tell(costs_of(f, points));
  }
  const Point best = search.mean(), right{0, 0.5, -0.25, 0, 1};
  for (std::size_t k = 0; k < best.size(); ++k) EXPECT_NEAR(best[k], right[k], 1e-6) << k;
}

TEST(CmaEs, GoesOnWhereItWas) {
  const CmaEsOptions options{
      .start = Point(10, 0.0), .sigma = 0.5, .low = Point(10, -2), .high = Point(10, 2), .seed = 7};
  CmaEs through(options), first(options);
  for (int i = 0; i < 20; ++i) {
    through.tell(costs_of(rosenbrock, through.ask()));
    first.tell(costs_of(rosenbrock, first.ask()));
  }
  CmaEs second(options, first.state());
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(second.ask(), through.ask());
    through.tell(costs_of(rosenbrock, through.ask()));
    second.tell(costs_of(rosenbrock, second.ask()));
  }
  EXPECT_EQ(second.state(), through.state());
}

TEST(CmaEs, SeedsAreDifferentSearches) {
  EXPECT_EQ(CmaEs({.start = {1, 2}}).ask(), CmaEs({.start = {1, 2}}).ask());
  EXPECT_NE(CmaEs({.start = {1, 2}}).ask(), CmaEs({.start = {1, 2}, .seed = 2}).ask());
}

TEST(CmaEs, WorstIsWhatIsNoNumber) {
  CmaEs a({.start = {1, 2}, .population = 6}), b({.start = {1, 2}, .population = 6});
  a.tell({3, std::nan(""), 1, 2, 0, 4});
  b.tell({3, 99, 1, 2, 0, 4});
  EXPECT_EQ(a.state(), b.state());
}

TEST(CmaEs, RefusesWhatCannotBe) {
  EXPECT_THROW(CmaEs({.start = {}}), SetupError);
  EXPECT_THROW(CmaEs({.start = {std::nan("")}}), SetupError);
  EXPECT_THROW(CmaEs({.start = {1}, .sigma = 0}), SetupError);
  EXPECT_THROW(CmaEs({.start = {1}, .low = {0, 0}, .high = {1, 1}}), SetupError);
  EXPECT_THROW(CmaEs({.start = {1}, .low = {1}, .high = {1}}), SetupError);
  EXPECT_THROW(CmaEs({.start = {1}, .population = 1}), SetupError);
  EXPECT_THROW(CmaEs({.start = {1, 2}}, CmaEs({.start = {1}}).state()), SetupError);
  CmaEs search({.start = {1, 2}});
  EXPECT_THROW(search.tell({1}), SetupError);
}

}  // namespace
}  // namespace murosimf::studies
