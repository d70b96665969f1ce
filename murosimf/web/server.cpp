#include "murosimf/web/server.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <exception>
#include <thread>

#include <libwebsockets.h>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::web {
namespace {

/// Per-session memory of libwebsockets, one for each connection; zeroed at the beginning.
struct Client {
  Conversation* conversation;
  std::string* incoming;  // message received in parts
  const Answer* answer;   // to a GET
};

std::string header(lws* wsi, lws_token_indexes token) {
  const int length = lws_hdr_total_length(wsi, token);
  if (length <= 0) return {};
  std::string text(static_cast<std::size_t>(length) + 1, '\0');
  const int copied = lws_hdr_copy(wsi, text.data(), length + 1, token);
  text.resize(copied > 0 ? static_cast<std::size_t>(copied) : 0);
  return text;
}

Visitor visitor_of(lws* wsi) {
  constexpr std::string_view key = "token=";
  Visitor visitor{.host = header(wsi, WSI_TOKEN_HOST), .origin = header(wsi, WSI_TOKEN_ORIGIN), .token = {}};
  std::array<char, 128> argument{};
  for (int i = 0; lws_hdr_copy_fragment(wsi, argument.data(), argument.size(), WSI_TOKEN_HTTP_URI_ARGS, i) >= 0; ++i) {
    const std::string_view text(argument.data());
    if (text.starts_with(key)) visitor.token = text.substr(key.size());
  }
  return visitor;
}

void close_with(lws* wsi, lws_close_status status, std::string_view why) {
  std::array<unsigned char, 120> bytes{};  // a close frame has at most 125
  const std::size_t size = std::min(why.size(), bytes.size());
  std::memcpy(bytes.data(), why.data(), size);
  lws_close_reason(wsi, status, bytes.data(), size);
}

constexpr unsigned most_connections = 256;  // including those without a request yet

/// No other page may embed this one in a frame, where users could be tricked into clicking; and this page loads nothing of others.
constexpr std::string_view page_policy =
    "frame-ancestors 'none'; base-uri 'none'; form-action 'none'; object-src 'none'";

constexpr std::string_view wrong_token = "This needs the whole address that was printed, with its token.\n";

}  // namespace

struct Server::Inside {
  explicit Inside(Options what);
  ~Inside();
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;

  static int on_event(lws* wsi, lws_callback_reasons reason, void* user, void* in, std::size_t length);
  int handle(lws* wsi, lws_callback_reasons reason, Client* client, std::string_view bytes);
  int get(lws* wsi, Client& client, std::string_view path);
  int send_page(lws* wsi, Client& client);
  int open(lws* wsi, Client& client);
  int receive(lws* wsi, Client& client, std::string_view bytes);
  int send_next(lws* wsi, Client& client);
  void close(lws* wsi, Client& client);

  static void on_time(lws_sorted_usec_list_t* timer);
  void tick();
  void serve();

  Options options;
  AccessRules rules;
  network::Socket listener;
  network::Address address;
  std::vector<lws_protocols> protocols;
  lws_context* context = nullptr;
  struct Timer {
    lws_sorted_usec_list_t list{};  // first member: libwebsockets passes its address back
    Inside* owner = nullptr;
  } timer;
  std::vector<std::pair<lws*, Client*>> open_clients;
  std::vector<char> scratch;
  std::atomic<int> count{0};
  std::atomic<bool> ends{false};
  std::thread thread;
};

Server::Inside::Inside(Options what) : options(std::move(what)) {
  try {
    listener = network::Socket::listen(options.address);
    address = listener.own_address();
  } catch (const network::NetworkError& error) {
    throw SetupError(fmt::format("{}: {}", to_text(options.address), error.what()));
  }
  rules = {.loopback =
               is_loopback(address.host.find(':') == std::string::npos ? address.host : "[" + address.host + "]"),
           .token = options.token};
  lws_protocols protocol{};
  protocol.callback = on_event;
  protocol.per_session_data_size = sizeof(Client);
  protocol.rx_buffer_size = 64 * 1024;
  protocol.name = "http";  // also used for WebSockets without a protocol, which are refused
  protocols.push_back(protocol);
  for (const auto& [name, make] : options.protocols) {
    protocol.name = name.c_str();
    protocols.push_back(protocol);
  }
  protocols.push_back({});
  lws_set_log_level(0, nullptr);
  lws_context_creation_info info{};
  info.port = CONTEXT_PORT_NO_LISTEN_SERVER;  // connections are accepted here, and passed on
  info.protocols = protocols.data();
  info.user = this;
  info.gid = static_cast<decltype(info.gid)>(-1);
  info.uid = static_cast<decltype(info.uid)>(-1);
  info.fd_limit_per_thread = most_connections;
  context = lws_create_context(&info);
  if (!context) throw SetupError(fmt::format("{}: the server cannot start", to_text(address)));
  timer.owner = this;
  thread = std::thread([this] { serve(); });
}

Server::Inside::~Inside() {
  ends = true;
  if (context) lws_cancel_service(context);
  if (thread.joinable()) thread.join();
  if (context) lws_context_destroy(context);
}

void Server::Inside::serve() {
  tick();
  while (!ends && lws_service(context, 0) >= 0) {
  }
}

void Server::Inside::on_time(lws_sorted_usec_list_t* list) { reinterpret_cast<Timer*>(list)->owner->tick(); }

void Server::Inside::tick() {
  try {
    for (network::Socket socket = listener.accept(); socket.is_open(); socket = listener.accept()) {
      if (lws_adopt_socket(context, socket.release()) == nullptr) break;  // it closes the socket
    }
  } catch (const network::NetworkError&) {  // the client has disconnected, or there are too many
  }
  if (options.look) options.look();
  for (const auto& [wsi, client] : open_clients) {
    client->conversation->look();
    if (!client->conversation->outbox.empty()) lws_callback_on_writable(wsi);
  }
  lws_sul_schedule(context, 0, &timer.list, on_time,
                   static_cast<lws_usec_t>(std::chrono::microseconds(options.period).count()));
}

int Server::Inside::on_event(lws* wsi, lws_callback_reasons reason, void* user, void* in, std::size_t length) {
  auto* self = static_cast<Inside*>(lws_context_user(lws_get_context(wsi)));
  try {
    return self->handle(wsi, reason, static_cast<Client*>(user), {static_cast<const char*>(in), in ? length : 0});
  } catch (const std::exception&) {  // out of memory, or an error of this client
    return -1;
  }
}

/// Rules of entry are checked before a conversation is made.
int Server::Inside::handle(lws* wsi, lws_callback_reasons reason, Client* client, std::string_view bytes) {
  switch (reason) {
    case LWS_CALLBACK_HTTP: return get(wsi, *client, bytes);
    case LWS_CALLBACK_HTTP_WRITEABLE: return send_page(wsi, *client);
    case LWS_CALLBACK_HTTP_CONFIRM_UPGRADE:
      if (may_enter(rules, visitor_of(wsi)) && count < most_clients) return 0;
      return lws_return_http_status(wsi, HTTP_STATUS_FORBIDDEN, wrong_token.data()) != 0 ? -1 : 1;
    case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION: return lws_get_protocol(wsi) == &protocols.front() ? -1 : 0;
    case LWS_CALLBACK_ESTABLISHED: return open(wsi, *client);
    case LWS_CALLBACK_RECEIVE: return receive(wsi, *client, bytes);
    case LWS_CALLBACK_SERVER_WRITEABLE: return send_next(wsi, *client);
    case LWS_CALLBACK_CLOSED: close(wsi, *client); return 0;
    default: return 0;
  }
}

/// Only known paths are answered: the server has no access to files.
int Server::Inside::get(lws* wsi, Client& client, std::string_view path) {
  const auto refuse = [&](unsigned status, const char* why) {
    return lws_return_http_status(wsi, status, why) != 0 || lws_http_transaction_completed(wsi) != 0 ? -1 : 0;
  };
  if (lws_hdr_total_length(wsi, WSI_TOKEN_GET_URI) <= 0) return refuse(HTTP_STATUS_METHOD_NOT_ALLOWED, "GET only\n");
  if (!may_enter(rules, visitor_of(wsi))) return refuse(HTTP_STATUS_FORBIDDEN, wrong_token.data());
  for (const auto& [name, answer] : options.pages) {
    if (name != path) continue;
    client.answer = &answer;
    std::array<unsigned char, LWS_PRE + 2048> head{};
    unsigned char *begin = head.data() + LWS_PRE, *at = begin, *end = head.data() + head.size();
    const auto add = [&](const char* key, std::string_view value) {
      return lws_add_http_header_by_name(wsi, reinterpret_cast<const unsigned char*>(key),
                                         reinterpret_cast<const unsigned char*>(value.data()),
                                         static_cast<int>(value.size()), &at, end) != 0;
    };
    if (lws_add_http_common_headers(wsi, HTTP_STATUS_OK, answer.type.c_str(), answer.bytes.size(), &at, end) != 0 ||
        (answer.gzip && add("content-encoding:", "gzip")) || add("cache-control:", "no-store") ||
        add("content-security-policy:", page_policy) || add("x-frame-options:", "DENY") ||
        add("cross-origin-resource-policy:", "same-origin") || add("x-content-type-options:", "nosniff") ||
        add("referrer-policy:", "no-referrer") || lws_finalize_write_http_header(wsi, begin, &at, end) != 0) {
      return -1;
    }
    lws_callback_on_writable(wsi);
    return 0;
  }
  return refuse(HTTP_STATUS_NOT_FOUND, "There is only one page here: /\n");
}

/// The library needs room in front of the bytes for its header.
int Server::Inside::send_page(lws* wsi, Client& client) {
  if (!client.answer) return -1;
  const std::string_view bytes = client.answer->bytes;
  client.answer = nullptr;
  scratch.assign(LWS_PRE, '\0');
  scratch.insert(scratch.end(), bytes.begin(), bytes.end());
  auto* data = reinterpret_cast<unsigned char*>(scratch.data() + LWS_PRE);
  if (lws_write(wsi, data, bytes.size(), LWS_WRITE_HTTP_FINAL) < 0) return -1;
  return lws_http_transaction_completed(wsi) != 0 ? -1 : 0;
}

int Server::Inside::open(lws* wsi, Client& client) {
  const std::string_view name = lws_get_protocol(wsi)->name;
  for (const auto& [protocol, make] : options.protocols) {
    if (protocol == name) client.conversation = make().release();
  }
  if (!client.conversation) return -1;
  client.incoming = new std::string;
  open_clients.emplace_back(wsi, &client);
  ++count;
  lws_callback_on_writable(wsi);
  return 0;
}

/// Messages come in fragments; a message that is too long ends the connection.
int Server::Inside::receive(lws* wsi, Client& client, std::string_view bytes) {
  MUROSIMF_ASSERT(client.conversation != nullptr && client.incoming != nullptr);
  if (lws_is_first_fragment(wsi) != 0) client.incoming->clear();
  if (client.incoming->size() + bytes.size() > longest_message) {
    close_with(wsi, LWS_CLOSE_STATUS_MESSAGE_TOO_LARGE, "messages have at most 1 MB");
    return -1;
  }
  *client.incoming += bytes;
  if (lws_is_final_fragment(wsi) == 0) return 0;
  try {
    client.conversation->receive(*client.incoming, lws_frame_is_binary(wsi) != 0);
  } catch (const ClientError& error) {
    close_with(wsi, LWS_CLOSE_STATUS_POLICY_VIOLATION, error.what());
    return -1;
  }
  client.incoming->clear();
  if (!client.conversation->outbox.empty()) lws_callback_on_writable(wsi);
  return 0;
}

int Server::Inside::send_next(lws* wsi, Client& client) {
  MUROSIMF_ASSERT(client.conversation != nullptr);
  Outbox& outbox = client.conversation->outbox;
  if (outbox.waiting_bytes() > most_waiting) return -1;  // it sends requests and does not read the answers
  const std::optional<Message> message = outbox.take();
  if (!message) return 0;
  MUROSIMF_ASSERT(message->bytes != nullptr);
  scratch.assign(LWS_PRE, '\0');
  scratch.insert(scratch.end(), message->bytes->begin(), message->bytes->end());
  auto* data = reinterpret_cast<unsigned char*>(scratch.data() + LWS_PRE);
  const auto kind = message->binary ? LWS_WRITE_BINARY : LWS_WRITE_TEXT;
  if (lws_write(wsi, data, message->bytes->size(), kind) < 0) return -1;
  if (!outbox.empty()) lws_callback_on_writable(wsi);  // called when the system has room again
  return 0;
}

void Server::Inside::close(lws* wsi, Client& client) {
  if (std::erase_if(open_clients, [&](const auto& one) { return one.first == wsi; }) > 0) --count;
  delete client.conversation;
  delete client.incoming;
  client = {};
}

Server::Server(Options options) : inside_(std::make_unique<Inside>(std::move(options))) {}
Server::~Server() = default;
const network::Address& Server::address() const { return inside_->address; }
int Server::clients() const { return inside_->count; }

}  // namespace murosimf::web
