#include "tests/gateway/client.h"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <stdexcept>

namespace tacit::gateway {
namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using beast::error_code;

namespace {

auto duration(double s) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(s));
}

asio::ip::tcp::endpoint server_at(std::uint16_t port) {
  return {asio::ip::make_address("127.0.0.1"), port};
}

std::string lower(std::string text) {
  for (char& c : text) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return text;
}

}  // namespace

Reply ask(std::uint16_t port, const Ask& ask) {
  asio::io_context io;
  beast::tcp_stream stream(io);
  stream.connect(server_at(port));
  http::request<http::string_body> request;
  request.method_string(ask.method);
  request.target(ask.target);
  request.version(11);
  request.set(http::field::host, "localhost:" + std::to_string(port));
  for (const auto& [name, value] : ask.headers) {
    request.set(name, value);
  }
  request.body() = ask.body;
  request.prepare_payload();
  error_code written;
  http::write(stream, request, written);  // The server may have refused before it read all.
  http::response_parser<http::string_body> parser;
  parser.skip(ask.method == "HEAD");
  parser.body_limit(1U << 30U);
  beast::flat_buffer buffer;
  error_code read = asio::error::timed_out;
  http::async_read(stream, buffer, parser, [&](error_code ec, std::size_t) { read = ec; });
  io.run_for(duration(5.0));
  if (read) {
    throw std::runtime_error(ask.method + ' ' + ask.target + ": " + read.message());
  }
  Reply reply{static_cast<int>(parser.get().result_int()), {}, parser.get().body()};
  for (const auto& field : parser.get()) {
    reply.headers[lower(std::string(field.name_string()))] = std::string(field.value());
  }
  return reply;
}

Reply get(std::uint16_t port, const std::string& target, const Fields& headers) {
  return ask(port, {.target = target, .headers = headers});
}

std::optional<std::string> raw(std::uint16_t port, std::string_view bytes, double within_s) {
  return raw(port, bytes, {}, within_s);
}

std::optional<std::string> raw(std::uint16_t port, std::string_view bytes, std::string_view then,
                               double within_s) {
  asio::io_context io;
  asio::ip::tcp::socket socket(io);
  socket.connect(server_at(port));
  error_code ec;
  asio::write(socket, asio::buffer(bytes.data(), bytes.size()), ec);
  std::string all;
  std::array<char, 4096> some{};
  bool closed = false;
  const std::function<void()> read = [&] {
    socket.async_read_some(asio::buffer(some), [&](error_code failed, std::size_t size) {
      all.append(some.data(), size);
      if (!then.empty() && all.find("\r\n\r\n") != std::string::npos) {
        asio::write(socket, asio::buffer(then.data(), then.size()), ec);
        then = {};
      }
      closed = static_cast<bool>(failed);
      if (!closed) {
        read();
      }
    });
  };
  read();
  io.run_for(duration(within_s));
  return closed ? std::optional(all) : std::nullopt;
}

template <typename Start>
error_code Socket::run(Start start, double within_s) {
  error_code result = asio::error::timed_out;
  start([&result](error_code ec, auto...) { result = ec; });
  io_.restart();
  io_.run_for(duration(within_s));
  return result;
}

Socket::Socket(std::uint16_t port, const std::string& target, const std::string& protocols,
               const Fields& headers)
    : stream_(io_) {
  beast::get_lowest_layer(stream_).connect(server_at(port));
  stream_.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
    if (!protocols.empty()) {
      request.set(http::field::sec_websocket_protocol, protocols);
    }
    for (const auto& [name, value] : headers) {
      request.set(name, value);
    }
  }));
  stream_.read_message_max(0);
  websocket::response_type response;
  const error_code failed = run([&](auto done) {
    stream_.async_handshake(response, "localhost:" + std::to_string(port), target, done);
  });
  if (failed) {
    throw std::runtime_error("no WebSocket: " + std::to_string(response.result_int()));
  }
  protocol_ = std::string(response[http::field::sec_websocket_protocol]);
}

Socket::~Socket() = default;

void Socket::say(const nlohmann::json& message) { say_text(message.dump()); }

void Socket::say_text(const std::string& text) {
  stream_.text(true);
  if (run([&](auto done) { stream_.async_write(asio::buffer(text), done); })) {
    throw std::runtime_error("cannot say anything");
  }
}

void Socket::say_binary(const std::string& bytes) {
  stream_.binary(true);
  if (run([&](auto done) { stream_.async_write(asio::buffer(bytes), done); })) {
    throw std::runtime_error("cannot say anything");
  }
}

Socket::Message Socket::next() {
  buffer_.clear();
  if (const error_code ec = run([&](auto done) { stream_.async_read(buffer_, done); })) {
    throw std::runtime_error("nothing to hear: " + ec.message());
  }
  return {stream_.got_binary(), beast::buffers_to_string(buffer_.cdata())};
}

nlohmann::json Socket::next(const std::string& op) {
  while (true) {
    const Message message = next();
    if (!message.binary && message.json().at("op") == op) {
      return message.json();
    }
  }
}

std::string Socket::next_binary(char opcode) {
  while (true) {
    const Message message = next();
    if (message.binary && message.bytes.at(0) == opcode) {
      return message.bytes;
    }
  }
}

bool Socket::is_quiet(double for_s) {
  buffer_.clear();
  // A read that was begun cannot be taken back: the socket is of no use afterwards.
  return run([&](auto done) { stream_.async_read(buffer_, done); }, for_s) ==
         asio::error::timed_out;
}

int Socket::close_code() {
  error_code ec;
  while (!ec) {
    buffer_.clear();
    ec = run([&](auto done) { stream_.async_read(buffer_, done); });
  }
  if (ec == asio::error::timed_out) {
    throw std::runtime_error("the server does not close");
  }
  return ec == websocket::error::closed ? stream_.reason().code : 0;
}

void Socket::vanish() { beast::get_lowest_layer(stream_).socket().close(); }

std::uint64_t number_at(const std::string& bytes, std::size_t at, std::size_t size) {
  std::uint64_t number = 0;
  for (std::size_t i = size; i-- > 0;) {
    number = number << 8U | static_cast<unsigned char>(bytes.at(at + i));
  }
  return number;
}

std::string little(std::uint64_t number, std::size_t size) {
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i) {
    bytes += static_cast<char>(number >> (8U * i) & 0xffU);
  }
  return bytes;
}

std::string service_request(std::uint32_t service, std::uint32_t call, const std::string& json) {
  return '\x02' + little(service, 4) + little(call, 4) + little(4, 4) + "json" + json;
}

}  // namespace tacit::gateway
