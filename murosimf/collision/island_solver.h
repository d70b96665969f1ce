/// island_solver.h - all contacts of a few entities at once: projected Gauss-Seidel on velocities after the step.
///
/// Unknown are the impulses lambda = h f of the contact points. With v the velocity after the step, linear in the
/// impulses (impulse_response.h: v = v_free + y . z, z = sum y lambda), a compliant contact as in implicit_stick.h demands
///
///     normal:   v_n + R_n lambda_n = k delta / b_n,  lambda_n >= 0         R = 1 / (h b),  b_n = d + theta h k
///     tangent:  v_t + R_t lambda_t = -kt s / b_t,  |lambda_t| <= mu lambda_n              b_t = ct + h kt
///
/// which is the same force law, f_n = k (delta - theta h v_n) - d v_n and so on. A sweep solves one contact after the
/// other, a number for the normal and two for the tangent, with the direction of sweeping alternating; impulses start
/// from those of the step before. A point that sticks is solved exactly; one that slides takes a step against its
/// residual, as far as the cone lets it, so that friction ends up straight against the motion.
/// Source: projected Gauss-Seidel with regularization as in Catto, "Iterative dynamics with temporal coherence", GDC
/// 2005, and Todorov, "Convex and analytically-invertible dynamics with contacts and constraints", ICRA 2014; on articulated
/// bodies without the mass matrix, measured with the project's prototype.
#pragma once

#include <array>
#include <vector>

#include "murosimf/collision/contact.h"
#include "murosimf/collision/impulse_response.h"

namespace murosimf::collision {

class IslandSolver {
 public:
  /// One end of a contact: a body of an entity that answers, or something that does not give way (`member` -1).
  struct Side {
    int member = -1;
    int object = 0;
    Vec3d velocity;  ///< [m/s] of the point now, world frame
  };

  /// Forgets all members and contacts; dt [s].
  void start(double dt);
  /// An entity whose free pass is done; what is returned is its number.
  int add(ImpulseResponse& response);
  /// A feels +force. The point is kept by reference, and gets its new memory and force from `finish`.
  void add(ContactPoint& point, const ContactParameters& parameters, const Side& a, const Side& b);

  void sweep(int sweeps) noexcept;
  /// Memory and forces of all points, and the impulses to the entities.
  void finish() noexcept;

 private:
  struct Member {
    ImpulseResponse* response;
    std::size_t offset;  // of its numbers in z_
    std::size_t size;
  };
  struct Row {
    std::array<ResponseRow, 2> y;  // sides A and B; B's with the opposite sign
    double free = 0;               // [m/s] velocity along the row's direction without contacts
  };
  struct Contact {
    ContactPoint* point;
    const ContactParameters* parameters;
    std::array<int, 2> member;
    std::array<Vec3d, 3> frame;  // n, t1, t2
    std::array<Row, 3> row;
    std::array<double, 3> lambda;   // [N s]
    double W_n, W_11, W_12, W_22;   // [1/kg] of the normal, and of the tangents
    double R_n, R_t;                // [1/kg] compliance
    double wish_n, wish_1, wish_2;  // [m/s] right-hand sides
  };

  void add_side(Contact& contact, int which, const Side& side);
  [[nodiscard]] double velocity(const Contact& contact, int row) const noexcept;
  void change(Contact& contact, int row, double lambda) noexcept;
  void solve(Contact& contact) noexcept;
  void solve_friction(Contact& contact) noexcept;
  void finish(Contact& contact) noexcept;

  double dt_ = 0;
  std::vector<Member> members_;
  std::vector<double> z_;
  std::vector<Contact> contacts_;
  std::size_t count_ = 0;  // of contacts in use: their memory is kept
};

}  // namespace murosimf::collision
