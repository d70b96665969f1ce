#include "murosimf/control_software/tcp/tcp_clients.h"

#include <charconv>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "murosimf/world/rate.h"

namespace murosimf::control_software {
namespace {

class SocketLine final : public ClientLine {
 public:
  explicit SocketLine(network::Connection connection) : connection_(std::move(connection)) {}
  [[nodiscard]] bool live() const override { return true; }
  void send(std::string_view message) override { connection_.send(message); }
  void flush_until(network::WallTime end) override { connection_.flush_until(end); }
  [[nodiscard]] std::optional<std::string_view> receive() override { return connection_.receive(); }
  [[nodiscard]] std::string_view receive_until(network::WallTime end) override {
    return connection_.receive_until(end);
  }
  [[nodiscard]] bool flush() override { return connection_.flush(); }

 private:
  network::Connection connection_;
};

std::optional<ArrivedClient> arrived(std::optional<TcpClient> client) {
  if (!client) return std::nullopt;
  return ArrivedClient{client->name(), client->rate, std::make_unique<SocketLine>(std::move(client->connection))};
}

}  // namespace

std::optional<ArrivedClient> ReceivedClients::wait(double limit) {
  return arrived(reception_->wait_for(robot_, limit));
}

std::optional<ArrivedClient> ReceivedClients::take() { return arrived(reception_->take(robot_)); }

class RepeatedClients::Line final : public ClientLine {
 public:
  explicit Line(std::shared_ptr<Cursor> cursor) : cursor_(std::move(cursor)) {}
  [[nodiscard]] bool live() const override { return false; }
  void send(std::string_view) override {}
  void flush_until(network::WallTime) override {}

  [[nodiscard]] std::optional<std::string_view> receive() override {
    // ends at the first note of another kind: those belong to another call (take, flush), in their recorded order
    const ExternalInput* note = cursor_->reader.next(cursor_->now);
    if (!note || note->kind == ExternalInput::came || note->kind == ExternalInput::told) return std::nullopt;
    cursor_->reader.pass();
    if (note->kind == ExternalInput::left) throw network::NetworkError(note->bytes);
    return note->bytes;
  }

  [[nodiscard]] std::string_view receive_until(network::WallTime) override {
    if (const auto bytes = receive()) return *bytes;
    throw network::NetworkError("sends nothing more: the recording ends");
  }

  [[nodiscard]] bool flush() override {
    const ExternalInput* note = cursor_->reader.next(cursor_->now);
    if (!note || note->kind != ExternalInput::told) return false;
    cursor_->reader.pass();
    return true;
  }

 private:
  std::shared_ptr<Cursor> cursor_;
};

std::optional<ArrivedClient> RepeatedClients::take() {
  const ExternalInput* note = cursor_->reader.next(cursor_->now);
  if (!note || note->kind != ExternalInput::came) return std::nullopt;
  cursor_->reader.pass();
  ArrivedClient client = arrived_client(note->bytes);
  client.line = line();
  return client;
}

std::vector<ExternalInput> RepeatedClients::jump_to(Duration now) {
  std::vector<ExternalInput> lasting;
  cursor_->reader.rewind();
  // input at `now` itself is repeated by the step, hence one nanosecond before
  for (const Duration before = now - Duration{1}; const ExternalInput* note = cursor_->reader.next(before);) {
    if (lasts(note->kind)) lasting.push_back(*note);
    cursor_->reader.pass();
  }
  return lasting;
}

std::unique_ptr<ClientLine> RepeatedClients::line() { return std::make_unique<Line>(cursor_); }

std::string to_bytes(const ArrivedClient& client) { return fmt::format("{} {}", client.rate, client.name); }

ArrivedClient arrived_client(std::string_view bytes) {
  ArrivedClient client{};
  const auto [end, error] = std::from_chars(bytes.data(), bytes.data() + bytes.size(), client.rate);
  const bool any = client.rate == 0, possible = client.rate >= slowest_rate && client.rate <= fastest_rate;
  if (error != std::errc{} || !(any || possible)) throw network::NetworkError("is recorded without its rate");
  bytes.remove_prefix(static_cast<std::size_t>(end - bytes.data()));
  constexpr std::size_t longest = 300;
  client.name = printable(bytes.substr(bytes.empty() ? 0 : 1), longest);
  return client;
}

}  // namespace murosimf::control_software
