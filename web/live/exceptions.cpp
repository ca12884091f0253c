// C++ exceptions in WebAssembly. Debian's C++ runtime for it is built without them; what is missing is little, because the
// engine unwinds the stack itself:
//
//   throw     an object with a Thrown before it, handed to the engine under its tag
//   catch     the compiler asks here, frame by frame, which handler takes it; it reads the answer in __wasm_lpad_context
//   end       of the last handler: destroyed
//
// The tables are those of the Itanium ABI (https://itanium-cxx-abi.github.io/cxx-abi/exceptions.pdf) with an index in the
// place of a program counter. There is one thread.
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <new>
#include <typeinfo>

// What libc++abi has in no header of its own: every type_info can say whether a handler of its type takes an object.
namespace __cxxabiv1 {
class __shim_type_info : public std::type_info {
 public:
  ~__shim_type_info() override;
  virtual void noop1() const;
  virtual void noop2() const;
  virtual bool can_catch(const __shim_type_info* thrown, void*& object) const = 0;
};
}  // namespace __cxxabiv1

namespace {

using Type = __cxxabiv1::__shim_type_info;

/// Stands before the object.
struct alignas(16) Thrown {
  const Type* type;
  void* (*destroy)(void*);
  void* as_caught;  ///< the object as the handler's type
  int handlers;     ///< that are in it; negative while it is thrown on from them
  Thrown* outer;    ///< in whose handler this one was caught
};

Thrown* caught = nullptr;

Thrown* of(void* object) { return static_cast<Thrown*>(object) - 1; }

/// What the compiler's code and the search for a handler tell each other.
struct LandingPad {
  std::uintptr_t index;  ///< of the call site
  const std::uint8_t* table;
  std::uintptr_t selector;  ///< which handler; 0: none
};

std::uint32_t read_unsigned(const std::uint8_t*& at) {
  std::uint32_t out = 0;
  for (unsigned shift = 0;; shift += 7) {
    const std::uint8_t byte = *at++;
    out |= static_cast<std::uint32_t>(byte & 0x7fU) << shift;
    if ((byte & 0x80U) == 0) return out;
  }
}

std::int32_t read_signed(const std::uint8_t*& at) {
  std::uint32_t out = 0;
  unsigned shift = 0;
  std::uint8_t byte = 0;
  do {
    byte = *at++;
    out |= static_cast<std::uint32_t>(byte & 0x7fU) << shift;
    shift += 7;
  } while ((byte & 0x80U) != 0);
  if ((byte & 0x40U) != 0 && shift < 32) out |= ~std::uint32_t{0} << shift;
  return static_cast<std::int32_t>(out);
}

/// The first handler of a call site that takes the object; 0 where none does.
std::uintptr_t handler(const LandingPad& pad, Thrown& thrown) {
  constexpr std::uint8_t left_out = 0xff;
  const std::uint8_t* at = pad.table;
  if (*at++ != left_out) std::abort();  // landing pads start where the function does
  const std::uint8_t* types = nullptr;
  if (*at++ != left_out) {
    const std::uint32_t offset = read_unsigned(at);
    types = at + offset;
  }
  ++at;  // how call sites are written: unsigned
  const std::uint32_t size = read_unsigned(at);
  const std::uint8_t* const actions = at + size;
  std::uint32_t action = 0;
  for (std::uintptr_t k = 0; k <= pad.index; ++k) {
    read_unsigned(at);
    action = read_unsigned(at);
  }
  if (action == 0) return 0;
  at = actions + action - 1;
  for (;;) {
    const std::int32_t index = read_signed(at);
    if (index < 0) std::abort();  // an exception specification, which C++20 has none of
    if (index > 0) {
      const auto* const type = *(reinterpret_cast<const Type* const*>(types) - index);
      void* object = &thrown + 1;
      if (type == nullptr || type->can_catch(thrown.type, object)) {
        thrown.as_caught = object;
        return static_cast<std::uintptr_t>(index);
      }
    }
    const std::uint8_t* const from = at;
    const std::int32_t next = read_signed(at);
    if (next == 0) return 0;
    at = from + next;
  }
}

}  // namespace

extern "C" {

thread_local LandingPad __wasm_lpad_context;

int _Unwind_CallPersonality(void* object) {
  __wasm_lpad_context.selector = handler(__wasm_lpad_context, *of(object));
  return 0;
}

void* __cxa_allocate_exception(std::size_t size) {
  void* const room = std::malloc(sizeof(Thrown) + size);
  if (room == nullptr) std::abort();
  return new (room) Thrown{} + 1;
}

void __cxa_free_exception(void* object) { std::free(of(object)); }

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, void* (*destroy)(void*)) {
  Thrown* const thrown = of(object);
  thrown->type = static_cast<const Type*>(type);
  thrown->destroy = destroy;
  thrown->as_caught = object;
  __builtin_wasm_throw(0, object);
}

void* __cxa_get_exception_ptr(void* object) { return of(object)->as_caught; }

void* __cxa_begin_catch(void* object) {
  Thrown* const thrown = of(object);
  thrown->handlers = std::abs(thrown->handlers) + 1;
  if (caught != thrown) {
    thrown->outer = caught;
    caught = thrown;
  }
  return thrown->as_caught;
}

void __cxa_end_catch() {
  Thrown* const thrown = caught;
  if (thrown->handlers < 0) {  // thrown on: it is somebody else's now
    if (++thrown->handlers == 0) caught = thrown->outer;
    return;
  }
  if (--thrown->handlers > 0) return;
  caught = thrown->outer;
  if (thrown->destroy != nullptr) thrown->destroy(thrown + 1);
  std::free(thrown);
}

[[noreturn]] void __cxa_rethrow() {
  if (caught == nullptr) std::terminate();
  caught->handlers = -caught->handlers;
  __builtin_wasm_throw(0, caught + 1);
}

}  // extern "C"
