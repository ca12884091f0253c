#include "solver/program/commands/mpi_crew.hpp"

#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <deque>
#include <list>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "solver/program/commands/mpi_launch.hpp"
#include "solver/program/tiles/tile_workers.hpp"

namespace stationary::cli {
namespace {

using Clock = std::chrono::steady_clock;

enum Tag : int { hello, result, failed, idle, work, stop, end, leave };

/// From so many ranks on the leading one only hands out: it is a small part of all of them.
constexpr int many_ranks = 64;
/// So long the others may take to end what they are at once they are told to.
constexpr std::chrono::seconds patience(20);

template <class T>
void put(std::string& out, const T& value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}
template <class T>
T take(std::string_view& in) {
  T out;
  std::memcpy(&out, in.data(), sizeof out);
  in.remove_prefix(sizeof out);
  return out;
}

struct Message {
  int rank;
  int tag;
  std::string bytes;
};

std::optional<Message> received() {
  int there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
  if (there == 0) return std::nullopt;
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Message out{status.MPI_SOURCE, status.MPI_TAG, std::string(static_cast<std::size_t>(size), '\0')};
  MPI_Recv(out.bytes.data(), size, MPI_BYTE, out.rank, out.tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return out;
}

/// That threads look at: what a first signal does, which a second one would not.
void raise_the_flag(const TileLoop& loop) {
  if (!loop.stopped()) std::raise(SIGTERM);
}

/// Waits without a processor, which threads that compute may need: little where much goes on.
class Pause {
 public:
  void over() { next_ = std::chrono::microseconds(20); }
  void wait() {
    std::this_thread::sleep_for(next_);
    next_ = std::min(2 * next_, std::chrono::microseconds(1000));
  }

 private:
  std::chrono::microseconds next_{20};
};

/// What is sent without waiting for who receives it.
class Outbox {
 public:
  void send(int rank, Tag tag, std::string bytes) {
    Sent& sent = sent_.emplace_back();
    sent.bytes = std::move(bytes);
    MPI_Isend(sent.bytes.data(), static_cast<int>(sent.bytes.size()), MPI_BYTE, rank, tag,
              MPI_COMM_WORLD, &sent.request);
  }
  void clear_done() {
    std::erase_if(sent_, [](Sent& each) {
      int done = 0;
      MPI_Test(&each.request, &done, MPI_STATUS_IGNORE);
      return done != 0;
    });
  }
  void wait() {
    for (Sent& each : sent_) MPI_Wait(&each.request, MPI_STATUS_IGNORE);
    sent_.clear();
  }

 private:
  struct Sent {
    std::string bytes;
    MPI_Request request = MPI_REQUEST_NULL;
  };
  std::list<Sent> sent_;
};

/// The leading rank's part of one loop.
class Lead {
 public:
  Lead(const TileLoop& loop, int ranks)
      : loop_(loop), others_(static_cast<std::size_t>(ranks - 1)) {}

  bool run(const std::string& hash) {
    greet(hash);
    std::size_t workers = static_cast<std::size_t>(own_threads());
    for (const Other& each : others_) workers += each.threads;
    Dispatcher dispatcher(loop_.missing(), workers);
    TileOrder order(loop_);
    TileWorkers own(loop_, dispatcher, order, own_threads());
    Pause pause;
    for (;;) {
      bool something = false;
      while (auto message = received()) {
        something = true;
        handle(std::move(*message), dispatcher, order);
      }
      outbox_.clear_done();
      if (!stopping_ && (loop_.stopped() || own.failed() || failure_)) tell_to_stop();
      if (!stopping_) something = feed(dispatcher) || something;
      if (own.over() && all_done()) break;
      if (stopping_ && Clock::now() - told_ > patience) give_up();
      something ? pause.over() : pause.wait();
    }
    outbox_.wait();
    own.wait();
    if (failure_) std::rethrow_exception(failure_);
    for (std::size_t k = 0; k < others_.size(); ++k) outbox_.send(static_cast<int>(k) + 1, end, {});
    outbox_.wait();
    return order.finish();
  }

 private:
  struct Other {
    std::size_t threads = 1;
    std::size_t given = 0;  ///< and not come back
    bool idle = false;      ///< said so after stop
  };

  int own_threads() const {
    return static_cast<int>(others_.size()) + 1 < many_ranks ? loop_.threads : 0;
  }

  void greet(const std::string& hash) {
    for (std::size_t k = 0; k < others_.size(); ++k) {
      const int rank = static_cast<int>(k) + 1;
      MPI_Status status;
      MPI_Probe(rank, hello, MPI_COMM_WORLD, &status);
      int size = 0;
      MPI_Get_count(&status, MPI_BYTE, &size);
      std::string bytes(static_cast<std::size_t>(size), '\0');
      MPI_Recv(bytes.data(), size, MPI_BYTE, rank, hello, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      std::string_view in = bytes;
      others_[k].threads = static_cast<std::size_t>(take<std::int64_t>(in));
      if (in != hash && !failure_)
        failure_ = std::make_exception_ptr(std::runtime_error(
            fmt::format("rank {} has read another case, table or version than rank 0", rank)));
    }
    if (failure_) std::rethrow_exception(failure_);
  }

  void handle(Message message, Dispatcher& dispatcher, TileOrder& order) {
    Other& from = others_[static_cast<std::size_t>(message.rank) - 1];
    std::string_view in = message.bytes;
    if (message.tag == idle) {
      from.idle = true;
      from.given = 0;
      raise_the_flag(loop_);  // that rank alone had a signal: all of them end
    } else if (message.tag == failed) {
      if (!failure_)
        failure_ = std::make_exception_ptr(
            std::runtime_error(fmt::format("rank {}: {}", message.rank, in)));
    } else if (message.tag == result) {
      const auto tile = static_cast<std::size_t>(take<std::uint64_t>(in));
      const double seconds = take<double>(in);
      if (from.given > 0) --from.given;
      dispatcher.ended(seconds);
      try {
        if (!failure_) order.keep(tile, std::string(in), seconds);
      } catch (...) {
        failure_ = std::current_exception();
      }
    }
  }

  bool feed(Dispatcher& dispatcher) {
    bool something = false;
    for (std::size_t k = 0; k < others_.size(); ++k) {
      Other& to = others_[k];
      while (!left_none_ && wants_more(to.given, to.threads)) {
        const auto tiles = dispatcher.next(1024);
        left_none_ = tiles.empty();
        if (left_none_) break;
        std::string bytes;
        for (const std::size_t tile : tiles) put(bytes, static_cast<std::uint64_t>(tile));
        outbox_.send(static_cast<int>(k) + 1, work, std::move(bytes));
        to.given += tiles.size();
        something = true;
      }
    }
    return something;
  }

  void tell_to_stop() {
    stopping_ = true;
    told_ = Clock::now();
    for (std::size_t k = 0; k < others_.size(); ++k)
      outbox_.send(static_cast<int>(k) + 1, stop, {});
    raise_the_flag(loop_);
  }

  bool all_done() const {
    for (const Other& each : others_)
      if (stopping_ ? !each.idle : each.given > 0) return false;
    return stopping_ || left_none_ || others_.empty();
  }

  [[noreturn]] void give_up() const {
    for (std::size_t k = 0; k < others_.size(); ++k)
      if (!others_[k].idle)
        fmt::print(stderr, "stationary: rank {} does not answer; what was finished is kept\n",
                   k + 1);
    MPI_Abort(MPI_COMM_WORLD, failure_ ? 4 : 130);
    std::abort();
  }

  const TileLoop& loop_;
  std::vector<Other> others_;
  Outbox outbox_;
  bool left_none_ = false;
  bool stopping_ = false;
  Clock::time_point told_;
  std::exception_ptr failure_;
};

/// Another rank's part: threads take tiles from a queue, the one that talks to rank 0 fills it.
class Serve {
 public:
  explicit Serve(const TileLoop& loop) : loop_(loop) {}

  /// Whether there may be another loop.
  bool run(const std::string& hash) {
    std::string bytes;
    put(bytes, static_cast<std::int64_t>(loop_.threads));
    bytes += hash;
    MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, 0, hello, MPI_COMM_WORLD);
    std::vector<std::jthread> threads;
    try {
      for (int k = 0; k < loop_.threads; ++k) threads.emplace_back([this] { compute(); });
    } catch (const std::system_error& error) {
      outbox_.send(0, failed, no_thread(error));  // which ends all of them
    }
    Pause pause;
    bool ended = false;
    bool leaves = false;
    while (!ended && !leaves) {
      bool something = false;
      while (auto message = received()) {
        something = true;
        ended = message->tag == end;
        leaves = message->tag == leave;
        if (ended || leaves) break;
        if (message->tag == stop) raise_the_flag(loop_);
        if (message->tag == work) fill(message->bytes);
      }
      something = send_results() || something;
      outbox_.clear_done();
      something ? pause.over() : pause.wait();
    }
    outbox_.wait();
    {
      const std::scoped_lock lock(mutex_);
      ended_ = true;
    }
    more_.notify_all();
    return !leaves;
  }

 private:
  void fill(std::string_view in) {
    const std::scoped_lock lock(mutex_);
    while (!in.empty()) queue_.push_back(static_cast<std::size_t>(take<std::uint64_t>(in)));
    more_.notify_all();
  }

  bool send_results() {
    std::deque<std::pair<Tag, std::string>> out;
    {
      const std::scoped_lock lock(mutex_);
      out.swap(results_);
      if (loop_.stopped() && busy_ == 0 && !said_idle_) {
        said_idle_ = true;
        out.emplace_back(idle, std::string());
      }
    }
    for (auto& [tag, bytes] : out) outbox_.send(0, tag, std::move(bytes));
    return !out.empty();
  }

  void compute() {
    std::unique_lock lock(mutex_);
    for (;;) {
      more_.wait_for(lock, std::chrono::milliseconds(100),
                     [this] { return ended_ || !queue_.empty(); });
      if (ended_ || loop_.stopped()) return;
      if (queue_.empty()) continue;
      const std::size_t tile = queue_.front();
      queue_.pop_front();
      ++busy_;
      lock.unlock();
      std::pair<Tag, std::string> out{result, {}};
      bool whole = true;
      try {
        const auto begin = Clock::now();
        const auto text = loop_.compute(tile);
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        whole = text.has_value();
        if (whole) {
          put(out.second, static_cast<std::uint64_t>(tile));
          put(out.second, seconds);
          out.second += *text;
        }
      } catch (const std::exception& error) {
        out = {failed, error.what()};
      }
      lock.lock();
      --busy_;
      if (whole) results_.push_back(std::move(out));
    }
  }

  const TileLoop& loop_;
  Outbox outbox_;
  std::mutex mutex_;
  std::condition_variable more_;
  std::deque<std::size_t> queue_;
  std::deque<std::pair<Tag, std::string>> results_;
  int busy_ = 0;
  bool ended_ = false;
  bool said_idle_ = false;
};

}  // namespace

struct MpiCrew::Begun {
  int rank = 0;
  int ranks = 1;
  bool told_to_leave = false;

  Begun() {
    int given = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &given);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  }
  Begun(const Begun&) = delete;
  Begun& operator=(const Begun&) = delete;
  ~Begun() {
    // The others are told to leave, whether rank 0 came to any work or not.
    Pause pause;
    if (rank == 0) {
      for (int k = 1; k < ranks; ++k) MPI_Send(nullptr, 0, MPI_BYTE, k, leave, MPI_COMM_WORLD);
    } else {
      for (; !told_to_leave; pause.wait())  // while rank 0 writes its table
        while (const auto message = received()) told_to_leave |= message->tag == leave;
    }
    // What they still say nobody listens to, but none may wait for that.
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibarrier(MPI_COMM_WORLD, &request);
    for (int all = 0; all == 0; pause.wait()) {
      MPI_Test(&request, &all, MPI_STATUS_IGNORE);
      while (received()) {
      }
    }
    MPI_Finalize();
  }
};

MpiCrew::MpiCrew() = default;
MpiCrew::~MpiCrew() = default;

bool MpiCrew::leads() {
  if (!begun_) {
    begun_ = std::make_unique<Begun>();
    if (begun_->ranks == 1) require_alone();
  }
  return begun_->rank == 0;
}

int MpiCrew::ranks() { return begun_ ? begun_->ranks : 1; }

bool MpiCrew::run(const TileLoop& loop, const std::string& hash) {
  if (begun_->ranks == 1) return cli::run(loop);
  return Lead(loop, begun_->ranks).run(hash);
}

void MpiCrew::serve(const TileLoop& loop, const std::string& hash) {
  if (!begun_->told_to_leave) begun_->told_to_leave = !Serve(loop).run(hash);
}

}  // namespace stationary::cli
