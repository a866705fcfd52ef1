#include "page_server.hpp"

#include <httplib.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <streambuf>
#include <thread>

#include "page.hpp"

namespace discmc::command {
namespace {

constexpr const char* own_address = "127.0.0.1";

// What is written to it is sent; it fails when the client is gone, and when the server stops.
class Sending : public std::streambuf {
 public:
  Sending(httplib::DataSink& sink, const std::atomic<bool>& is_stopping)
      : sink_(sink), is_stopping_(is_stopping) {}

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    const bool is_sent = !is_stopping_ && sink_.write(bytes, static_cast<std::size_t>(count));
    return is_sent ? count : 0;
  }
  int sync() override { return !is_stopping_ && sink_.is_writable() ? 0 : -1; }

 private:
  httplib::DataSink& sink_;
  const std::atomic<bool>& is_stopping_;
};

class Server {
 public:
  explicit Server(const ServedFile& file)
      : file_(file), page_(served_page(file.name, "data", file.is_live)) {
    constexpr int pages = 64;  // each of them may wait for more of its file
    constexpr int longest_wait_s = 60;
    server_.new_task_queue = [] { return new httplib::ThreadPool(pages); };
    server_.set_keep_alive_max_count(1);
    server_.set_write_timeout(longest_wait_s);
    // The library's own options let another program of the user take the same port.
    server_.set_socket_options([](socket_t socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server_.set_default_headers({{"X-Content-Type-Options", "nosniff"},
                                 {"Cross-Origin-Resource-Policy", "same-origin"},
                                 {"Content-Security-Policy", "frame-ancestors 'none'"},
                                 {"Cache-Control", "no-store"}});
    server_.set_pre_routing_handler(refuse);
    server_.Get("/", [this](const httplib::Request&, httplib::Response& response) {
      send(response, "text/html; charset=utf-8", page_.size(),
           [this](std::ostream& out) { out << page_; });
    });
    server_.Get("/data", [this](const httplib::Request&, httplib::Response& response) {
      send(response, "application/octet-stream", file_.bytes, file_.write);
    });
  }

  int bind(std::uint16_t port) {
    if (port == 0) return server_.bind_to_any_port(own_address);
    return server_.bind_to_port(own_address, port) ? port : -1;
  }

  void serve_until_signal(const sigset_t& signals) {
    std::thread thread([this] { server_.listen_after_bind(); });
    int signal = 0;
    sigwait(&signals, &signal);
    is_stopping_ = true;
    while (!server_.is_running()) std::this_thread::yield();
    end_soon();
    server_.stop();
    thread.join();
  }

 private:
  // A client that neither takes nor sends would hold up the end for as long as it likes.
  static void end_soon() {
    std::thread([] {
      constexpr std::chrono::seconds patience(1);
      std::this_thread::sleep_for(patience);
      std::_Exit(EXIT_SUCCESS);
    }).detach();
  }

  // A site whose name leads here sends that name (DNS rebinding). No part of a file is sent, so
  // that no decoder starts in its middle.
  static httplib::Server::HandlerResponse refuse(const httplib::Request& request,
                                                 httplib::Response& response) {
    const std::string host = request.get_header_value("Host");
    const std::string name = host.substr(0, host.rfind(':'));
    if (name != own_address && name != "localhost")
      response.status = 403;
    else if (request.method != "GET")
      response.status = 405;
    else if (!request.ranges.empty())
      response.status = 416;
    else
      return httplib::Server::HandlerResponse::Unhandled;
    return httplib::Server::HandlerResponse::Handled;
  }

  // By a provider in any case: what is not one the library would compress.
  void send(httplib::Response& response, const char* type, std::optional<std::uint64_t> bytes,
            const std::function<void(std::ostream&)>& write) {
    const auto provide = [this, write](httplib::DataSink& sink) {
      Sending sending(sink, is_stopping_);
      std::ostream out(&sending);
      out.exceptions(std::ios::badbit | std::ios::failbit);
      try {
        write(out);
        return true;
      } catch (const std::ios_base::failure&) {
        // The page is gone.
      } catch (const std::exception& error) {
        std::cerr << "discmc: " << error.what() << '\n';
      }
      return false;
    };
    if (bytes)
      response.set_content_provider(
          *bytes, type,
          [provide](std::size_t, std::size_t, httplib::DataSink& sink) { return provide(sink); });
    else
      response.set_chunked_content_provider(type, [provide](std::size_t, httplib::DataSink& sink) {
        const bool is_whole = provide(sink);
        if (is_whole) sink.done();
        return is_whole;
      });
  }

  const ServedFile& file_;
  std::string page_;
  std::atomic<bool> is_stopping_{false};
  httplib::Server server_;
};

}  // namespace

void serve_page(const ServedFile& file, std::uint16_t port,
                const std::function<void(const std::string& address)>& started) {
  Server server(file);
  const int bound = server.bind(port);
  if (bound < 0)
    throw std::runtime_error("port " + std::to_string(port) +
                             " is in use; give another --port, or leave it out for any free port");
  // Blocked before there are threads, which then have them blocked, too.
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM}) sigaddset(&signals, signal);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  started(std::string("http://") + own_address + ':' + std::to_string(bound) + '/');
  server.serve_until_signal(signals);
}

}  // namespace discmc::command
