#include <hachure/tests/benchmarks/ecs_arguments.h>

#include <string_view>
#include <vector>

namespace hachure::bench {

EcsArguments parse_ecs_arguments(int argc, char** argv) {
    EcsArguments arguments;
    std::vector<char*> others{argv[0]};
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        if (argument == "--huge")
            arguments.huge = true;
        else if (argument == "--chart" && i + 1 < argc)
            arguments.chart = argv[++i];
        else if (argument == "--markdown" && i + 1 < argc)
            arguments.markdown = argv[++i];
        else
            others.push_back(argv[i]);
    }
    arguments.common = parse_arguments(static_cast<int>(others.size()), others.data(),
                                       "What the world's operations cost, over the same on raw arrays.\n"
                                       "  --markdown FILE  also writes the table as a page\n"
                                       "  --chart FILE     instead, a sweep over numbers of entities as CSV\n"
                                       "  --huge           instead, ten million entities in 4 GiB, checked");
    return arguments;
}

} // namespace hachure::bench
