/// articulated_parts.h - steps shared by the variants of the articulated-body algorithm.
///
/// Notation of articulated_body.h.
#pragma once

#include "murosimf/multibody/articulated_body.h"

namespace murosimf::multibody::parts {

/// Adds a rigid inertia: to += rigid. Member by member: whole temporaries would go through memory and stall.
template <class S>
MUROSIMF_INLINE void add_rigid(const RigidInertia<S>& rigid, Sym6<S>& to) {
  const Vec3<S>& h = rigid.first;
  to.J += rigid.second;
  to.H.x.y = to.H.x.y + h.z;
  to.H.x.z = to.H.x.z - h.y;
  to.H.y.x = to.H.y.x - h.z;
  to.H.y.z = to.H.y.z + h.x;
  to.H.z.x = to.H.z.x + h.y;
  to.H.z.y = to.H.z.y - h.x;
  to.M.xx = to.M.xx + rigid.mass;
  to.M.yy = to.M.yy + rigid.mass;
  to.M.zz = to.M.zz + rigid.mass;
}

/// Assigns a rigid inertia: to = rigid.
template <class S>
MUROSIMF_INLINE void set_rigid(const RigidInertia<S>& rigid, Sym6<S>& to) {
  const Vec3<S>& h = rigid.first;
  const S zero{}, mass{rigid.mass};
  to.J = rigid.second;
  to.H.x.x = to.H.y.y = to.H.z.z = zero;
  to.H.x.y = h.z;
  to.H.x.z = -h.y;
  to.H.y.x = -h.z;
  to.H.y.z = h.x;
  to.H.z.x = h.y;
  to.H.z.y = -h.x;
  to.M.xx = to.M.yy = to.M.zz = mass;
  to.M.xy = to.M.xz = to.M.yz = zero;
}

/// Calls take(to, number) for every number of A - s F F^T and its place in `to`, so that the result can be assigned or added
/// without a temporary.
template <class S, class Take>
MUROSIMF_INLINE void take_rest(const Sym6<S>& A, const S& s, const Wrench<S>& F, Sym6<S>& to, const Take& take) {
  const Vec3<S> n = s * F.n, f = s * F.f;
  take(to.J.xx, A.J.xx - n.x * F.n.x);
  take(to.J.yy, A.J.yy - n.y * F.n.y);
  take(to.J.zz, A.J.zz - n.z * F.n.z);
  take(to.J.xy, A.J.xy - n.x * F.n.y);
  take(to.J.xz, A.J.xz - n.x * F.n.z);
  take(to.J.yz, A.J.yz - n.y * F.n.z);
  const auto take_column = [&](Vec3<S>& column, const Vec3<S>& of, const S& along) MUROSIMF_INLINE_LAMBDA {
    take(column.x, of.x - along * F.n.x);
    take(column.y, of.y - along * F.n.y);
    take(column.z, of.z - along * F.n.z);
  };
  take_column(to.H.x, A.H.x, f.x);
  take_column(to.H.y, A.H.y, f.y);
  take_column(to.H.z, A.H.z, f.z);
  take(to.M.xx, A.M.xx - f.x * F.f.x);
  take(to.M.yy, A.M.yy - f.y * F.f.y);
  take(to.M.zz, A.M.zz - f.z * F.f.z);
  take(to.M.xy, A.M.xy - f.x * F.f.y);
  take(to.M.xz, A.M.xz - f.x * F.f.z);
  take(to.M.yz, A.M.yz - f.y * F.f.z);
}

/// Adds the link's own inertia and bias force to the contributions of its children and loads.
template <class S>
MUROSIMF_INLINE void add_link(const LinkMotion<S>& link, ArticulatedLink<S>& body) {
  if (body.loaded) {
    add_rigid(link.inertia, body.inertia);
    body.force += link.bias_force;
  } else {
    set_rigid(link.inertia, body.inertia);
    body.force = link.bias_force;
  }
}

/// Adds a link's articulated inertia and force to its parent; U, 1/D and u/D (`share`) are given.
template <class S>
MUROSIMF_INLINE void hand_over(const ArticulatedLink<S>& body, const S& share, ArticulatedLink<S>& parent) {
  if (parent.loaded) {
    take_rest(body.inertia, body.inverse_D, body.U, parent.inertia,
              [](S& to, const S& rest) MUROSIMF_INLINE_LAMBDA { to = to + rest; });
    parent.force += body.force + share * body.U;
  } else {
    take_rest(body.inertia, body.inverse_D, body.U, parent.inertia,
              [](S& to, const S& rest) MUROSIMF_INLINE_LAMBDA { to = rest; });
    parent.force.n = body.force.n + share * body.U.n;
    parent.force.f = body.force.f + share * body.U.f;
    parent.loaded = true;
  }
}

}  // namespace murosimf::multibody::parts
