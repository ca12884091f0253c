// Of a motion and its mirror images an atlas keeps one place; and what it has where it is told to stop
// while it proves that nothing is missing.
#include "solver/atlas/sheet_source.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <utility>

#include "solver/atlas/sheet_set.hpp"

namespace stationary {
namespace {

const Potential separable(Hencky<>{1.0, 3.0}, ReciprocalQuadratic<>{1.0, 3.0});
const Potential coupled(NeoHookean3d<>{1.0, 2.0});

void expect_place(const SheetSource& source, const Stretch& at, const Stretch& kept) {
  const Stretch found = source.canonical({at}).q;
  EXPECT_EQ(found.alpha, kept.alpha);
  EXPECT_DOUBLE_EQ(found.xi, kept.xi);
  EXPECT_DOUBLE_EQ(found.zeta, kept.zeta);
  EXPECT_DOUBLE_EQ(found.rho, kept.rho);
}

TEST(SheetSource, WithoutACircleEveryPlaceIsItsOwn) {
  for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
    const auto source = axis_sheets(Problem(Body(1.0, 1.7, 0.6), separable, branch));
    for (const Stretch& q : {Stretch{0.0, 0.8, 1.3, 0.9}, Stretch{0.0, 1.3, 0.8, 0.9}})
      expect_place(*source, q, q);
  }
}

TEST(SheetSource, OfAnEllipseAndItsImageTheOneAlongTheFirstAxisIsKept) {
  const auto third = axis_sheets(Problem(Body(1.7, 1.7, 0.6), separable, Branch::iii));
  expect_place(*third, {0.0, 0.8, 1.3, 0.9}, {0.0, 1.3, 0.8, 0.9});
  expect_place(*third, {0.0, 1.3, 0.8, 0.9}, {0.0, 1.3, 0.8, 0.9});
  expect_place(*third, {0.0, 1.1, 1.1, 0.9}, {0.0, 1.1, 1.1, 0.9});
  const auto first = axis_sheets(Problem(Body(0.6, 1.7, 1.7), coupled, Branch::i));
  expect_place(*first, {0.0, 0.9, 0.8, 1.3}, {0.0, 0.9, 1.3, 0.8});
  expect_place(*first, {0.0, 0.9, 1.3, 0.8}, {0.0, 0.9, 1.3, 0.8});
}

/// Spins about a material axis, told to stop as their curves begin to be covered.
class StoppedAtItsCover final : public SheetSource {
 public:
  StoppedAtItsCover(const Problem& problem, std::atomic<bool>& stop)
      : own_(axis_sheets(problem)), stop_(&stop) {}

  Branch branch() const override { return own_->branch(); }
  SearchResult search(double nu, const SearchOptions& options) const override {
    return own_->search(nu, options);
  }
  std::optional<KindCover> cover(double, double, const SearchOptions&, bool) const override {
    *stop_ = true;
    KindCover out;
    out.interrupted = true;
    return out;
  }
  std::optional<StabilityClass> proven_class(const Equilibrium& at, Inputs inputs) const override {
    return own_->proven_class(at, inputs);
  }
  std::vector<Place> at_rest(const SolveOptions& options) const override {
    return own_->at_rest(options);
  }
  AnyFamily family(int which, bool spectrum) const override {
    return own_->family(which, spectrum);
  }
  DepartureResult departure(Branch parent, const Member& at, double range) const override {
    return own_->departure(parent, at, range);
  }

 private:
  std::unique_ptr<SheetSource> own_;
  std::atomic<bool>* stop_;
};

TEST(SheetSet, WhatWasFollowedBeforeAProofCutShortIsKept) {
  std::atomic<bool> stop{false};
  AtlasOptions options;
  options.checkpoints = 4;
  options.complete = true;
  options.stop = options.search.stop = &stop;
  SheetSet set(std::make_unique<StoppedAtItsCover>(
                   Problem(Body(1.0, 1.7, 0.6), separable, Branch::iii), stop),
               options);
  for (std::size_t k = 0; k < 4; ++k) set.search_at(k, k);
  set.follow_proven();
  set.complete();
  EXPECT_TRUE(stop);
  set.follow_all();
  ASSERT_FALSE(set.found().empty());
  EXPECT_EQ(set.found().front().entry, Entry::rest);
  for (const AtlasSheet& sheet : set.found()) EXPECT_FALSE(sheet.report.interrupted);
  EXPECT_TRUE(set.remarks().empty());
  for (const Checkpoint& at : set.checkpoints()) {
    EXPECT_GE(at.proven, 1);
    EXPECT_EQ(at.on_sheets, at.proven);
  }
}

}  // namespace
}  // namespace stationary
