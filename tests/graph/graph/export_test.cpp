#include "graph/export.h"

#include <nlohmann/json.hpp>

#include "graph/graph/graph_test.h"

namespace lampyris::graph {
namespace {

class Export : public GraphTest {
 protected:
    Export() {
        Buffer last = source("first");
        for (const char* name : {"second", "third"}) {
            auto node = compute(name);
            node.read(0, last);
            last = node.write(1, frame.buffer(std::string(name) + " out", kBytes));
        }
        const Image image = compute("draw").write(0, frame.image("final \"x\"", kColour));
        frame.output(image);
        frame.output(last);
        (void)source("unused");
    }
};

TEST_F(Export, JsonHoldsWhatWasCompiled) {
    const CompiledGraph graph = compiled();
    const auto json = nlohmann::json::parse(toJson(frame, graph));
    ASSERT_EQ(json["steps"].size(), 4u);
    EXPECT_EQ(json["steps"][1]["node"], "second");
    EXPECT_EQ(json["steps"][1]["kind"], "compute");
    EXPECT_EQ(json["steps"][1]["uses"][0]["access"], "StorageRead");
    EXPECT_EQ(json["steps"][1]["barriers"][0]["resource"], "first out");
    EXPECT_EQ(json["steps"][1]["barriers"][0]["source"][0], "compute StorageWrite");
    EXPECT_EQ(json["steps"][2]["handover"]["pairs"][0]["from"], "first out");
    EXPECT_EQ(json["steps"][2]["handover"]["pairs"][0]["to"], "third out");
    EXPECT_EQ(json["steps"][3]["barriers"][0]["after"], "General");
    EXPECT_EQ(json["final_barriers"].size(), graph.finalBarriers.size());
    EXPECT_EQ(json["culled"][0]["node"], "unused");
    EXPECT_EQ(json["culled"][0]["reason"], graph.culled[0].reason);
    EXPECT_EQ(json["transient_bytes"], graph.transientBytes);
    EXPECT_EQ(json["transient_bytes_without_aliasing"], graph.transientBytesWithoutAliasing);
    EXPECT_LT(graph.transientBytes, graph.transientBytesWithoutAliasing);
}

TEST_F(Export, JsonGivesLifetimesAndPlaces) {
    const CompiledGraph graph = compiled();
    const auto json = nlohmann::json::parse(toJson(frame, graph));
    const auto& second = json["resources"][1];
    EXPECT_EQ(second["name"], "second out");
    EXPECT_EQ(second["origin"], "transient");
    EXPECT_EQ(second["first_step"], 1);
    EXPECT_EQ(second["last_step"], 2);
    EXPECT_EQ(second["bytes"], kBytes.bytes);
    EXPECT_EQ(second["offset"], graph.resources[1].offset);
    EXPECT_EQ(json["resources"][3]["format"], "RGBA16Float");
    EXPECT_FALSE(json["resources"][4].contains("heap"));
}

TEST_F(Export, NamesThatAreNotUtf8DoNoHarm) {
    (void)frame.buffer("\xff\xfe", kBytes);
    EXPECT_FALSE(nlohmann::json::parse(toJson(frame, compiled())).is_discarded());
}

TEST_F(Export, JsonNamesPoisonedThings) {
    const auto json = nlohmann::json::parse(toJson(frame, compiled({.poisonTransients = true})));
    EXPECT_EQ(json["steps"][0]["poisons"][0], "first out");
}

TEST_F(Export, DotShowsNodesArrowsBarriersAndWhatIsCulled) {
    const std::string dot = toDot(frame, compiled());
    EXPECT_EQ(dot.find("digraph frame {"), 0u);
    for (const char* part : {"node0 -> node1 [label=\"first out\"]", "1 second (compute)\\l",
                             "first out: compute StorageWrite -> compute StorageRead\\l",
                             "memory: first out -> third out\\l", "style=dashed", "final \\\"x\\\"",
                             "tooltip=\"Nobody reads what it writes: 'unused out'.\""}) {
        EXPECT_NE(dot.find(part), std::string::npos) << part << "\n" << dot;
    }
    EXPECT_EQ(std::count(dot.begin(), dot.end(), '{'), std::count(dot.begin(), dot.end(), '}'));
}

}  // namespace
}  // namespace lampyris::graph
