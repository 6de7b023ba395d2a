#include "sil/live/live_server.hpp"

#include <fmt/format.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include "sil/input_error.hpp"
#include "sil/page/page_text.hpp"

namespace sil {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using tcp = asio::ip::tcp;
using Clock = std::chrono::steady_clock;

constexpr std::size_t longest_head_bytes = 8192U;
constexpr std::size_t longest_message_bytes = 1024U;
constexpr std::size_t longest_reason_bytes = 120U;  // of a closing frame: RFC 6455, 5.5
constexpr int most_connections = 32;
constexpr std::chrono::seconds longest_silence{5};
constexpr std::chrono::milliseconds one_cycle{10};
constexpr std::chrono::milliseconds longest_lag{250};
constexpr int cycles_a_message = 2;

class Server;

// The page that drives, over a WebSocket.
class DrivingPage : public std::enable_shared_from_this<DrivingPage> {
 public:
    DrivingPage(Server& server, tcp::socket socket) : server_{server}, socket_{std::move(socket)} {}

    void accept(const http::request<http::empty_body>& request);
    void offer();
    void leave(const std::string& why);

 private:
    void read();
    void write(std::string message);

    Server& server_;
    websocket::stream<beast::tcp_stream> socket_;
    beast::flat_buffer buffer_{longest_message_bytes};
    std::string message_{};
    bool open_{false};
    bool writing_{false};
};

class Server {
 public:
    // Without a session the page is all there is.
    Server(std::string page, LiveSession* session, std::uint16_t port, const std::atomic<bool>& stop)
        : page_text_{std::move(page)},
          session_{session},
          stop_{stop},
          acceptor_{context_},
          timer_{context_},
          pause_{context_} {
        const tcp::endpoint place{asio::ip::address_v4::loopback(), port};
        boost::system::error_code error;
        acceptor_.open(place.protocol());
        acceptor_.set_option(asio::socket_base::reuse_address{true});
        acceptor_.bind(place, error);
        if (!error) {
            acceptor_.listen(asio::socket_base::max_listen_connections, error);
        }
        if (error) {
            throw InputError(
                fmt::format("127.0.0.1:{} cannot be listened on: {}. Give another --port, or 0 for a "
                            "free one",
                            port, error.message()));
        }
        port_ = acceptor_.local_endpoint().port();
    }

    std::uint16_t port() const { return port_; }

    void run() {
        accept();
        next_ = Clock::now();
        tick();
        context_.run();
    }

    const std::string& page() const { return page_text_; }
    bool has_session() const { return session_ != nullptr; }
    LiveSession& session() { return *session_; }

    bool is_own_host(beast::string_view host) const {
        return host == fmt::format("127.0.0.1:{}", port_) || host == fmt::format("localhost:{}", port_);
    }
    bool is_own_origin(beast::string_view origin) const {
        constexpr beast::string_view scheme = "http://";
        return origin.starts_with(scheme) && is_own_host(origin.substr(scheme.size()));
    }

    void drive(std::shared_ptr<DrivingPage> page) {
        if (page_) {
            page_->leave("Another page drives now. Reload this one to drive here.");
        }
        page_ = std::move(page);
    }
    bool drives(const DrivingPage& page) const { return page_.get() == &page; }
    void gone(const DrivingPage& page) {
        if (drives(page)) {
            page_.reset();
        }
    }

    int connections{0};

 private:
    void accept();
    void tick();

    std::string page_text_;
    LiveSession* session_;
    const std::atomic<bool>& stop_;
    asio::io_context context_{1};
    tcp::acceptor acceptor_;
    asio::steady_timer timer_;
    asio::steady_timer pause_;  // after connections could not be taken
    std::uint16_t port_{0U};
    Clock::time_point next_{};
    int cycles_{0};
    std::shared_ptr<DrivingPage> page_{};
};

// One request, one answer.
class Visit : public std::enable_shared_from_this<Visit> {
 public:
    Visit(Server& server, tcp::socket socket) : server_{server}, stream_{std::move(socket)} {
        ++server_.connections;
        parser_.header_limit(longest_head_bytes);
        parser_.body_limit(0U);
    }
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;
    ~Visit() { --server_.connections; }

    void begin() {
        stream_.expires_after(longest_silence);
        http::async_read(stream_, buffer_, parser_,
                         [self = shared_from_this()](boost::system::error_code error, std::size_t) {
                             self->answer_to(error);
                         });
    }

 private:
    void answer_to(boost::system::error_code error) {
        if (error == http::error::header_limit || error == http::error::body_limit ||
            error == http::error::buffer_overflow) {
            answer(http::status::payload_too_large, "The request is too long.");
        } else if (error && error.category() == http::make_error_code(http::error::bad_method).category() &&
                   error != http::error::end_of_stream && error != http::error::partial_message) {
            answer(http::status::bad_request, "The request is no HTTP that is understood.");
        } else if (!error) {
            choose();
        }
    }

    void choose() {
        const auto& request = parser_.get();
        if (!server_.is_own_host(request[http::field::host])) {
            answer(http::status::forbidden, "This page is for 127.0.0.1 and localhost only.");
        } else if (websocket::is_upgrade(request)) {
            upgrade(request);
        } else if (request.method() != http::verb::get && request.method() != http::verb::head) {
            answer(http::status::method_not_allowed, "There is nothing here to change.");
        } else if (request.target() != "/") {
            answer(http::status::not_found,
                   fmt::format("There is one page here: http://127.0.0.1:{}/", server_.port()));
        } else {
            answer(http::status::ok, server_.page(), "text/html; charset=utf-8");
        }
    }

    void upgrade(const http::request<http::empty_body>& request) {
        if (!server_.is_own_origin(request[http::field::origin])) {
            answer(http::status::forbidden, "Only the page that this program serves may drive.");
        } else if (request.target() != "/drive" || !server_.has_session()) {
            answer(http::status::not_found,
                   server_.has_session() ? "The drive is at /drive." : "Nothing drives here.");
        } else {
            stream_.expires_never();
            std::make_shared<DrivingPage>(server_, stream_.release_socket())->accept(request);
        }
    }

    void answer(http::status status, std::string text, const char* type = "text/plain; charset=utf-8") {
        answer_.result(status);
        answer_.version(11U);
        answer_.keep_alive(false);
        answer_.set(http::field::content_type, type);
        answer_.set(http::field::cache_control, "no-store");
        answer_.set("Content-Security-Policy", beast::string_view{page_policy.data(), page_policy.size()});
        answer_.set("X-Content-Type-Options", "nosniff");
        answer_.set("X-Frame-Options", "DENY");
        answer_.set("Cross-Origin-Resource-Policy", "same-origin");
        answer_.body() = std::move(text);
        answer_.prepare_payload();
        if (parser_.get().method() == http::verb::head) {
            answer_.body().clear();
        }
        stream_.expires_after(longest_silence);
        http::async_write(stream_, answer_,
                          [self = shared_from_this()](boost::system::error_code, std::size_t) {
                              boost::system::error_code ignored;
                              self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
                          });
    }

    Server& server_;
    beast::tcp_stream stream_;
    beast::flat_buffer buffer_{longest_head_bytes + 1U};
    http::request_parser<http::empty_body> parser_{};
    http::response<http::string_body> answer_{};
};

void DrivingPage::accept(const http::request<http::empty_body>& request) {
    socket_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    socket_.read_message_max(longest_message_bytes);
    socket_.async_accept(request, [self = shared_from_this()](boost::system::error_code error) {
        if (error) {
            return;
        }
        self->open_ = true;
        self->server_.drive(self);
        self->write(self->server_.session().begin());
        self->read();
    });
}

void DrivingPage::read() {
    socket_.async_read(buffer_, [self = shared_from_this()](boost::system::error_code error, std::size_t) {
        if (error || !self->open_) {
            self->open_ = false;
            self->server_.gone(*self);
            return;
        }
        try {
            self->server_.session().take(beast::buffers_to_string(self->buffer_.data()));
            self->buffer_.clear();
            self->read();
        } catch (const InputError& refused) {
            self->server_.gone(*self);
            self->leave(refused.what());
        }
    });
}

// A page that is slow gets fewer and longer messages; nothing piles up here.
void DrivingPage::offer() {
    if (open_ && !writing_) {
        std::string news = server_.session().news();
        if (!news.empty()) {
            write(std::move(news));
        }
    }
}

void DrivingPage::write(std::string message) {
    message_ = std::move(message);
    writing_ = true;
    socket_.text(true);
    socket_.async_write(asio::buffer(message_),
                        [self = shared_from_this()](boost::system::error_code error, std::size_t) {
                            self->writing_ = false;
                            if (error) {
                                self->open_ = false;
                                self->server_.gone(*self);
                            }
                        });
}

void DrivingPage::leave(const std::string& why) {
    open_ = false;
    const websocket::close_reason reason{websocket::close_code::policy_error,
                                         why.substr(0U, longest_reason_bytes)};
    socket_.async_close(reason, [self = shared_from_this()](boost::system::error_code) {});
}

void Server::accept() {
    acceptor_.async_accept([this](boost::system::error_code error, tcp::socket socket) {
        if (error) {  // such as too many open files: later there may be fewer
            pause_.expires_after(one_cycle);
            pause_.async_wait([this](boost::system::error_code) { accept(); });
            return;
        }
        if (connections < most_connections) {
            std::make_shared<Visit>(*this, std::move(socket))->begin();
        }
        accept();
    });
}

void Server::tick() {
    const Clock::time_point now = Clock::now();
    if (now - next_ > longest_lag) {
        next_ = now;
    }
    while (next_ <= now) {
        if (session_ != nullptr) {
            session_->cycle();
        }
        next_ += one_cycle;
        ++cycles_;
    }
    if (page_ && cycles_ >= cycles_a_message) {
        cycles_ = 0;
        page_->offer();
    }
    if (stop_) {
        context_.stop();
        return;
    }
    timer_.expires_at(next_);
    timer_.async_wait([this](boost::system::error_code) { tick(); });
}

}  // namespace

void serve_live(LiveSession& session, std::uint16_t port, const std::atomic<bool>& stop,
                const std::function<void(std::uint16_t)>& listening) {
    Server server{std::string{live_page}, &session, port, stop};
    listening(server.port());
    server.run();
}

void serve_page(const std::string& page, std::uint16_t port, const std::atomic<bool>& stop,
                const std::function<void(std::uint16_t)>& listening) {
    Server server{page, nullptr, port, stop};
    listening(server.port());
    server.run();
}

}  // namespace sil
