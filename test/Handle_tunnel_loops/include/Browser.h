#ifndef HTL_TEST_BROWSER_H
#define HTL_TEST_BROWSER_H

#include "Decoded_png.h"
#include "Temporary_folder.h"

#include <nlohmann/json.hpp>

#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

// A Chromium without a window that is told what to do through its debugging pipe, as by a person
// with a mouse. It has no network.
class Browser
{
public:
  using Json = nlohmann::json;

  // The program, or nothing where there is none.
  static std::string program() {
    const char* path = std::getenv("PATH");
    for(const char* name : {"chromium", "chromium-browser", "google-chrome"})
      for(std::string folders = path == nullptr ? "" : path; !folders.empty();) {
        const std::size_t end = folders.find(':');
        const std::string file = folders.substr(0, end) + "/" + name;
        if(::access(file.c_str(), X_OK) == 0)
          return file;
        folders = end == std::string::npos ? "" : folders.substr(end + 1);
      }
    return "";
  }

  Browser(int width, int height) {
    std::signal(SIGPIPE, SIG_IGN);
    start(width, height);
    const std::string target = send("Target.createTarget", {{"url", "about:blank"}})["targetId"];
    session_ =
        send("Target.attachToTarget", {{"targetId", target}, {"flatten", true}})["sessionId"];
    for(const char* domain : {"Page.enable", "Runtime.enable", "Log.enable", "Network.enable"})
      send(domain);
    send("Emulation.setDeviceMetricsOverride",
         {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}});
  }

  ~Browser() {
    ::close(to_browser_);
    ::close(from_browser_);
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }

  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  // Opens a file, and waits until an expression is true.
  void open(const std::string& file, const std::string& is_ready) {
    errors.clear();
    requests.clear();
    send("Page.navigate", {{"url", "file://" + file}});
    wait_until(is_ready);
  }

  void wait_until(const std::string& expression) {
    const auto began = std::chrono::steady_clock::now();
    while(evaluate(expression) != true) {
      if(std::chrono::steady_clock::now() - began > std::chrono::seconds(60))
        throw std::runtime_error("in vain: " + expression +
                                 (errors.empty() ? "" : ": " + errors[0]));
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  // The value of an expression, or of what it promises.
  Json evaluate(const std::string& expression) {
    const Json answer =
        send("Runtime.evaluate",
             {{"expression", expression}, {"returnByValue", true}, {"awaitPromise", true}});
    if(answer.contains("exceptionDetails"))
      throw std::runtime_error(expression + ": " + answer["exceptionDetails"].dump());
    return answer["result"].value("value", Json());
  }

  Decoded_png screenshot() {
    evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))");
    const std::string text = send("Page.captureScreenshot", {{"format", "png"}})["data"];
    return decoded_png(from_base64(text));
  }

  void move_mouse(double x, double y, bool is_down) {
    mouse("mouseMoved", x, y, is_down ? "left" : "none");
  }
  void press(double x, double y) { mouse("mousePressed", x, y, "left"); }
  void release(double x, double y) { mouse("mouseReleased", x, y, "left"); }

  void click(double x, double y) {
    move_mouse(x, y, false);
    press(x, y);
    release(x, y);
  }

  /// a part of a gesture: "touchStart", "touchMove" or "touchEnd", and where fingers are then.
  void touch(const char* type, const std::vector<std::array<double, 2>>& fingers) {
    Json points = Json::array();
    for(std::size_t i = 0; i < fingers.size(); ++i)
      points.push_back({{"x", fingers[i][0]}, {"y", fingers[i][1]}, {"id", i}});
    send("Input.dispatchTouchEvent", {{"type", type}, {"touchPoints", points}});
  }

  void key(const std::string& name) {
    Json event = {{"type", "keyDown"}, {"key", name}};
    if(name.size() == 1)
      event["text"] = name;
    send("Input.dispatchKeyEvent", event);
    send("Input.dispatchKeyEvent", {{"type", "keyUp"}, {"key", name}});
  }

  std::vector<std::string> errors;   // what the console shows of errors since the page was opened
  std::vector<std::string> requests; // addresses asked for since then

private:
  void start(int width, int height) {
    std::array<int, 2> there, back;
    if(::pipe(there.data()) != 0 || ::pipe(back.data()) != 0)
      throw std::runtime_error("no pipes");
    process_ = ::fork();
    if(process_ == 0) {
      // The browser reads from 3 and writes to 4; the ends may have these numbers already.
      const int in = ::fcntl(there[0], F_DUPFD, 10), out = ::fcntl(back[1], F_DUPFD, 10);
      ::dup2(in, 3);
      ::dup2(out, 4);
      const int nothing = ::open("/dev/null", O_RDWR);
      for(const int file : {0, 1, 2})
        ::dup2(nothing, file);
      for(int file = 5; file < 256; ++file)
        ::close(file);
      run(width, height);
    }
    ::close(there[0]);
    ::close(back[1]);
    to_browser_ = there[1];
    from_browser_ = back[0];
  }

  [[noreturn]] void run(int width, int height) {
    std::vector<std::string> words = {program(),
                                      "--headless=new",
                                      "--no-sandbox",
                                      "--remote-debugging-pipe",
                                      "--user-data-dir=" + profile_.path("profile"),
                                      "--use-angle=swiftshader",
                                      "--enable-unsafe-swiftshader",
                                      "--hide-scrollbars",
                                      "--no-first-run",
                                      "--disable-extensions",
                                      "--disable-background-networking",
                                      "--disable-dev-shm-usage",
                                      "--window-size=" + std::to_string(width) + "," +
                                          std::to_string(height)};
    std::vector<char*> arguments;
    for(std::string& word : words)
      arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::execv(arguments[0], arguments.data());
    ::_exit(127);
  }

  Json send(const std::string& method, const Json& parameters = Json::object()) {
    Json message = {{"id", ++last_id_}, {"method", method}, {"params", parameters}};
    if(!session_.empty())
      message["sessionId"] = session_;
    const std::string text = message.dump();
    write(text.c_str(), text.size() + 1); // with the zero at its end
    for(;;) {
      const Json answer = Json::parse(next_message());
      if(answer.value("id", 0) != last_id_) {
        note(answer);
        continue;
      }
      if(answer.contains("error"))
        throw std::runtime_error(method + ": " + answer["error"].dump());
      return answer["result"];
    }
  }

  void note(const Json& event) {
    const std::string method = event.value("method", "");
    const Json parameters = event.value("params", Json::object());
    if(method == "Runtime.exceptionThrown" ||
       (method == "Log.entryAdded" && parameters["entry"]["level"] == "error") ||
       (method == "Runtime.consoleAPICalled" && parameters["type"] == "error"))
      errors.push_back(parameters.dump());
    else if(method == "Network.requestWillBeSent")
      requests.push_back(parameters["request"]["url"]);
  }

  void write(const char* text, std::size_t size) {
    while(size > 0) {
      const ssize_t written = ::write(to_browser_, text, size);
      if(written <= 0)
        throw std::runtime_error("the browser is gone");
      text += written;
      size -= static_cast<std::size_t>(written);
    }
  }

  std::string next_message() {
    for(;;) {
      if(const std::size_t end = received_.find('\0'); end != std::string::npos) {
        const std::string message = received_.substr(0, end);
        received_.erase(0, end + 1);
        return message;
      }
      pollfd waiting = {from_browser_, POLLIN, 0};
      if(::poll(&waiting, 1, 120000) <= 0)
        throw std::runtime_error("the browser does not answer");
      std::array<char, 65536> part;
      const ssize_t size = ::read(from_browser_, part.data(), part.size());
      if(size <= 0)
        throw std::runtime_error("the browser is gone");
      received_.append(part.data(), static_cast<std::size_t>(size));
    }
  }

  void mouse(const char* type, double x, double y, const char* button) {
    send("Input.dispatchMouseEvent", {{"type", type},
                                      {"x", x},
                                      {"y", y},
                                      {"button", button},
                                      {"clickCount", 1},
                                      {"buttons", std::string(button) == "left" ? 1 : 0}});
  }

  static std::string from_base64(const std::string& text) {
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for(const char c : text) {
      const unsigned value = c >= 'A' && c <= 'Z'   ? c - 'A'
                             : c >= 'a' && c <= 'z' ? c - 'a' + 26
                             : c >= '0' && c <= '9' ? c - '0' + 52
                             : c == '+'             ? 62
                                                    : 63;
      if(c == '=')
        break;
      bits = bits << 6 | value;
      if((count += 6) >= 8) {
        count -= 8;
        bytes += static_cast<char>(bits >> count & 255u);
      }
    }
    return bytes;
  }

  const Temporary_folder profile_;
  pid_t process_ = -1;
  int to_browser_ = -1, from_browser_ = -1, last_id_ = 0;
  std::string session_, received_;
};

#endif // HTL_TEST_BROWSER_H
