// The actions of keys, menus and lists on the window: what is no business of the model's.
#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "base/heap.h"
#include "export/formats/load_scene.h"
#include "scene/model/gallery.h"
#include "scene/options/command_text.h"
#include "scene/toml/scene_file.h"
#include "view/model/files.h"
#include "view/panel/fields.h"
#include "view/panel/widgets.h"
#include "view/window/viewer.h"

namespace saddle {
namespace {

/// The size of the start page's pictures, in pixels of the user's.
constexpr double kThumbnailWidth = 132;
constexpr double kThumbnailHeight = 99;

/// A scene with a mistake is written as it is, but opened only once that is mended.
bool can_be_opened(const std::filesystem::path& file) {
  try {
    load_scene(file);
    return true;
  } catch (const Error&) {
    return false;
  }
}

std::string key_and_help(const ActionRow& row) {
  const std::string key = row.key;
  return key.empty() ? row.help : key + "   " + row.help;
}

}  // namespace

bool Viewer::can(Action action) const {
  const Needs needs = row_of(action).needs;
  return needs == Needs::Work ? has_work_ : model_.has(needs);
}

void Viewer::act(Action action) {
  if (!can(action)) return say(lack_of(row_of(action).needs));
  try {
    if (!act_on_window(action) && !act_on_files(action) && model_.act(action)) {
      if (action == Action::New) start_shown_ = false;
      change_picture();
    }
  } catch (...) {
    say(caught_error().what());
  }
  touch();
}

bool Viewer::act_on_window(Action action) {
  switch (action) {
    case Action::FullScreen:
      window_.toggle_full_screen();
      return true;
    case Action::Help:
      help_shown_ = !help_shown_;
      return true;
    case Action::Dismiss:
      dismiss();
      return true;
    case Action::Actions:
      list_actions();
      return true;
    case Action::Quit:
      if (may_lose_work()) return true;
      insisting_ = closing_;
      closing_ = true;
      if (exporter_.is_busy()) say("writing a file; quit again to leave without it");
      return true;
    default:
      return false;
  }
}

bool Viewer::act_on_files(Action action) {
  switch (action) {
    case Action::Start:
      start_shown_ = true;
      begin_thumbnails();
      return true;
    case Action::Open:
      list_files();
      return true;
    case Action::Gallery:
      list_gallery();
      return true;
    case Action::Restore:
      restore_work();
      return true;
    case Action::SavePicture:
      exporter_.write_new(model_.scene_to_save(), ".png");
      say("writing a picture");
      return true;
    case Action::SavePage:
      exporter_.write_new(model_.scene_to_save(), ".html");
      say("writing a page");
      return true;
    case Action::SaveScene: {
      const auto path = save_scene(model_.scene_to_save());
      session_.remember_file(path);
      if (!can_be_opened(path)) {
        say("saved " + path.string() + " with its mistake: it stays unsaved work, too");
        return true;
      }
      say("saved " + path.string());
      kept_ = saved_ = model_.history().version();
      session_.forget_work();
      return true;
    }
    case Action::Export:
      list_exports();
      return true;
    case Action::CopyCommand:
    case Action::CopyScene:
      copy(action);
      return true;
    default:
      return false;
  }
}

/// Closes the uppermost thing; the last is the field, which gives the keyboard to the picture.
void Viewer::dismiss() {
  if (is_popup_open()) {
    close_popups();
    is_typing_ = false;
  } else if (help_shown_) {
    help_shown_ = false;
  } else if (start_shown_) {
    start_shown_ = model_.scene().surfaces.empty();
  } else {
    is_typing_ = false;
    message_.clear();
  }
}

void Viewer::copy(Action action) {
  const Scene scene = model_.scene_to_save();
  const auto text = action == Action::CopyScene ? write_scene(scene) : command_text(scene);
  if (!text) return say("only a scene file can say this: press C");
  window_.set_clipboard(*text);
  say(action == Action::CopyScene ? "copied the scene" : "copied the command");
}

// --- lists

void Viewer::list_actions() {
  chooser_.open("what to do", "", [this](const std::string& query) {
    std::vector<Choice> choices;
    for (const ActionRow& row : action_table()) {
      if (row.menu == Menu::None) continue;
      choices.push_back({row.name, key_and_help(row), can(row.action),
                         [this, action = row.action] { act(action); }});
    }
    return matching(std::move(choices), query);
  });
}

void Viewer::list_gallery() {
  chooser_.open("a surface of the gallery", "", [this](const std::string& query) {
    std::vector<Choice> choices;
    for (const GalleryEntry& entry : gallery()) {
      choices.push_back({std::string(entry.name), std::string(entry.description), true,
                         [this, &entry] { show_scene(gallery_scene(entry), {}); }});
    }
    return matching(std::move(choices), query);
  });
}

void Viewer::list_files() {
  chooser_.open("a file, such as ~/scenes/torus.toml", "", [this](const std::string& query) {
    std::vector<Choice> choices;
    if (query.empty()) {
      for (const auto& path : session_.recent_files()) {
        choices.push_back(
            {path.filename(), path.parent_path(), true, [this, path] { open(path); }});
      }
      choices.push_back({"../", "the folder above", true, {}, "../"});
    }
    for (const FoundFile& file : find_files(query)) {
      Choice choice{file.path, "", true, [this, file] { open(typed_path(file.path)); }};
      if (file.is_folder) choice.query = file.path;
      choices.push_back(std::move(choice));
    }
    const auto whole = typed_path(query);
    std::error_code ignored;
    if (choices.empty() && std::filesystem::is_regular_file(whole, ignored)) {
      choices.push_back({query, "", true, [this, whole] { open(whole); }});
    }
    return choices;
  });
}

/// The first of each format's names, or what was typed.
void Viewer::list_exports() {
  chooser_.open("a file to write, such as torus.glb", "", [this](const std::string& query) {
    std::vector<Choice> choices;
    const std::string& title = model_.scene().title;
    std::vector<ExportChoice> files = export_choices(title, query);
    if (files.empty()) {
      choices.push_back({.name = "no format ends so; there are:", .is_possible = false});
      files = export_choices(title, query.substr(0, query.rfind('.')));
    }
    for (const ExportChoice& each : files) {
      const bool is_possible = !each.needs_movement || can(Action::Play);
      choices.push_back(
          {each.name, each.detail, is_possible, [this, each] { write_file(each.file); }});
    }
    return choices;
  });
}

void Viewer::write_file(const Export& file) {
  exporter_.write(model_.scene_to_save(), file);
  say("writing " + file.path.string());
}

// --- scenes

/// In place of the one that is shown, which undo() brings back.
void Viewer::show_scene(Scene scene, std::function<Scene()> reload, std::filesystem::path file) {
  model_.open(std::move(scene), std::move(reload), std::move(file));
  kept_ = saved_ = model_.history().version();
  start_shown_ = help_shown_ = is_typing_ = false;
  drawing_.change_with_meshes();
  touch();
}

/// A file that cannot be opened leaves the scene that is shown, with a message.
void Viewer::open(const std::filesystem::path& path) {
  try {
    const auto whole = std::filesystem::absolute(path);
    if (!std::filesystem::exists(whole)) {
      throw Error(Status::Input, "there is no file " + whole.string());
    }
    if (!std::filesystem::is_regular_file(whole)) {
      throw Error(Status::Input, whole.string() + " is no file");  // such as /dev/zero, without end
    }
    show_scene(
        load_scene(whole), [whole] { return load_scene(whole); }, whole);
    session_.remember_file(whole);
    if (!watched_.empty()) watched_ = whole;
  } catch (...) {
    say(window_text(caught_error()));
  }
}

/// It stays unsaved.
void Viewer::restore_work() {
  const auto path = session_.left_work();
  if (!path) return say("there is no unsaved work");
  show_scene(read_draft({*path, read_file(*path)}), {});
  kept_ = saved_ = kNever;
  std::error_code ignored;
  std::filesystem::remove(*path, ignored);
  has_work_ = session_.left_work().has_value();
}

/// Keeps what was changed and is not saved, some time after the last change, or `now`: mistakes,
/// too, but no scene without anything in it.
void Viewer::keep_work(bool now) {
  const std::size_t version = model_.history().version();
  if (version != seen_) changed_ = Clock::now();
  seen_ = version;
  const bool tries_again = now && !not_kept_.empty();
  if ((kept_ == version && !tries_again) || (!now && Clock::now() < changed_ + kKeep)) return;
  kept_ = version;
  if (version == saved_) return session_.forget_work();
  const Scene& scene = model_.scene();
  if (scene.surfaces.empty() && scene.curves.empty() && scene.points.empty()) return;
  const std::string why = session_.keep_work(write_scene(model_.scene_to_save()));
  const bool is_news = why != std::exchange(not_kept_, why) && !why.empty();
  if (is_news) say("unsaved work is not kept: " + why + "\nS saves the scene here");
}

/// After each rest once: the next deed of a person would take it from the system again.
void Viewer::tidy() {
  const auto now = Clock::now();
  if (!is_at_rest()) {
    tidy_at_ = now + kTidy;
  } else if (tidy_at_ && now >= *tidy_at_) {
    tidy_at_.reset();
    give_back_free_memory();
  }
}

/// Says so once: quitting again leaves it.
bool Viewer::may_lose_work() {
  keep_work(true);
  if (not_kept_.empty() || std::exchange(is_loss_told_, true)) return false;
  say("unsaved work would be lost: " + not_kept_ + "\nquit again to leave it, S saves it here");
  return true;
}

// --- the start page

/// Where there is no second context, the page has the names alone.
void Viewer::begin_thumbnails() {
  if (thumbnails_) return;
  const double scale = window_.scale();
  try {
    thumbnails_.emplace(Window::make_context(), static_cast<int>(kThumbnailWidth * scale),
                        static_cast<int>(kThumbnailHeight * scale), Window::wake);
  } catch (...) {
    say(caught_error().what());
  }
}

/// True: a frame is to be shown.
bool Viewer::go_on_with_thumbnails() {
  drawing_.forget_window();
  if (thumbnails_) {
    thumbnails_->go_on();
    if (thumbnails_->take()) to_paint_ = std::max(to_paint_, 1);
  }
  return to_paint_ > 0;
}

void Viewer::show_start() {
  StartPage& page = start_page_;
  page.recent = session_.recent_files();
  page.has_work = has_work_;
  page.thumbnail = [this](std::size_t entry) {
    return thumbnails_ ? thumbnails_->texture(entry) : 0;
  };
  page.thumbnail_width = kThumbnailWidth * window_.scale();
  page.thumbnail_height = kThumbnailHeight * window_.scale();
  show_start_page(page, panel_.is_confirmed() && !chooser_.is_open());
  if (page.entry) {
    show_scene(gallery_scene(gallery()[*page.entry]), {});
  } else if (page.file) {
    open(*page.file);
  } else if (page.action) {
    act(*page.action);
  }
}

}  // namespace saddle
