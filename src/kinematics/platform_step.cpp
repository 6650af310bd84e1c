// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/platform_step.h"

#pragma GCC diagnostic ignored "-Wpsabi"

// One compiled version for each generation of processors, chosen when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
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

struct Quaternion {
  Vector v;
  Number w;
};

PARALLEL_ASPECTS_INLINE Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
PARALLEL_ASPECTS_INLINE Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
PARALLEL_ASPECTS_INLINE Vector operator*(const Number& a, const Vector& b) {
  return {a * b.x, a * b.y, a * b.z};
}
PARALLEL_ASPECTS_INLINE Number dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
PARALLEL_ASPECTS_INLINE Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

PARALLEL_ASPECTS_INLINE Quaternion operator+(const Quaternion& a, const Quaternion& b) {
  return {a.v + b.v, a.w + b.w};
}
PARALLEL_ASPECTS_INLINE Quaternion operator-(const Quaternion& a, const Quaternion& b) {
  return {a.v - b.v, a.w - b.w};
}
PARALLEL_ASPECTS_INLINE Quaternion operator*(const Number& a, const Quaternion& b) {
  return {a * b.v, a * b.w};
}
PARALLEL_ASPECTS_INLINE Number dot(const Quaternion& a, const Quaternion& b) {
  return dot(a.v, b.v) + a.w * b.w;
}

// q p - r q for vectors p and r, as products of quaternions.
PARALLEL_ASPECTS_INLINE Quaternion commutator(const Quaternion& q, const Vector& p, const Vector& r) {
  return {q.w * (p - r) + cross(q.v, p + r), dot(q.v, r - p)};
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

PARALLEL_ASPECTS_INLINE void set(const Quaternion& left, const Quaternion& right, const Number& value,
                                 Number (&row)[9]) {
  row[0] = left.v.x, row[1] = left.v.y, row[2] = left.v.z, row[3] = left.w;
  row[4] = right.v.x, row[5] = right.v.y, row[6] = right.v.z, row[7] = right.w;
  row[8] = value;
}

// Half the derivative of m . m - r e . e by (e, g), and minus half its value (newton) or derivative by t
// (tangent), for m = g + e b - c e.
template <Side side>
PARALLEL_ASPECTS_INLINE void linearise_leg(const ParameterPath& path, int j, const Real& t,
                                           const Quaternion& e, const Quaternion& g, Number (&row)[9]) {
  const VaryingVector b = parameters(path, j, 0, t), c = parameters(path, j, 3, t);
  const Varying r = parameter(path, j, 6, t);
  const Quaternion m = g + commutator(e, b.value, c.value);
  const Quaternion by_e = commutator(m, b.value, c.value) + r.value * e;
  const Number value = side == Side::newton
                           ? all(0.5) * (dot(m, m) - r.value * dot(e, e))
                           : dot(m, commutator(e, b.slope, c.slope)) - all(0.5) * (r.slope * dot(e, e));
  set(Quaternion{} - by_e, m, -value, row);
}

// The change of z = (e, g), orthogonal to z as a complex vector, that makes up for the values of all
// equations, or that follows the path.
template <Side side>
PARALLEL_ASPECTS_INLINE void change(const ParameterPath& path, const Number (&z)[8], const Real& t,
                                    Number (&result)[8]) {
  const Quaternion e{{z[0], z[1], z[2]}, z[3]}, g{{z[4], z[5], z[6]}, z[7]};
  Number equations[8][9];
  for (int j = 0; j < 6; ++j) linearise_leg<side>(path, j, t, e, g, equations[j]);
  set(g, e, side == Side::newton ? -dot(e, g) : Number{}, equations[6]);
  for (int i = 0; i < 8; ++i) equations[7][i] = {z[i].re, -z[i].im};
  equations[7][8] = Number{};
  lanes::solve(equations);
  for (int i = 0; i < 8; ++i) result[i] = equations[i][8];
}

PARALLEL_ASPECTS_INLINE void add(const Number (&a)[8], const Real& factor, const Number (&b)[8],
                                 Number (&result)[8]) {
  for (int i = 0; i < 8; ++i) result[i] = a[i] + factor * b[i];
}

PARALLEL_ASPECTS_INLINE Real squared_norm(const Number (&z)[8]) {
  Real sum = lanes::squared_norm(z[0]);
  for (int i = 1; i < 8; ++i) sum += lanes::squared_norm(z[i]);
  return sum;
}

// Back to norm 1, from close to it.
PARALLEL_ASPECTS_INLINE void normalise(Number (&z)[8]) {
  const Real factor = 1.5 - 0.5 * squared_norm(z);
  for (int i = 0; i < 8; ++i) z[i] = factor * z[i];
}

PARALLEL_ASPECTS_INLINE void predict(const ParameterPath& path, const Lanes& from, Number (&z)[8]) {
  const Real h = from.step, half = 0.5 * h, middle = from.t + half;
  Number k1[8], k2[8], k3[8], k4[8];
  change<Side::tangent>(path, from.solution, from.t, k1);
  add(from.solution, half, k1, z);
  change<Side::tangent>(path, z, middle, k2);
  add(from.solution, half, k2, z);
  change<Side::tangent>(path, z, middle, k3);
  add(from.solution, h, k3, z);
  change<Side::tangent>(path, z, from.t + h, k4);
  for (int i = 0; i < 8; ++i)
    z[i] = from.solution[i] + (h / 6.0) * (k1[i] + all(2.0) * (k2[i] + k3[i]) + k4[i]);
  normalise(z);
}

// One step of Newton's method; the square of its length.
PARALLEL_ASPECTS_INLINE Real correct(const ParameterPath& path, const Real& t, Number (&z)[8]) {
  Number step[8];
  change<Side::newton>(path, z, t, step);
  add(z, all(1.0), step, z);
  normalise(z);
  return squared_norm(step);
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
