// The sheets of one kind of motion (sheet_source.hpp) over a range of nu, against all its motions
// at checkpoints there: steps 1, 2, 3 and 5 of an atlas (atlas.hpp).
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "solver/atlas/atlas.hpp"
#include "solver/atlas/sheet_source.hpp"

namespace stationary {

/// From a solved motion both ways, as an atlas follows sheets.
FollowReport follow_rows(const AnyFamily& family, const Stretch& q, double nu,
                         const AtlasOptions& options, std::vector<AtlasRow>& rows);

/// At which ends of an interval of nu a sheet is outside that leaves the box there.
struct OpenEnds {
  bool low = false;
  bool high = false;
};

class SheetSet {
 public:
  /// options must outlive this.
  SheetSet(std::unique_ptr<SheetSource> source, const AtlasOptions& options);

  /// All motions at one checkpoint; different ones by different threads, if they like. number: of
  /// the search in the atlas.
  void search_at(std::size_t checkpoint, std::size_t number);

  /// Then, if a proof is to come that may take long: the sheets from rest and through the motions proven
  /// at the checkpoints.
  void follow_proven();

  /// Then, where asked for: intervals of nu with one number of motions each, and a checkpoint in the
  /// middle of every one.
  void complete();

  /// Then, of the first family, sheets of this kind that are known: they are followed no more.
  void adopt(const AtlasSheet& sheet);

  /// Then every sheet that is not followed yet: from rest, through the motions found that lie on none,
  /// and off the sheets of this set, and of the others given.
  void follow_all(std::span<const AtlasSheet> others = {});

  std::optional<TiltPlane> plane() const { return source_->plane(); }
  /// By nu.
  std::vector<Checkpoint> checkpoints() const;
  const std::optional<Completeness>& completeness() const { return completeness_; }
  /// Without those adopted.
  std::span<AtlasSheet> found();
  const std::vector<Remark>& remarks() const { return remarks_; }

 private:
  struct Parting {
    Branch branch;  ///< of the sheet left
    Member at;
  };

  void add_checkpoint(double nu);
  void keep_found(std::size_t checkpoint, const SearchResult& result);
  void add_interval(double from, double to, std::span<const Interval> class_gaps);
  void add_classes(double from, double to, std::span<const Interval> class_gaps, double searched,
                   const SearchResult& found);
  ClassInterval classes_between(double from, double to, const SearchResult& found) const;
  void name_class_events();
  void name_beyond();
  std::vector<Interval> listed_outside() const;
  bool excludes_outside(const Interval& nu, std::span<const Interval> listed) const;
  std::optional<Interval> excluded_between(const CompleteInterval& of, const OpenEnds& ends,
                                           std::span<const Interval> listed) const;
  std::vector<Interval> excluded_parts(const CompleteInterval& of,
                                       std::span<const Interval> listed) const;
  Place canonical_place(const Equilibrium& at) const;
  std::vector<const Equilibrium*> one_of_each_pair(const std::vector<Equilibrium>& found) const;
  void follow_rest();
  void enter_all(const std::vector<std::vector<Place>>& found, Entry entry, std::size_t first);
  void follow_others(std::span<const AtlasSheet> others);
  void enter(const Place& from, double nu, Entry entry, double entry_nu);
  void remark(Entry entry, double nu, std::string reason);
  bool lies_on(const AtlasSheet& sheet, int family, const Place& at, double nu) const;
  bool lies_on_vertical(const AtlasSheet& sheet, const Place& at, double nu) const;
  bool is_part_of(const AtlasSheet& sheet, const Place& from, double nu, const AtlasSheet& other,
                  int family) const;
  bool same_ends(const AtlasSheet& a, const AtlasSheet& b) const;
  Place place(const Member& member) const;
  Place place(const Parting& parting) const;
  void add_crossings(const AtlasSheet& sheet, int family, double nu, std::vector<Place>& out) const;
  bool on_a_sheet(const Place& at, std::size_t checkpoint) const;
  void count(std::size_t checkpoint);
  void add_partings(std::span<const AtlasSheet> sheets, std::vector<Parting>& out) const;
  void leave(const Parting& parting);
  bool has_child(const Parting& parting, std::span<const Parting> all) const;
  void prove_partings();

  const AtlasOptions& options_;
  std::unique_ptr<SheetSource> source_;
  std::vector<AnyFamily> families_;
  std::vector<std::shared_ptr<const AnyFamily>> plain_;  ///< without spectra
  std::vector<Checkpoint> checkpoints_;
  std::vector<std::vector<Place>> solutions_;  ///< proven at each checkpoint, canonical
  std::vector<std::vector<Place>> unproven_;   ///< likewise, where a search is undecided
  std::vector<std::vector<Place>> on_sheets_;  ///< points there of the sheets so far
  std::vector<AtlasSheet> sheets_;
  std::size_t adopted_ = 0;              ///< the first of them
  std::vector<int> families_of_sheets_;  ///< which of families_ each is of
  bool from_rest_ = false;               ///< those that begin there are followed
  std::size_t entered_ = 0;              ///< checkpoints whose proven motions have been entered
  std::vector<Remark> remarks_;
  std::optional<Completeness> completeness_;
};

}  // namespace stationary
