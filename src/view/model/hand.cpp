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

void Hand::release(int button) {
  if (hold_ && hold_->button == button) hold_.reset();
}

bool Hand::move(Model& model, const dvec2& pixel) const {
  if (!hold_) return false;
  const Hold& h = *hold_;
  if (!h.turns) {
    model.look_through(moved(h.grip, h.held, h.from, pixel));
  } else if (model.view().turntable) {
    model.look_through(turned_on_table(h.grip, model.view().table_up, h.from, pixel));
  } else {
    model.look_through(turned_on_ball(h.grip, h.from, pixel));
  }
  return true;
}

void Hand::scroll(Model& model, const dvec2& pixel, double notches) {
  const dvec3 fixed = model.under(pixel);
  model.look_through(zoomed(model.grip(), fixed, zoom_factor(notches), model.surface_size()));
  hold_.reset();  // it has a camera from before
}

}  // namespace saddle
