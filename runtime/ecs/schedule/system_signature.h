#pragma once

#include <hachure/runtime/ecs/schedule/system_param.h>

#include <type_traits>

namespace hachure::detail {

/// The result and the parameters of a function, or of an object with one `operator()`: `Result`, `Parameters`.
template <class F> struct Signature;

template <class... P> struct ParameterList {};

template <class R, class... P> struct FunctionSignature {
    using Result = R;
    using Parameters = ParameterList<P...>;
};

template <class R, class... P> struct Signature<R (*)(P...)> : FunctionSignature<R, P...> {};
template <class R, class... P> struct Signature<R (*)(P...) noexcept> : FunctionSignature<R, P...> {};
template <class F, class R, class... P> struct Signature<R (F::*)(P...)> : FunctionSignature<R, P...> {};
template <class F, class R, class... P> struct Signature<R (F::*)(P...) noexcept> : FunctionSignature<R, P...> {};
template <class F, class R, class... P> struct Signature<R (F::*)(P...) const> : FunctionSignature<R, P...> {};
template <class F, class R, class... P> struct Signature<R (F::*)(P...) const noexcept> : FunctionSignature<R, P...> {};
template <class F, class R, class... P> struct Signature<R (F::*)(P...)&> : FunctionSignature<R, P...> {};
template <class F, class R, class... P> struct Signature<R (F::*)(P...)& noexcept> : FunctionSignature<R, P...> {};
template <class F, class R, class... P> struct Signature<R (F::*)(P...) const&> : FunctionSignature<R, P...> {};
template <class F, class R, class... P>
struct Signature<R (F::*)(P...) const& noexcept> : FunctionSignature<R, P...> {};

template <class F>
requires requires { &F::operator(); }
struct Signature<F> : Signature<decltype(&F::operator())> {};

/// Whether F has one signature: no overloads, no templates.
template <class F>
concept HasSignature = requires {
    typename Signature<F>::Parameters;
};

/// Says in one line what is wrong with parameter P, if anything.
template <class P> constexpr bool check_parameter() {
    using T = std::remove_cvref_t<std::remove_pointer_t<std::remove_reference_t<P>>>;
    if constexpr (is_value_param<T>) {
        static_assert(std::is_same_v<P, T>,
                      "a system takes Query, EventReader, EventWriter, Removed and LastRun by value");
    } else if constexpr (std::is_same_v<T, Commands>) {
        static_assert(std::is_same_v<P, Commands&>, "a system takes its queue as Commands&");
    } else if constexpr (std::is_same_v<T, World>) {
        static_assert(std::is_same_v<P, World&> || std::is_same_v<P, const World&>,
                      "a system takes the world as World& (and then runs alone) or as const World&");
    } else {
        static_assert(SystemParameter<P>,
                      "a system takes a resource R, a class, as const R& or R& (it must be there), or "
                      "const R* or R* (null when absent); see Schedule for other parameters");
    }
    return SystemParameter<P>;
}

template <class... P> constexpr bool check_parameters(ParameterList<P...>) { return (check_parameter<P>() && ...); }

/// Checks that F is a system: that returns nothing, and of which all parameters are known.
template <class F> constexpr bool check_system() {
    static_assert(HasSignature<F>, "a system is a function, or an object with one operator(), which is no template");
    if constexpr (HasSignature<F>) {
        static_assert(std::is_void_v<typename Signature<F>::Result>, "a system returns nothing");
        return check_parameters(typename Signature<F>::Parameters{});
    }
    return false;
}

template <class... P> constexpr bool all_read_only(ParameterList<P...>) { return (SystemParam<P>::reads_only && ...); }

/// Checks that F is a condition: a system that returns bool and writes nothing.
template <class F> constexpr bool check_condition() {
    static_assert(HasSignature<F>, "a condition is a function, or an object with one operator(), which is no template");
    if constexpr (HasSignature<F>) {
        static_assert(std::is_same_v<typename Signature<F>::Result, bool>, "a condition returns bool");
        if constexpr (check_parameters(typename Signature<F>::Parameters{})) {
            static_assert(all_read_only(typename Signature<F>::Parameters{}), "a condition only reads");
            return true;
        }
    }
    return false;
}

} // namespace hachure::detail
