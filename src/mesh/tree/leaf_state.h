// The state of a leaf: what cuts it, and whether it may be halved further.
#pragma once

#include <cstdint>

namespace saddle {

/// The lines that cut a leaf. A jump that ends at the boundary cuts it with the boundary.
enum class LeafCut : std::uint8_t {
  Nothing,
  Boundary,            ///< some samples are undefined
  Feature,             ///< a jump, a pole or a crease
  BoundaryAndFeature,  ///< both
};

/// Whether a leaf may be halved further. An oscillation is final.
enum class LeafProgress : std::uint8_t {
  Active,
  Frozen,       ///< halving does not help, or is not allowed
  Oscillating,  ///< an Oscillation that the leaf is part of stopped its halving
};

/// The state of a leaf. Its transitions are the only writers.
///
/// LeafCut and LeafProgress are independent: leaves of each cut stop for either reason. An uncut
/// pole goes with every cut, and a leaf of any state may be left out at the end.
class LeafState {
 public:
  LeafCut cut() const { return cut_; }
  LeafProgress progress() const { return progress_; }

  bool is_whole() const { return cut_ == LeafCut::Nothing; }
  bool is_on_boundary() const {
    return cut_ == LeafCut::Boundary || cut_ == LeafCut::BoundaryAndFeature;
  }
  bool is_cut_by_feature() const { return cut_ >= LeafCut::Feature; }
  bool may_be_halved() const { return progress_ == LeafProgress::Active; }
  bool oscillates() const { return progress_ == LeafProgress::Oscillating; }
  /// The surface goes to infinity between two neighbours on a side.
  bool leads_to_pole() const { return leads_to_pole_; }
  /// The leaf is no part of the mesh: it contains a pole or a point without limit.
  bool is_left_out() const { return is_left_out_; }
  /// The leaf is left out since its features do not part it clearly.
  bool is_too_small() const { return is_too_small_; }
  /// The lines that cut the leaf, or a leaf that it is a part of, have no corners in it.
  bool is_cut_smoothly() const { return is_cut_smoothly_; }

  /// A sample of the leaf is undefined.
  void cross_boundary() { set_cut(true, is_cut_by_feature()); }
  /// The same, where a pole that was found before may be the boundary.
  void take_pole_for_boundary() {
    if (leads_to_pole_) set_features(false, false);
    cross_boundary();
  }
  /// A half of a leaf on the boundary: its samples are not known yet.
  void forget_boundary() { set_cut(false, is_cut_by_feature()); }
  /// The sides of the leaf were searched.
  void set_features(bool is_cut, bool leads_to_pole) {
    set_cut(is_on_boundary(), is_cut);
    leads_to_pole_ = leads_to_pole;
  }
  /// An oscillation stays the reason.
  void freeze() {
    if (progress_ == LeafProgress::Active) progress_ = LeafProgress::Frozen;
  }
  /// A feature was found in the leaf, toward which it may be halved.
  void thaw() {
    if (progress_ == LeafProgress::Frozen) progress_ = LeafProgress::Active;
  }
  /// The lines were looked at.
  void note_smooth_cut() { is_cut_smoothly_ = true; }
  void stop_at_oscillation() { progress_ = LeafProgress::Oscillating; }
  void leave_out() { is_left_out_ = true; }
  /// The leaf is too small to see or to halve, and its features do not part it clearly.
  void leave_out_too_small() {
    freeze();
    is_left_out_ = is_too_small_ = true;
  }
  /// The leaf is halved on.
  void take_back() {
    is_left_out_ = is_too_small_ = false;
    progress_ = LeafProgress::Active;
  }

 private:
  void set_cut(bool by_boundary, bool by_feature) {
    cut_ = by_feature ? (by_boundary ? LeafCut::BoundaryAndFeature : LeafCut::Feature)
                      : (by_boundary ? LeafCut::Boundary : LeafCut::Nothing);
  }

  LeafCut cut_ : 2 = LeafCut::Nothing;
  LeafProgress progress_ : 2 = LeafProgress::Active;
  bool leads_to_pole_ : 1 = false;
  bool is_left_out_ : 1 = false;
  bool is_too_small_ : 1 = false;
  bool is_cut_smoothly_ : 1 = false;
};

}  // namespace saddle
