// SPDX-License-Identifier: BSD-3-Clause
//
// Finds a start system for the direct problem in SE3 and prints it as
// src/kinematics/homotopy/platform_start.inc.
//
//     generate_platform_start [CANDIDATES] > src/kinematics/homotopy/platform_start.inc
//
// One solution of random complex parameters is had by choosing it first. Carrying the known solutions around
// random loops in the space of parameters permutes the 40 (monodromy), and so finds all of them. Of
// CANDIDATES such systems the one is kept whose paths to random real platforms lose the fewest and take the
// fewest steps.
#include "kinematics/homotopy/platform_paths.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>

namespace parallel_aspects::platform_paths {
namespace {

struct System {
  Parameters parameters{};
  std::vector<Solution> solutions;
};

// Normally distributed numbers with a given share of the imaginary part.
class RandomSystems {
 public:
  RandomSystems(unsigned seed, double imaginary) : engine_(seed), imaginary_(imaginary) {}

  Complex number() {
    const double re = normal_(engine_), im = normal_(engine_);
    return Complex(re, imaginary_ * im) / std::hypot(1.0, imaginary_);
  }

  // A random e, and the one g = x e of a random x.
  Solution solution() {
    Solution z;
    for (std::size_t i = 0; i < 4; ++i) z[i] = number();
    const Complex x = number(), y = number(), w = number();
    z[4] = x * z[3] + y * z[2] - w * z[1];
    z[5] = y * z[3] + w * z[0] - x * z[2];
    z[6] = w * z[3] + x * z[1] - y * z[0];
    z[7] = -x * z[0] - y * z[1] - w * z[2];
    double sum = 0.0;
    for (const Complex& each : z) sum += std::norm(each);
    for (Complex& each : z) each /= std::sqrt(sum);
    return z;
  }

  Parameters parameters() {
    Parameters result;
    for (auto& leg : result)
      for (Complex& each : leg) each = number();
    for (auto& leg : result) leg[6] *= 3.0;
    return result;
  }

 private:
  std::mt19937 engine_;
  std::normal_distribution<double> normal_;
  double imaginary_;
};

// Squared lengths such that `z` is a solution: m . m / e . e.
void fit_lengths(const Solution& z, Parameters& parameters) {
  const Complex x = z[0], y = z[1], v = z[2], w = z[3];
  for (auto& leg : parameters) {
    const std::array<Complex, 3> less{leg[0] - leg[3], leg[1] - leg[4], leg[2] - leg[5]};
    const std::array<Complex, 3> sum{leg[0] + leg[3], leg[1] + leg[4], leg[2] + leg[5]};
    const std::array<Complex, 4> m{
        z[4] + w * less[0] + y * sum[2] - v * sum[1], z[5] + w * less[1] + v * sum[0] - x * sum[2],
        z[6] + w * less[2] + x * sum[1] - y * sum[0], z[7] - x * less[0] - y * less[1] - v * less[2]};
    leg[6] = (m[0] * m[0] + m[1] * m[1] + m[2] * m[2] + m[3] * m[3]) / (x * x + y * y + v * v + w * w);
  }
}

std::vector<Solution> arrived(const std::vector<PathEnd>& ends) {
  std::vector<Solution> result;
  for (const PathEnd& end : ends)
    if (end.ending == Ending::regular) result.push_back(end.solution);
  return result;
}

void add_new(const std::vector<Solution>& found, std::vector<Solution>& known) {
  for (const Solution& z : found)
    if (std::none_of(known.begin(), known.end(), [&](const Solution& k) { return distance(k, z) < 1e-6; }))
      known.push_back(z);
}

std::optional<System> found_by_monodromy(unsigned seed) {
  RandomSystems random(seed, 0.3);
  const Solution first = random.solution();
  System system{random.parameters(), {first}};
  fit_lengths(first, system.parameters);
  constexpr int max_loops = 100, loops_to_confirm = 20;
  for (int loop = 0, idle = 0; loop < max_loops && idle < loops_to_confirm; ++loop) {
    const Parameters away = random.parameters();
    const auto there = arrived(followed({system.parameters, away, {}}, system.solutions, {}));
    const auto back = arrived(followed({away, system.parameters, random.parameters()}, there, {}));
    const std::size_t known = system.solutions.size();
    add_new(back, system.solutions);
    idle = system.solutions.size() == known ? idle + 1 : 0;
  }
  return system.solutions.size() == solution_count ? std::optional<System>(system) : std::nullopt;
}

// Mean steps a path to random real platforms; a lost path counts as many.
double cost(const System& system) {
  constexpr int platforms = 200, cost_of_loss = 20000;
  RandomSystems random(1, 0.0);
  double sum = 0.0;
  for (int i = 0; i < platforms; ++i) {
    Parameters target = random.parameters();
    fit_lengths(random.solution(), target);
    for (const PathEnd& end : followed({system.parameters, target, {}}, system.solutions, {}))
      sum += end.ending == Ending::lost ? cost_of_loss : end.steps;
  }
  return sum / (platforms * solution_count);
}

template <std::size_t n>
void print(const std::array<Complex, n>& numbers) {
  std::printf("    {");
  for (std::size_t i = 0; i < n; ++i)
    std::printf("%sComplex{%.17g, %.17g}%s", i == 0 ? "{" : "      ", numbers[i].real(), numbers[i].imag(),
                i + 1 < n ? ",\n" : "}},\n");
}

void print(const System& system, unsigned candidates) {
  std::printf("// SPDX-License-Identifier: BSD-3-Clause\n// Written by generate_platform_start %u.\n\n",
              candidates);
  std::printf("constexpr Parameters table_parameters{{\n");
  for (const auto& leg : system.parameters) print(leg);
  std::printf("}};\n\nconstexpr std::array<Solution, solution_count> table_solutions{{\n");
  for (const auto& solution : system.solutions) print(solution);
  std::printf("}};\n");
}

int generate(unsigned candidates) {
  std::optional<System> best;
  double lowest = 0.0;
  for (unsigned seed = 1; seed <= candidates; ++seed) {
    const std::optional<System> system = found_by_monodromy(seed);
    const double steps = system ? cost(*system) : 0.0;
    std::fprintf(stderr, "seed %u: %s, cost %.1f\n", seed, system ? "40 solutions" : "not all found", steps);
    if (!system || (best && steps >= lowest)) continue;
    best = system;
    lowest = steps;
  }
  if (!best) return EXIT_FAILURE;
  print(*best, candidates);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace parallel_aspects::platform_paths

int main(int argc, char** argv) {
  const long candidates = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 1;
  return parallel_aspects::platform_paths::generate(static_cast<unsigned>(std::max(candidates, 1L)));
}
