#include "bounded_quadratic.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace robotui::rt::plugins {
namespace {

constexpr double kRest = 1e-10;      // of the function's distance: a shorter step is none
constexpr double kParallel = 1e-13;  // cosine below which a row does not change along a step
constexpr double kOneValue = 1e-12;  // bounds that are so near to each other are one value

// Substitution by hand: in Eigen's own, of a vector, the analyzer of clang sees memory that is lost.
template <typename Triangle>
void solveLower(const Triangle& lower, Eigen::VectorBlock<Eigen::VectorXd> of) noexcept {
  for (Eigen::Index i = 0; i < of.size(); ++i) of[i] = (of[i] - lower.row(i).head(i).dot(of.head(i))) / lower(i, i);
}

template <typename Triangle>
void solveUpper(const Triangle& upper, Eigen::VectorBlock<Eigen::VectorXd> of) noexcept {
  for (Eigen::Index i = of.size() - 1; i >= 0; --i) {
    const Eigen::Index behind = of.size() - 1 - i;
    of[i] = (of[i] - upper.row(i).tail(behind).dot(of.tail(behind))) / upper(i, i);
  }
}

}  // namespace

BoundedQuadratic::BoundedQuadratic(Index most_variables, Index most_rows)
    : hessian_(most_variables, most_variables), rows_(most_rows, most_variables), gradient_(most_variables),
      lower_(most_rows), upper_(most_rows), result_(most_variables), at_(most_variables), values_(most_rows),
      slopes_(most_rows), step_(most_variables), multipliers_(most_variables), basis_(most_variables, most_variables),
      triangle_(most_variables, most_variables), sides_(static_cast<std::size_t>(most_rows), Side::kFree) {
  active_.reserve(static_cast<std::size_t>(most_variables));
}

void BoundedQuadratic::begin(Index variables, Index rows) noexcept {
  variables_ = variables;
  count_ = rows;
  active_.clear();
  std::fill(sides_.begin(), sides_.end(), Side::kFree);
}

// With H = L L' and u = L' y the function is the distance of u from -g~, g~ = L^-1 g: steps are projections.
bool BoundedQuadratic::solve() noexcept {
  Eigen::Ref<Eigen::MatrixXd> in_place(hessian());
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(in_place);
  auto offset = gradient();
  solveLower(in_place, offset);
  auto constraints = rows();
  in_place.transpose().triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(constraints);
  at_.head(variables_).setZero();
  values_.head(count_).setZero();
  const double still = kRest * (1 + offset.norm());
  const Index most = 4 * (variables_ + count_) + 10;
  bool done = false;
  for (Index i = 0; i < most && !done; ++i) {
    findStep();
    if (step_.head(variables_).norm() <= still) {
      done = !removeWorst();
      continue;
    }
    slopes_.head(count_).noalias() = constraints * step_.head(variables_);
    const Blocking blocking = findBlocking();
    at_.head(variables_) += blocking.part * step_.head(variables_);
    values_.head(count_) += blocking.part * slopes_.head(count_);
    if (blocking.row >= 0) add(blocking.row, blocking.side);
  }
  auto result = variables();
  result = at_.head(variables_);
  solveUpper(in_place.transpose(), result);
  return done;
}

// The way to the minimum on which the active rows keep their values; twice, since projections lose digits.
void BoundedQuadratic::findStep() noexcept {
  const auto count = static_cast<Index>(active_.size());
  const auto basis = basis_.topLeftCorner(variables_, count);
  auto step = step_.head(variables_);
  auto along = multipliers_.head(count);
  step = -at_.head(variables_) - gradient();
  for (int i = 0; i < 2 && count > 0; ++i) {
    along.noalias() = basis.transpose() * step;
    step.noalias() -= basis * along;
  }
}

BoundedQuadratic::Blocking BoundedQuadratic::findBlocking() const noexcept {
  Blocking first;
  const double length = step_.head(variables_).norm();
  for (Index i = 0; i < count_; ++i) {
    const double slope = slopes_[i];
    if (sides_[static_cast<std::size_t>(i)] != Side::kFree) continue;
    if (std::abs(slope) <= kParallel * length * rows_.row(i).head(variables_).norm()) continue;
    const double room = slope > 0 ? upper_[i] - values_[i] : lower_[i] - values_[i];
    const double part = std::max(room / slope, 0.0);
    if (part >= first.part) continue;
    const bool is_equal = upper_[i] - lower_[i] <= kOneValue;
    first = {i, is_equal ? Side::kEqual : slope > 0 ? Side::kUpper : Side::kLower, part};
  }
  return first;
}

void BoundedQuadratic::add(Index row, Side side) noexcept {
  if (static_cast<Index>(active_.size()) == variables_) return;
  sides_[static_cast<std::size_t>(row)] = side;
  active_.push_back(row);
  makeBasis(static_cast<Index>(active_.size()) - 1);
}

// By Gram and Schmidt, each row twice.
void BoundedQuadratic::makeBasis(Index from) noexcept {
  for (Index k = from; k < static_cast<Index>(active_.size()); ++k) {
    auto column = basis_.col(k).head(variables_);
    column = rows_.row(active_[static_cast<std::size_t>(k)]).head(variables_).transpose();
    triangle_.col(k).head(k).setZero();
    for (int i = 0; i < 2 && k > 0; ++i) {
      auto along = multipliers_.head(k);
      along.noalias() = basis_.topLeftCorner(variables_, k).transpose() * column;
      column.noalias() -= basis_.topLeftCorner(variables_, k) * along;
      triangle_.col(k).head(k) += along;
    }
    triangle_(k, k) = std::max(column.norm(), std::numeric_limits<double>::min());
    column /= triangle_(k, k);
  }
}

// At the minimum between the active rows: the one that holds the function back from the inside, most of all. False
// where there is none, and so this is the minimum.
bool BoundedQuadratic::removeWorst() noexcept {
  const auto count = static_cast<Index>(active_.size());
  auto forces = multipliers_.head(count);
  step_.head(variables_) = -at_.head(variables_) - gradient();
  forces.noalias() = basis_.topLeftCorner(variables_, count).transpose() * step_.head(variables_);
  solveUpper(triangle_.topLeftCorner(count, count), forces);
  Index worst = -1;
  double least = -kRest * (1 + gradient().norm());
  for (Index k = 0; k < count; ++k) {
    const Side side = sides_[static_cast<std::size_t>(active_[static_cast<std::size_t>(k)])];
    if (side == Side::kEqual) continue;
    const double outwards = (side == Side::kUpper ? forces[k] : -forces[k]) * triangle_.col(k).head(k + 1).norm();
    if (outwards >= least) continue;
    least = outwards;
    worst = k;
  }
  if (worst < 0) return false;
  sides_[static_cast<std::size_t>(active_[static_cast<std::size_t>(worst)])] = Side::kFree;
  active_.erase(active_.begin() + worst);
  makeBasis(worst);
  return true;
}

}  // namespace robotui::rt::plugins
