#include "murosimf/viewer/running_scene.h"

#include <utility>

#include "murosimf/math/assert.h"

namespace murosimf::viewer {

RunningScene::RunningScene(const session::MakeSource& make, const session::SessionOptions& options, Duration end)
    : session_(std::make_unique<session::Session>(make(), options)) {
  MUROSIMF_ASSERT(session_ != nullptr);
  thread_ = std::thread([this, end] {
    try {
      session_->run(end);
    } catch (...) {
      trouble_ = std::current_exception();
    }
    // the flag is set last: it publishes the exception
    ended_ = true;
  });
}

RunningScene::~RunningScene() {
  session_->finish();
  if (thread_.joinable()) thread_.join();
}

void RunningScene::finish() {
  session_->finish();
  if (thread_.joinable()) thread_.join();
  if (trouble_) std::rethrow_exception(std::exchange(trouble_, nullptr));
}

}  // namespace murosimf::viewer
