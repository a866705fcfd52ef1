// The replacements of the library's operators by instrument.py: unchanged, except for the active
// mutant.
#ifndef MUTANTS_HPP
#define MUTANTS_HPP

namespace mutation {

constexpr unsigned most = 1 << 16;
inline unsigned active = 0;            // from the environment, by main.cpp
inline unsigned char reached[most]{};  // by mutant: whether it was evaluated

/// Returns n if the n-th mutant of the operator is active, or 0. The argument is the number of its
/// first mutant. Compile-time evaluation is never mutated.
[[gnu::always_inline]] constexpr unsigned chosen(unsigned first) {
  if (__builtin_is_constant_evaluated()) return 0;
  reached[first] = 1;
  return active - first + 1;
}

[[gnu::always_inline]] constexpr bool is_active(unsigned id) {
  return chosen(id) == 1;
}

[[gnu::always_inline]] constexpr bool skips(unsigned id) {
  return is_active(id);
}
[[gnu::always_inline]] constexpr bool forced(unsigned id, bool to, bool value) {
  return is_active(id) ? to : value;
}
[[gnu::always_inline]] constexpr bool other(unsigned id, bool value) {
  return is_active(id) ? !value : value;
}
[[gnu::always_inline]] constexpr bool negation(unsigned id, bool value) {
  return is_active(id) ? value : !value;
}
template <class T>
[[gnu::always_inline]] constexpr T one_more(unsigned id, T value) {
  return is_active(id) ? static_cast<T>(value + 1) : value;
}
template <class T>
[[gnu::always_inline]] constexpr auto minus(unsigned id, T value) {
  return is_active(id) ? +value : -value;
}
template <class T>
[[gnu::always_inline]] constexpr auto inverse(unsigned id, T value) {
  return is_active(id) ? +value : ~value;
}
template <class T>
[[gnu::always_inline]] constexpr T& increment(unsigned id, T& value) {
  return is_active(id) ? --value : ++value;
}
template <class T>
[[gnu::always_inline]] constexpr T& decrement(unsigned id, T& value) {
  return is_active(id) ? ++value : --value;
}

#define MUTATION_COMPARISON(name, operator, boundary, negation)          \
  template <class A, class B>                                            \
  [[gnu::always_inline]] constexpr bool name(unsigned id, A a, B b) {    \
    const unsigned n = chosen(id);                                       \
    return n == 1 ? a boundary b : n == 2 ? a negation b : a operator b; \
  }
MUTATION_COMPARISON(less, <, <=, >=)
MUTATION_COMPARISON(less_equal, <=, <, >)
MUTATION_COMPARISON(greater, >, >=, <=)
MUTATION_COMPARISON(greater_equal, >=, >, <)
#undef MUTATION_COMPARISON

// Without the opposite operator, because not every type has one.
template <class A, class B>
[[gnu::always_inline]] constexpr bool equal(unsigned id, const A& a, const B& b) {
  return is_active(id) != (a == b);
}
template <class A, class B>
[[gnu::always_inline]] constexpr bool unequal(unsigned id, const A& a, const B& b) {
  return is_active(id) != (a != b);
}

#define MUTATION_OPERATOR(name, operator, mutated)                    \
  template <class A, class B>                                         \
  [[gnu::always_inline]] constexpr auto name(unsigned id, A a, B b) { \
    return is_active(id) ? a mutated b : a operator b;                \
  }
MUTATION_OPERATOR(plus, +, -)
MUTATION_OPERATOR(minus, -, +)
MUTATION_OPERATOR(times, *, /)
MUTATION_OPERATOR(divided, /, *)
MUTATION_OPERATOR(modulo, %, *)
MUTATION_OPERATOR(bit_and, &, |)
MUTATION_OPERATOR(bit_or, |, &)
MUTATION_OPERATOR(bit_xor, ^, &)
MUTATION_OPERATOR(shift_left, <<, >>)
MUTATION_OPERATOR(shift_right, >>, <<)
#undef MUTATION_OPERATOR

template <class T>
[[gnu::always_inline]] constexpr auto minus(unsigned id, T* a, T* b) {
  return is_active(id) ? b - a : a - b;
}

#define MUTATION_ASSIGNMENT(name, operator, mutated)                        \
  template <class A, class B>                                               \
  [[gnu::always_inline]] constexpr A& name(unsigned id, A& a, const B& b) { \
    return is_active(id) ? a mutated b : a operator b;                      \
  }
MUTATION_ASSIGNMENT(add, +=, -=)
MUTATION_ASSIGNMENT(subtract, -=, +=)
MUTATION_ASSIGNMENT(multiply, *=, /=)
MUTATION_ASSIGNMENT(divide, /=, *=)
MUTATION_ASSIGNMENT(remain, %=, *=)
MUTATION_ASSIGNMENT(mask, &=, |=)
MUTATION_ASSIGNMENT(combine, |=, &=)
MUTATION_ASSIGNMENT(toggle, ^=, &=)
MUTATION_ASSIGNMENT(raise, <<=, >>=)
MUTATION_ASSIGNMENT(lower, >>=, <<=)
#undef MUTATION_ASSIGNMENT

}  // namespace mutation

#endif
