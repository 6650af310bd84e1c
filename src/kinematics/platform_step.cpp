// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/platform_step.h"

#pragma GCC diagnostic ignored "-Wpsabi"

// One compiled version for each generation of processors, chosen when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define PARALLEL_ASPECTS_CLONES [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
#else
#define PARALLEL_ASPECTS_CLONES
#endif

namespace parallel_aspects::platform_paths {
namespace {

using lanes::all;
using lanes::Real;
using Number = lanes::Complex;

struct Vector {
  Number x, y, z;
};

PARALLEL_ASPECTS_INLINE Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
PARALLEL_ASPECTS_INLINE Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
PARALLEL_ASPECTS_INLINE Number dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
PARALLEL_ASPECTS_INLINE Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct Rotation {
  Vector row[3];
};

PARALLEL_ASPECTS_INLINE Vector operator*(const Rotation& r, const Vector& v) {
  return {dot(r.row[0], v), dot(r.row[1], v), dot(r.row[2], v)};
}

PARALLEL_ASPECTS_INLINE Rotation rotation(const Number (&e)[7]) {
  const Number x = e[0] + e[0], y = e[1] + e[1], z = e[2] + e[2];
  const Number xx = x * e[0], xy = x * e[1], xz = x * e[2], yy = y * e[1], yz = y * e[2], zz = z * e[2];
  const Number wx = x * e[3], wy = y * e[3], wz = z * e[3];
  const Number one{all(1.0), all(0.0)};
  return {{{one - yy - zz, xy - wz, xz + wy},
           {xy + wz, one - xx - zz, yz - wx},
           {xz - wy, yz + wx, one - xx - yy}}};
}

// A parameter and its derivative by t.
struct Varying {
  Number value, slope;
};

PARALLEL_ASPECTS_INLINE Number broadcast(const Complex& a) { return {all(a.real()), all(a.imag())}; }

PARALLEL_ASPECTS_INLINE Varying parameter(const ParameterPath& path, int leg, int k, const Real& t) {
  const Number start = broadcast(path.start[leg][k]), bend = broadcast(path.bend[leg][k]);
  const Number linear = broadcast(path.target[leg][k]) - start + bend;
  const Number quadratic = t * bend;
  return {start + t * (linear - quadratic), linear - quadratic - quadratic};
}

struct VaryingVector {
  Vector value, slope;
};

PARALLEL_ASPECTS_INLINE VaryingVector parameters(const ParameterPath& path, int leg, int first,
                                                 const Real& t) {
  const Varying x = parameter(path, leg, first, t), y = parameter(path, leg, first + 1, t),
                z = parameter(path, leg, first + 2, t);
  return {{x.value, y.value, z.value}, {x.slope, y.slope, z.slope}};
}

enum class Side { newton, tangent };

// Half the linear equations for the twist (w, v): rows (d x u, u) as in A, and -f (newton) or -df/dt
// (tangent).
template <Side side>
PARALLEL_ASPECTS_INLINE void linearise(const ParameterPath& path, const Number (&z)[7], const Real& t,
                                       Number (&equations)[6][7]) {
  const Rotation r = rotation(z);
  const Vector position{z[4], z[5], z[6]};
  for (int j = 0; j < 6; ++j) {
    const VaryingVector anchor = parameters(path, j, 0, t), base = parameters(path, j, 3, t);
    const Varying squared_length = parameter(path, j, 6, t);
    const Vector d = r * anchor.value, u = position + d - base.value, moment = cross(d, u);
    Number(&row)[7] = equations[j];
    row[0] = moment.x, row[1] = moment.y, row[2] = moment.z;
    row[3] = u.x, row[4] = u.y, row[5] = u.z;
    row[6] = side == Side::newton ? all(0.5) * (squared_length.value - dot(u, u))
                                  : all(0.5) * squared_length.slope - dot(u, r * anchor.slope - base.slope);
  }
}

// The change of (e, x) under the twist that solves the equations: (w e / 2, v).
template <Side side>
PARALLEL_ASPECTS_INLINE void change(const ParameterPath& path, const Number (&z)[7], const Real& t,
                                    Number (&result)[7]) {
  Number equations[6][7];
  linearise<side>(path, z, t, equations);
  lanes::solve(equations);
  const Real half = all(0.5);
  const Vector w{half * equations[0][6], half * equations[1][6], half * equations[2][6]};
  const Vector e{z[0], z[1], z[2]}, turned = cross(w, e);
  result[0] = w.x * z[3] + turned.x;
  result[1] = w.y * z[3] + turned.y;
  result[2] = w.z * z[3] + turned.z;
  result[3] = -dot(w, e);
  for (int i = 4; i < 7; ++i) result[i] = equations[i - 1][6];
}

PARALLEL_ASPECTS_INLINE void add(const Number (&a)[7], const Real& factor, const Number (&b)[7],
                                 Number (&result)[7]) {
  for (int i = 0; i < 7; ++i) result[i] = a[i] + factor * b[i];
}

// Back to e . e = 1, from close to it: (3 - e.e) / 2 is 1/sqrt(e.e) to first order, and twice is enough.
PARALLEL_ASPECTS_INLINE void normalise(Number (&z)[7]) {
  for (int repeat = 0; repeat < 2; ++repeat) {
    const Number square = z[0] * z[0] + z[1] * z[1] + z[2] * z[2] + z[3] * z[3];
    const Number factor{all(1.5) - all(0.5) * square.re, all(-0.5) * square.im};
    for (int i = 0; i < 4; ++i) z[i] = factor * z[i];
  }
}

PARALLEL_ASPECTS_INLINE Real squared_norm(const Number (&z)[7]) {
  Real sum = lanes::squared_norm(z[0]);
  for (int i = 1; i < 7; ++i) sum += lanes::squared_norm(z[i]);
  return sum;
}

PARALLEL_ASPECTS_INLINE void predict(const ParameterPath& path, const Lanes& from, Number (&z)[7]) {
  const Real h = from.step, half = 0.5 * h, middle = from.t + half;
  Number k1[7], k2[7], k3[7], k4[7];
  change<Side::tangent>(path, from.solution, from.t, k1);
  add(from.solution, half, k1, z);
  change<Side::tangent>(path, z, middle, k2);
  add(from.solution, half, k2, z);
  change<Side::tangent>(path, z, middle, k3);
  add(from.solution, h, k3, z);
  change<Side::tangent>(path, z, from.t + h, k4);
  for (int i = 0; i < 7; ++i)
    z[i] = from.solution[i] + (h / 6.0) * (k1[i] + all(2.0) * (k2[i] + k3[i]) + k4[i]);
  normalise(z);
}

// One step of Newton's method; the square of its length over that of the point.
PARALLEL_ASPECTS_INLINE Real correct(const ParameterPath& path, const Real& t, Number (&z)[7]) {
  Number step[7];
  change<Side::newton>(path, z, t, step);
  const Real moved = squared_norm(step) / squared_norm(z);
  add(z, all(1.0), step, z);
  normalise(z);
  return moved;
}

}  // namespace

PARALLEL_ASPECTS_CLONES
void attempt(const ParameterPath& path, const Lanes& from, Attempt& result) {
  const Real t = from.t + from.step;
  predict(path, from, result.solution);
  result.first_correction = correct(path, t, result.solution);
  result.second_correction = correct(path, t, result.solution);
}

}  // namespace parallel_aspects::platform_paths
