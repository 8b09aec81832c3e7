#pragma once

#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/schedule/system_signature.h>

#include <functional>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>

namespace hachure::detail {

/// A system or a condition of any type, with the state that it keeps between runs. Result is void or bool.
template <class Result> class Callable {
public:
    virtual ~Callable() = default;
    virtual Result call(const SystemContext& context) = 0;
    virtual SystemNeeds needs() const = 0;
};

template <class F, class Parameters> class CallableOf;
template <class F, class... P>
class CallableOf<F, ParameterList<P...>> final : public Callable<typename Signature<F>::Result> {
public:
    explicit CallableOf(F function) : function_(std::move(function)) {}

    typename Signature<F>::Result call(const SystemContext& context) override {
        // In braces, so that the parameters are made in order, and the same one is found missing first everywhere.
        using Values = std::tuple<decltype(SystemParam<P>::get(context))...>;
        return std::apply(function_, Values{SystemParam<P>::get(context)...});
    }

    SystemNeeds needs() const override {
        SystemNeeds result;
        (SystemParam<P>::add_to(result), ...);
        return result;
    }

private:
    F function_;
};

template <class F> inline constexpr bool may_be_empty = std::is_pointer_v<F>;
template <class S> inline constexpr bool may_be_empty<std::function<S>> = true;
template <> inline constexpr bool may_be_empty<std::nullptr_t> = true;

/// For a system or a condition that was checked.
template <class F> std::unique_ptr<Callable<typename Signature<F>::Result>> make_callable(F function) {
    if constexpr (may_be_empty<F>) HACHURE_ASSERT(function != nullptr, "a system can be called");
    return std::make_unique<CallableOf<F, typename Signature<F>::Parameters>>(std::move(function));
}

} // namespace hachure::detail
