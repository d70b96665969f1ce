#include "murosimf/viewer/session_requests.h"

#include <utility>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::viewer {
namespace {

constexpr std::size_t most_messages = 200;

}  // namespace

bool is_ready(const std::future<void>& done) {
  return done.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

void MessageLog::tell(std::string text, bool error) {
  messages_.push_back({std::move(text), error});
  if (messages_.size() > most_messages) messages_.pop_front();
}

void SessionRequests::ask(std::string what, std::future<void> done, bool silent) {
  asked_.push_back({std::move(what), std::move(done), silent});
}

void SessionRequests::collect(session::Session& session) {
  for (Asked& asked : asked_) {
    if (!is_ready(asked.done)) continue;
    if (asked.moves) moving_ = false;
    try {
      asked.done.get();
      if (!asked.silent) messages_.tell(asked.what);
    } catch (const SetupError& error) {
      messages_.tell(error.what(), true);
    }
  }
  std::erase_if(asked_, [](const Asked& asked) { return !asked.done.valid(); });
  if (moving_ || moves_.empty()) return;
  const auto [path, value] = *moves_.begin();
  moves_.erase(moves_.begin());
  moving_ = true;
  asked_.push_back({"move", session.change(fmt::format("{} = {}", path, value)), true, true});
}

void SessionRequests::forget() {
  asked_.clear();
  moves_.clear();
  moving_ = false;
}

}  // namespace murosimf::viewer
