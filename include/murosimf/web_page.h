/// web_page.h - a page for browsers that shows and steers a scene, between the calls of a program that steps it, too.
///
///     murosimf::WebPage page(scene);                  // a thread of its own serves it, and has the scene
///     std::puts(page.address().c_str());              // http://127.0.0.1:40123/
///     {
///       const murosimf::WebPage::Turn turn(page);     // the program has the scene
///       scene.run(1.0);
///     }
#pragma once

#include <memory>
#include <string>

#include "murosimf/scene.h"

namespace murosimf {

namespace api {
struct WebPageInside;
}

inline namespace v0 {

struct WebPageOptions {
  std::string address = "127.0.0.1:0";  ///< HOST:PORT as of `murosimf run --web`; port 0: one that is free
  double speed = 1;                     ///< simulated seconds per wall second, if the page plays
};

/// It begins paused; its visitors may play, push and change. Looking changes no result. There is no way back in time by the page: it would go back
/// without the program.
class MUROSIMF_API WebPage {
 public:
  /// Keeps the scene alive inside the library. Throws InputError: the port is in use, this build has no server, an impossible speed.
  explicit WebPage(const Scene& scene, const WebPageOptions& options = {});
  ~WebPage();
  WebPage(const WebPage&) = delete;
  WebPage& operator=(const WebPage&) = delete;

  /// For browsers; for those of other computers with the token.
  [[nodiscard]] std::string address() const;
  /// Stops what the page plays.
  void pause();

  /// What a turn is for.
  enum class Use {
    step,  ///< reading, changing, stepping
    jump,  ///< reset and load
  };
  /// The program has the scene and its handles, and the page waits between two steps.
  class MUROSIMF_API Turn {
   public:
    /// Waits for the end of the present step. Throws as error.h says if the scene has failed while the page had it.
    explicit Turn(WebPage& page, Use use = Use::step);
    ~Turn();
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;
    /// Lets the page do what it was asked for meanwhile. Throws likewise.
    void breathe();

   private:
    void take(Use use);
    void give();
    WebPage& page_;
    bool taken_ = false;
  };

 private:
  std::unique_ptr<api::WebPageInside> inside_;
};

}  // namespace v0
}  // namespace murosimf
