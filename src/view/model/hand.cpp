#include "view/model/hand.h"

namespace saddle {

void Hand::press(const Model& model, const dvec2& pixel, int button, bool shift) {
  Hold hold;
  hold.turns = button == 0 && !shift;
  hold.button = button;
  hold.grip = model.grip();
  hold.from = pixel;
  if (!hold.turns) hold.held = model.under(pixel);
  hold_ = hold;
}

void Hand::release(Model& model, int button) {
  if (!hold_ || hold_->button != button) return;
  hold_.reset();
  model.end_edit();
}

bool Hand::move(Model& model, const dvec2& pixel) const {
  if (!hold_) return false;
  const Hold& h = *hold_;
  if (!h.turns) {
    model.look_by_hand(moved(h.grip, h.held, h.from, pixel), "drag");
  } else if (model.view().turntable) {
    model.look_by_hand(turned_on_table(h.grip, model.view().table_up, h.from, pixel), "drag");
  } else {
    model.look_by_hand(turned_on_ball(h.grip, h.from, pixel), "drag");
  }
  return true;
}

void Hand::scroll(Model& model, const dvec2& pixel, double notches) {
  const dvec3 fixed = model.under(pixel);
  model.look_by_hand(zoomed(model.grip(), fixed, zoom_factor(notches), model.surface_size()),
                     "wheel");
  hold_.reset();  // it has a camera from before
}

}  // namespace saddle
