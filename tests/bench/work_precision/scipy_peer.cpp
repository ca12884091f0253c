#include "tests/bench/work_precision/scipy_peer.hpp"

#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

namespace stationary::bench {
namespace {

using Json = nlohmann::json;

std::vector<Vector4<double>> states_of(const Json& answer) {
  std::vector<Vector4<double>> out;
  for (const Json& q : answer) {
    out.push_back(q.is_null() ? Vector4<double>::Constant(std::numeric_limits<double>::quiet_NaN())
                              : Vector4<double>(q.at(0), q.at(1), q.at(2), q.at(3)));
  }
  return out;
}

}  // namespace

/// One socket is the child's standard input and output.
struct ScipyPeer::Child {
  ::pid_t process = 0;
  int socket = -1;
  std::string unread;
};

ScipyPeer::ScipyPeer(const std::string& script) : child_(std::make_unique<Child>()) {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::system_error(errno, std::generic_category(), "a socket");
  child_->socket = ends[0];
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_adddup2(&streams, ends[1], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&streams, ends[1], STDOUT_FILENO);
  std::string program = "python3";
  std::string path = script;
  char* const arguments[] = {program.data(), path.data(), nullptr};
  const int reason =
      ::posix_spawnp(&child_->process, program.c_str(), &streams, nullptr, arguments, ::environ);
  posix_spawn_file_actions_destroy(&streams);
  ::close(ends[1]);
  if (reason != 0) {
    child_->process = 0;
    return;
  }
  const std::string greeting = line();
  if (!greeting.empty()) versions_ = Json::parse(greeting).get<decltype(versions_)>();
}

ScipyPeer::~ScipyPeer() {
  ::close(child_->socket);  // the end of its input, and with that its own
  if (child_->process != 0) ::waitpid(child_->process, nullptr, 0);
}

/// The next line; empty where the child has ended.
std::string ScipyPeer::line() {
  std::string& unread = child_->unread;
  for (;;) {
    if (const auto end = unread.find('\n'); end != std::string::npos) {
      std::string out = unread.substr(0, end);
      unread.erase(0, end + 1);
      return out;
    }
    char block[65536];
    const ::ssize_t count = ::recv(child_->socket, block, sizeof block, 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return "";
    unread.append(block, static_cast<std::size_t>(count));
  }
}

void ScipyPeer::add(const Equilibria& of, const std::string& what, bool warm,
                    std::vector<Entry>& out) {
  const Body& body = of.problem.body();
  const Potential& potential = of.problem.potential();
  const auto coefficients = [](const auto& part) {
    return std::visit([](const auto& model) { return Json(model.coefficients()); }, part);
  };
  const Stretch& start = warm ? of.first.q : of.rest;
  Json request{{"model", of.model},
               {"J", {body.J1, body.J2, body.J3}},
               {"plane", coefficients(potential.plane())},
               {"thickness", coefficients(potential.thickness())},
               {"axis", axis(of.problem.branch())},
               {"nu", of.nu},
               {"start", {start.alpha, start.xi, start.zeta, start.rho}},
               {"warm", warm}};
  for (const double tolerance : {1e-4, 1e-8, 1e-12}) {
    request["tolerance"] = tolerance;
    const auto found = std::make_shared<std::vector<Vector4<double>>>();
    const auto ask = [this, question = request.dump() + '\n', found](long passes) {
      double seconds = 0.0;
      for (long k = 0; k < passes; ++k) {
        for (std::size_t sent = 0; sent < question.size();) {
          const ::ssize_t count =
              ::send(child_->socket, question.data() + sent, question.size() - sent, MSG_NOSIGNAL);
          if (count < 0) throw std::system_error(errno, std::generic_category(), "SciPy");
          sent += static_cast<std::size_t>(count);
        }
        const std::string text = line();
        if (text.empty()) throw std::runtime_error("the process running SciPy has ended");
        const Json answer = Json::parse(text);
        *found = states_of(answer.at("q"));
        seconds += answer.at("seconds").get<double>();
      }
      return seconds;
    };
    out.push_back({what, "scipy-hybr", of.model, of.problem.branch(), tolerance, of.nu.size(), ask,
                   [found, &of] { return of.errors(*found); }});
  }
}

}  // namespace stationary::bench
