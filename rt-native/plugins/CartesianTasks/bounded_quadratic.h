// The least of a convex quadratic function within bounds on linear functions of its variables. Nothing allocates after
// construction.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Dense>

namespace robotui::rt::plugins {

// A primal active-set method: it starts at zero, which the bounds have to allow, stays within them in each step, and
// ends at the minimum, or after its last step where it is then. One problem: begin(), fill all of what stands below it,
// solve(), read variables().
class BoundedQuadratic {
 public:
  using Index = Eigen::Index;
  using Matrix = Eigen::Block<Eigen::MatrixXd>;
  using Vector = Eigen::VectorBlock<Eigen::VectorXd>;

  BoundedQuadratic(Index most_variables, Index most_rows);

  void begin(Index variables, Index rows) noexcept;
  // Of 1/2 y' H y + g' y: positive definite; its lower half is read, and it is lost in solve().
  Matrix hessian() noexcept { return hessian_.topLeftCorner(variables_, variables_); }
  Vector gradient() noexcept { return gradient_.head(variables_); }
  // lower <= rows y <= upper, with lower <= 0 <= upper; the rows are lost in solve().
  Matrix rows() noexcept { return rows_.topLeftCorner(count_, variables_); }
  Vector lower() noexcept { return lower_.head(count_); }
  Vector upper() noexcept { return upper_.head(count_); }

  // False where the steps did not suffice: the variables are within the bounds all the same.
  bool solve() noexcept;
  Vector variables() noexcept { return result_.head(variables_); }

 private:
  enum class Side : std::uint8_t { kFree, kLower, kUpper, kEqual };

  struct Blocking {
    Index row = -1;
    Side side = Side::kFree;
    double part = 1;
  };

  void findStep() noexcept;
  Blocking findBlocking() const noexcept;
  void add(Index row, Side side) noexcept;
  void makeBasis(Index from) noexcept;
  bool removeWorst() noexcept;

  Index variables_ = 0;
  Index count_ = 0;
  Eigen::MatrixXd hessian_;
  Eigen::MatrixXd rows_;
  Eigen::VectorXd gradient_;
  Eigen::VectorXd lower_;
  Eigen::VectorXd upper_;
  Eigen::VectorXd result_;
  Eigen::VectorXd at_;      // in the variables in which the function is a distance
  Eigen::VectorXd values_;  // of the rows
  Eigen::VectorXd slopes_;  // of the rows along the step
  Eigen::VectorXd step_;
  Eigen::VectorXd multipliers_;
  Eigen::MatrixXd basis_;     // orthonormal, of the active rows
  Eigen::MatrixXd triangle_;  // the active rows in that basis
  std::vector<Index> active_;
  std::vector<Side> sides_;  // of all rows
};

}  // namespace robotui::rt::plugins
