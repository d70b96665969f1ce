#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <list>
#include <mutex>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <supervision.pb.h>

#include "murosimf/control_software/tcp/tcp_client.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/model/error.h"
#include "murosimf/network/reception.h"
#include "murosimf/network/token.h"
#include "murosimf/supervise/requests.h"
#include "murosimf/supervise/session_slot.h"
#include "murosimf/supervise/supervision.h"

namespace murosimf::supervise {
namespace {

constexpr unsigned protocol_version = 1;
constexpr std::size_t longest_request = 65536;  // [byte]
constexpr std::size_t longest_name = 100;
constexpr std::size_t most_lines = 100;  // about refused clients

void parse(std::string_view bytes, wire::FromSupervisor& message) {
  if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())) ||
      message.kind_case() == wire::FromSupervisor::KIND_NOT_SET) {
    throw network::NetworkError("sends what is no message of this protocol");
  }
}

void send(network::Connection& connection, const wire::ToSupervisor& message) {
  connection.send(message.SerializeAsString());
}

network::WallTime after(double s) {
  using WallClock = network::WallTime::clock;
  return WallClock::now() + std::chrono::duration_cast<WallClock::duration>(std::chrono::duration<double>(s));
}

/// One supervisor, in its own thread.
class Supervisor {
 public:
  Supervisor(network::Caller caller, std::string name, SessionSlot& slot, const SupervisionOptions& options)
      : connection_(std::move(caller.connection)),
        name_(std::move(name)),
        patience_(options.patience),
        say_(options.say),
        wake_(::eventfd(0, EFD_CLOEXEC)),
        requests_(slot, options, [this] { return ends_.load() || has_gone(); }) {
    if (wake_ < 0) throw network::NetworkError("comes when too many files are open");
    thread_ = std::thread([this] { serve(); });
  }
  ~Supervisor() {
    ends_ = true;
    (void)::eventfd_write(wake_, 1);
    thread_.join();
    ::close(wake_);
  }
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  [[nodiscard]] bool is_over() const { return over_; }

 private:
  void serve() noexcept;
  void talk();
  void drop(const std::string& reason) noexcept;
  void answer(std::string_view bytes);
  [[nodiscard]] bool wait() const;
  [[nodiscard]] bool has_gone() const;

  network::Connection connection_;
  std::string name_;
  double patience_;
  std::function<void(const std::string&)> say_;
  int wake_;  // event that ends the wait of the thread
  std::atomic<bool> ends_{false}, over_{false};
  Requests requests_;
  std::thread thread_;
};

/// Waits for the next request; false: there will be none.
bool Supervisor::wait() const {
  std::array<pollfd, 2> asked{pollfd{wake_, POLLIN, 0}, {connection_.socket().number(), POLLIN, 0}};
  (void)::poll(asked.data(), asked.size(), -1);
  return !ends_;
}

bool Supervisor::has_gone() const {
  pollfd asked{connection_.socket().number(), POLLRDHUP, 0};
  return ::poll(&asked, 1, 0) > 0 && (asked.revents & (POLLRDHUP | POLLHUP | POLLERR)) != 0;
}

/// An error of one supervisor ends its connection only.
void Supervisor::serve() noexcept {
  try {
    talk();
  } catch (const std::exception& error) {
    drop(error.what());
  }
  connection_ = network::Connection({}, 0);
  over_ = true;
}

void Supervisor::talk() {
  wire::ToSupervisor message;
  try {
    requests_.welcome(message);
    send(connection_, message);
  } catch (const SetupError&) {  // the run has ended meanwhile
    ends_ = true;
  }
  while (!ends_) {
    if (const auto bytes = connection_.receive()) {
      answer(*bytes);
    } else if (!wait()) {
      break;
    }
  }
  message.mutable_goodbye();
  send(connection_, message);
}

/// Sends the reason to a client that is still connected, and reports it; a disconnection needs no report.
void Supervisor::drop(const std::string& reason) noexcept {
  if (has_gone()) return;
  try {
    wire::ToSupervisor message;
    message.mutable_refused()->set_reason(reason);
    send(connection_, message);
  } catch (const std::exception&) {  // it has disconnected meanwhile
  }
  if (say_) say_(fmt::format("{} was dropped: it {}", name_, reason));
}

/// An error of a request is an answer; an error of the protocol ends the connection.
void Supervisor::answer(std::string_view bytes) {
  wire::FromSupervisor request;
  wire::ToSupervisor message;
  parse(bytes, request);
  try {
    requests_.answer(request, message);
  } catch (const SetupError& error) {
    message.mutable_refused()->set_reason(files::one_line(error.what()));
  }
  send(connection_, message);
  connection_.flush_until(after(patience_));
}

class Server final : public Supervision {
 public:
  Server(session::Session& session, const SupervisionOptions& options);
  ~Server() override;

  [[nodiscard]] network::Address address() const override { return reception_->address(); }
  [[nodiscard]] const std::string& token() const override { return options_.token; }
  void leave() override { slot_.remove(); }
  void steer(session::Session& session) override { slot_.put(session); }

 private:
  void admit(network::Caller& caller, std::string_view message);
  void reject(network::Caller& caller, const std::string& reason);

  SupervisionOptions options_;
  SessionSlot slot_;
  std::list<Supervisor> supervisors_;  // accessed by the reception's thread only
  std::size_t told_ = 0;
  std::unique_ptr<network::Reception> reception_;
};

Server::Server(session::Session& session, const SupervisionOptions& options) : options_(options) {
  slot_.put(session);
  if (options_.token.empty()) {
    options_.token = network::new_token();
    if (options_.token.empty()) throw SetupError("this system gives no random numbers for a token");
  }
  if (options_.token.size() < shortest_token) {
    throw SetupError(fmt::format("the token of supervisors has {} characters; at least {} are needed",
                                 options_.token.size(), shortest_token));
  }
  try {
    reception_ = std::make_unique<network::Reception>(
        network::ReceptionOptions{.address = options_.address,
                                  .longest = longest_request,
                                  .hello_limit = options_.hello_limit},
        network::Reception::Door{[this](network::Caller& caller, std::string_view message) { admit(caller, message); },
                                 [this](network::Caller& caller, const std::string& reason) {
                                   reject(caller, reason);
                                 }});
  } catch (const network::NetworkError& error) {
    throw SetupError(fmt::format("cannot listen on {}: {}", to_text(options_.address), error.what()));
  }
}

Server::~Server() {
  slot_.close();
  reception_.reset();
}

/// The version is compared before the token: an old client gets a reason that helps.
void Server::admit(network::Caller& caller, std::string_view bytes) {
  wire::FromSupervisor message;
  parse(bytes, message);
  if (!message.has_hello()) throw network::NetworkError("does not begin with a Hello");
  const wire::SupervisorHello& hello = message.hello();
  if (hello.version() != protocol_version) {
    throw network::NetworkError(
        fmt::format("speaks version {} of the protocol, this program {}", hello.version(), protocol_version));
  }
  if (!network::is_token(hello.token(), options_.token)) throw network::NetworkError("does not know the token");
  supervisors_.remove_if([](const Supervisor& supervisor) { return supervisor.is_over(); });
  if (supervisors_.size() >= most_supervisors) {
    throw network::NetworkError(fmt::format("comes when {} others are there, the most that may be", most_supervisors));
  }
  const std::string name =
      fmt::format("supervisor {} at {}", control_software::printable(hello.name(), longest_name), caller.address);
  supervisors_.emplace_back(std::move(caller), name, slot_, options_);
}

void Server::reject(network::Caller& caller, const std::string& reason) {
  try {
    wire::ToSupervisor message;
    message.mutable_refused()->set_reason(reason);
    send(caller.connection, message);
  } catch (const std::exception&) {  // it has gone
  }
  if (!options_.say || told_ > most_lines) return;
  if (told_++ == most_lines) return options_.say("more supervisors were refused; they are not told of any more");
  options_.say(fmt::format("supervisor {} was refused: {}", caller.address, reason));
}

}  // namespace

std::unique_ptr<Supervision> supervise(session::Session& session, const SupervisionOptions& options) {
  return std::make_unique<Server>(session, options);
}

}  // namespace murosimf::supervise
