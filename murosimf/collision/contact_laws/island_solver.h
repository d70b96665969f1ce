/// island_solver.h - solves all contacts of a few entities at once: projected Gauss-Seidel on velocities after the step.
///
/// Unknown are the impulses lambda = h f of the contact points. With v the velocity after the step, linear in the
/// impulses (impulse_response.h: v = v_free + y . z, z = sum y lambda), a compliant contact as in implicit_stick_law.h demands
///
///     normal:   v_n + R_n lambda_n = k delta / b_n,  lambda_n >= 0         R = 1 / (h b),  b_n = d + theta h k
///     tangent:  v_t + R_t lambda_t = -kt s / b_t,  |lambda_t| <= mu lambda_n              b_t = ct + h kt
///
/// which is the same force law, f_n = k (delta - theta h v_n) - d v_n and so on. A sweep solves one contact after the
/// other, a number for the normal and two for the tangent, with the direction of sweeping alternating; impulses start
/// from those of the step before. A point that sticks is solved exactly; one that slides takes a step against its
/// residual, as far as the cone lets it, so that friction ends up straight against the motion. Sweeps end early when a whole one changes no
/// velocity by more than `settled`, after `usual_sweeps` by more than `nearly_settled`.
/// Source: projected Gauss-Seidel with regularization as in Catto, "Iterative dynamics with temporal coherence", GDC
/// 2005, and Todorov, "Convex and analytically-invertible dynamics with contacts and constraints", ICRA 2014; on articulated
/// bodies without the mass matrix, measured with the project's prototype.
#pragma once

#include <array>
#include <vector>

#include "murosimf/collision/contact.h"
#include "murosimf/collision/contact_laws/impulse_response.h"
#include "murosimf/math/four.h"

namespace murosimf::collision {

class IslandSolver {
 public:
  /// One end of a contact: a body of an entity that answers impulses, or an immovable one (`member` -1).
  struct Side {
    int member = -1;
    int object = 0;
    Vec3d velocity;  ///< [m/s] of the point now, world frame
  };

  /// Removes all members and contacts; dt [s] > 0.
  void start(double dt);
  /// Adds an entity whose free pass is done; returns its number.
  int add(ImpulseResponse& response);
  /// Adds a contact; +force acts on A. The point is kept by reference, and receives its new memory and force by `finish`.
  void add(ContactPoint& point, const ContactParameters& parameters, const Side& a, const Side& b);

  /// Executes at most `sweeps`; returns their number.
  int sweep(int sweeps) noexcept;
  /// The rest after the last sweep(), if velocities continue to change as in the second half of its sweeps.
  struct Rest {
    double sweeps = 0;  ///< [1] to be settled, over those that it had
    double change = 0;  ///< [m/s] of the contact that changed the most
  };
  /// Zero if it has settled.
  [[nodiscard]] const Rest& rest() const noexcept { return rest_; }
  /// Sets memory and forces of all points, and applies the impulses to the entities.
  void finish() noexcept;
  /// The parts of finish(): all points, and the entity with this number.
  void finish_points() noexcept;
  void apply(int member) const noexcept;

  static constexpr double settled = 1e-7;         ///< [m/s]
  static constexpr int usual_sweeps = 10;         ///< which most islands settle within
  static constexpr double nearly_settled = 1e-5;  ///< [m/s] enough after these

 private:
  struct Member {
    ImpulseResponse* response;
    std::size_t offset;  // of its numbers in z_
    std::size_t size;
  };
  struct Contact {
    ContactPoint* point;
    const ContactParameters* parameters;
    std::size_t first, last;                 // of both sides in index_ and rows_; B's with the opposite sign
    Mat3d frame;                             // n, t1, t2
    Vec3d free;                              // [m/s] velocity along the frame's axes without contacts
    Vec3d lambda;                            // [N s] along the frame's axes
    SymMat3d W;                              // [1/kg] velocity per lambda
    double R_n, R_t;                         // [1/kg] compliance
    double mass_n;                           // [kg] 1 / (W_n + R_n)
    double mass_1, mass_12, mass_2;          // [kg] inverse of the tangents' W + R_t
    double slide_mass;                       // [kg] 1 / largest eigenvalue of that W + R_t
    double request_n, request_1, request_2;  // [m/s] right-hand sides
  };

  /// The same three numbers of four rows.
  struct Columns {
    Four x, y, z;
  };

  void add_side(Contact& contact, double sign, const Side& side);
  void keep_response(Contact& contact);
  static void invert(Contact& contact) noexcept;
  [[nodiscard]] Vec3d velocity(const Contact& contact) const noexcept;
  void push(Contact& contact, const Vec3d& impulse) noexcept;
  [[nodiscard]] double solve(Contact& contact) noexcept;
  [[nodiscard]] Vec3d solve_friction(const Contact& contact, double normal, const Vec3d& velocity) const noexcept;
  [[nodiscard]] static double within_cone(const Contact& contact, double normal, const Vec3d& friction) noexcept;
  void finish(Contact& contact) noexcept;

  double dt_ = 0;
  Rest rest_;
  std::vector<Member> members_;
  std::vector<double> z_;  // number 0 belongs to no entity
  std::vector<Contact> contacts_;
  ResponseRows response_;           // of one contact; working memory
  std::vector<std::size_t> index_;  // of all contacts: numbers of z_; each contact's padded to fours with number 0
  std::vector<Four> rows_;          // with these, along the contact's frame
  std::vector<Columns> columns_;    // the same, four at a time
};

}  // namespace murosimf::collision
