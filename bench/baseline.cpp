// SPDX-License-Identifier: GPL-3.0-or-later
// What one writes by hand: explicit Euler as in the paper, semi-implicit Euler, Runge-Kutta 4, on
// the same equations of motion, with locked degrees of freedom left out.
#include <Eigen/Core>
#include <Eigen/Geometry>

#include "bench/harness.hpp"

namespace isograsp::bench {

namespace {

using Vec3 = Eigen::Vector3d;
using Quat = Eigen::Quaterniond;

Triple triple(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

enum class Rule : std::uint8_t { explicit_euler, semi_implicit, rk4 };

/// Degrees of freedom that know nothing of each other: x, y, z and the angle about z.
template <Rule kRule>
class Lines : public Simulation {
 public:
  Lines(const Case& scene, int substeps)
      : scene_(scene), substeps_(substeps), h_(scene.hold_s / substeps) {
    for (std::size_t dof = 0; dof < 6; ++dof) {
      if (!scene.free[dof]) continue;
      const double m = dof < 3 ? scene.mass_kg : scene.inertia_kg_m2[dof - 3];
      lines_.push_back({dof, 1.0 / m, scene.damping[dof] / m, scene.stiffness[dof] / m, 0.0,
                        dof < 3 ? scene.start.v_WO_W[dof] : scene.start.w_WO_W[dof - 3]});
    }
  }
  void run(std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k)
      for (Line& line : lines_) {
        const Push& push = scene_.pushes[k];
        const double force = line.dof < 3 ? push.force[line.dof] : push.torque[line.dof - 3];
        const double drive = force * line.per_m;
        for (int i = 0; i < substeps_; ++i) step(line, drive);
      }
  }
  Motion6 motion() const override {
    Motion6 out;
    for (const Line& line : lines_) {
      if (line.dof < 3) {
        out.p_WO[line.dof] = line.x;
        out.v_WO_W[line.dof] = line.v;
      } else {
        out.q_WO[0] = std::cos(0.5 * line.x);
        out.q_WO[line.dof - 2] = std::sin(0.5 * line.x);
        out.w_WO_W[line.dof - 3] = line.v;
      }
    }
    return out;
  }

 private:
  struct Line {
    std::size_t dof;
    double per_m;
    double c_per_m;
    double k_per_m;
    double x;
    double v;
    [[nodiscard]] double acceleration(double drive, double at, double speed) const {
      return drive - k_per_m * at - c_per_m * speed;
    }
  };
  void step(Line& line, double drive) const {
    const double x = line.x;
    const double v = line.v;
    const double h = h_;
    const double a = line.acceleration(drive, x, v);
    if constexpr (kRule == Rule::explicit_euler) {
      line.x = x + h * v;
      line.v = v + h * a;
    } else if constexpr (kRule == Rule::semi_implicit) {
      line.v = v + h * a;
      line.x = x + h * line.v;
    } else {
      const double v2 = v + 0.5 * h * a;
      const double a2 = line.acceleration(drive, x + 0.5 * h * v, v2);
      const double v3 = v + 0.5 * h * a2;
      const double a3 = line.acceleration(drive, x + 0.5 * h * v2, v3);
      const double v4 = v + h * a3;
      const double a4 = line.acceleration(drive, x + h * v3, v4);
      line.x = x + h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
      line.v = v + h / 6.0 * (a + 2.0 * a2 + 2.0 * a3 + a4);
    }
  }
  const Case& scene_;
  int substeps_;
  double h_;
  std::vector<Line> lines_;
};

/// All rotations free: unit quaternion and angular velocity in object axes.
template <Rule kRule>
class Body : public Simulation {
 public:
  Body(const Case& scene, int substeps)
      : scene_(scene), substeps_(substeps), h_(scene.hold_s / substeps) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      const auto dof = static_cast<std::size_t>(i);
      inertia_[i] = scene.inertia_kg_m2[dof];
      turn_stiffness_[i] = scene.stiffness[dof + 3];
      turn_damping_[i] = scene.damping[dof + 3];
      per_m_[i] = scene.free[dof] ? 1.0 / scene.mass_kg : 0.0;
      stiffness_[i] = scene.stiffness[dof];
      damping_[i] = scene.damping[dof];
    }
    at_.v = Vec3(scene.start.v_WO_W.data());
    at_.w_O = Vec3(scene.start.w_WO_W.data());
  }
  void run(std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      const Vec3 force(scene_.pushes[k].force.data());
      const Vec3 torque(scene_.pushes[k].torque.data());
      for (int i = 0; i < substeps_; ++i) step(force, torque);
    }
  }
  Motion6 motion() const override {
    return {triple(at_.p),
            {at_.q.w(), at_.q.x(), at_.q.y(), at_.q.z()},
            triple(at_.v),
            triple(at_.q * at_.w_O)};
  }

 private:
  struct State {
    Vec3 p = Vec3::Zero();
    Vec3 v = Vec3::Zero();
    Vec3 w_O = Vec3::Zero();
    Quat q = Quat::Identity();
  };
  struct Slope {
    Vec3 v;
    Vec3 a;
    Vec3 alpha;
    Eigen::Vector4d q;  ///< x y z w
  };
  static Eigen::Vector4d rate(const Quat& q, const Vec3& w_O) {
    return 0.5 * (q * Quat(0.0, w_O.x(), w_O.y(), w_O.z())).coeffs();
  }
  [[nodiscard]] Slope slope(const State& s, const Vec3& force, const Vec3& torque) const {
    const Triple phi = log({s.q.w(), s.q.x(), s.q.y(), s.q.z()});
    const Vec3 force_W = scene_.follows ? Vec3(s.q * force) : force;
    const Vec3 torque_O = scene_.follows ? torque : Vec3(s.q.conjugate() * torque);
    const Vec3 momentum = inertia_.cwiseProduct(s.w_O);
    // The springs of all scenes here are the same about all axes: then this is the gradient.
    const Vec3 moment = torque_O - turn_stiffness_.cwiseProduct(Vec3(phi.data())) -
                        turn_damping_.cwiseProduct(s.w_O) - s.w_O.cross(momentum);
    const Vec3 total = force_W - stiffness_.cwiseProduct(s.p) - damping_.cwiseProduct(s.v);
    return {s.v, per_m_.cwiseProduct(total), moment.cwiseQuotient(inertia_), rate(s.q, s.w_O)};
  }
  static State moved(const State& s, const Slope& d, double h) {
    State out{s.p + h * d.v, s.v + h * d.a, s.w_O + h * d.alpha, s.q};
    out.q.coeffs() += h * d.q;
    return out;
  }
  void step(const Vec3& force, const Vec3& torque) {
    const Slope first = slope(at_, force, torque);
    if constexpr (kRule == Rule::explicit_euler) {
      at_ = moved(at_, first, h_);
    } else if constexpr (kRule == Rule::semi_implicit) {
      at_.v += h_ * first.a;
      at_.w_O += h_ * first.alpha;
      at_.p += h_ * at_.v;
      at_.q.coeffs() += h_ * rate(at_.q, at_.w_O);
    } else {
      const Slope second = slope(moved(at_, first, 0.5 * h_), force, torque);
      const Slope third = slope(moved(at_, second, 0.5 * h_), force, torque);
      const Slope fourth = slope(moved(at_, third, h_), force, torque);
      const auto mean = [&](auto part) {
        return ((first.*part + 2.0 * second.*part + 2.0 * third.*part + fourth.*part) / 6.0).eval();
      };
      at_ =
          moved(at_, {mean(&Slope::v), mean(&Slope::a), mean(&Slope::alpha), mean(&Slope::q)}, h_);
    }
    at_.q.normalize();
  }
  const Case& scene_;
  int substeps_;
  double h_;
  Vec3 inertia_, turn_stiffness_, turn_damping_, per_m_, stiffness_, damping_;
  State at_;
};

template <Rule kRule>
void add(const std::string& name, int most, std::vector<Method>& out) {
  for (const int n : ladder(most))
    out.push_back({name, n, "wrench in; springs and dampers in the equations of motion",
                   [n](const Case& c) -> std::unique_ptr<Simulation> {
                     if (c.linear()) return std::make_unique<Lines<kRule>>(c, n);
                     return std::make_unique<Body<kRule>>(c, n);
                   }});
}

std::vector<Method> methods(const Case& /*scene*/) {
  constexpr int kMost = 1024;
  constexpr int kMostOfFourthOrder = 256;
  std::vector<Method> all;
  add<Rule::explicit_euler>("explicit Euler", kMost, all);
  add<Rule::semi_implicit>("semi-implicit Euler", kMost, all);
  add<Rule::rk4>("Runge-Kutta 4", kMostOfFourthOrder, all);
  return all;
}

}  // namespace

}  // namespace isograsp::bench

int main(int argc, char** argv) {
  return isograsp::bench::run_engine("by hand", "1", isograsp::bench::methods, argc, argv);
}
