/// articulated_parts.h - pieces of the sweeps of the articulated-body algorithm, for its variants' .cpp files.
///
/// Notation of articulated_body.h.
#pragma once

#include "murosimf/multibody/articulated_body.h"

namespace murosimf::multibody::parts {

/// to = (or +=) rigid. By members: whole temporaries would go through memory, and wait for it.
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

/// A -= s F F^T.
template <class S>
MUROSIMF_INLINE void subtract_outer(Sym6<S>& A, const S& s, const Wrench<S>& F) {
  const Vec3<S> n = s * F.n, f = s * F.f;
  A.J.xx = A.J.xx - n.x * F.n.x;
  A.J.yy = A.J.yy - n.y * F.n.y;
  A.J.zz = A.J.zz - n.z * F.n.z;
  A.J.xy = A.J.xy - n.x * F.n.y;
  A.J.xz = A.J.xz - n.x * F.n.z;
  A.J.yz = A.J.yz - n.y * F.n.z;
  A.H.x -= f.x * F.n;
  A.H.y -= f.y * F.n;
  A.H.z -= f.z * F.n;
  A.M.xx = A.M.xx - f.x * F.f.x;
  A.M.yy = A.M.yy - f.y * F.f.y;
  A.M.zz = A.M.zz - f.z * F.f.z;
  A.M.xy = A.M.xy - f.x * F.f.y;
  A.M.xz = A.M.xz - f.x * F.f.z;
  A.M.yz = A.M.yz - f.y * F.f.z;
}

/// The link itself joins what its children and loads have left.
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

/// What a link leaves to its parent once U, 1/D and u/D (`share`) are known; `body.inertia` is used up.
template <class S>
MUROSIMF_INLINE void hand_over(ArticulatedLink<S>& body, const S& share, ArticulatedLink<S>& parent) {
  subtract_outer(body.inertia, body.inverse_D, body.U);
  if (parent.loaded) {
    parent.inertia += body.inertia;
    parent.force += body.force + share * body.U;
  } else {
    parent.inertia = body.inertia;
    parent.force.n = body.force.n + share * body.U.n;
    parent.force.f = body.force.f + share * body.U.f;
    parent.loaded = true;
  }
}

}  // namespace murosimf::multibody::parts
