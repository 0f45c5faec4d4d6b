// The files beside the picture: --report, --graph, --trace.
#include <cmath>
#include <set>

#include "cli/program/program.h"

namespace lampyris::test {
namespace {

using Json = nlohmann::json;

Json reportOf(const Arguments& more = {}) {
    const ScratchFolder folder;
    Arguments arguments{"--report", folder / "report.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ran ran = render("cornell", folder / "a.png", arguments);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return jsonOf(folder / "report.json");
}

void expectKeys(const Json& object, const std::set<std::string>& keys) {
    std::set<std::string> found;
    for (const auto& [key, value] : object.items()) found.insert(key);
    EXPECT_EQ(found, keys);
}

TEST(Report, HasTheKeysThatTheContractNames) {
    const Json report = reportOf({"--frames", "3", "--warmup", "1"});
    const std::set<std::string> statistics{"mean", "stddev", "median", "p95", "min", "max"};
    expectKeys(report, {"device", "driver", "scene", "size", "pipeline", "settings", "frames",
                        "frame_ms", "nodes", "photons", "tiles", "gather", "grid", "lights",
                        "accel", "memory", "valid", "validation", "validation_messages"});
    expectKeys(report["frame_ms"], statistics);
    for (const Json& node : report["nodes"]) {
        expectKeys(node, {"name", "gpu_ms", "cpu_record_ms"});
        expectKeys(node["gpu_ms"], statistics);
        expectKeys(node["cpu_record_ms"], statistics);
    }
    expectKeys(report["photons"],
               {"paths", "stored", "dropped", "retraced", "emitted_watts", "absorbed_watts",
                "escaped_watts", "in_flight_watts", "roulette_watts"});
    expectKeys(report["tiles"], {"pairs", "dropped", "max_in_tile"});
    expectKeys(report["gather"], {"pixels_recomputed"});
    expectKeys(report["grid"], {"cells", "dropped"});
    expectKeys(report["lights"], {"cut_off_watts"});
    expectKeys(report["accel"], {"triangles", "blas", "refits", "rebuilds", "refit_ms",
                                 "rebuild_ms", "sah_ratio_max"});
    expectKeys(report["memory"],
               {"device_bytes", "transient_bytes", "transient_bytes_without_aliasing"});
    EXPECT_EQ(report["scene"], "cornell");
    EXPECT_EQ(report["size"], Json::array({160, 90}));
    EXPECT_EQ(report["pipeline"], "full");
    EXPECT_EQ(report["frames"], 3);
    EXPECT_EQ(report["validation"], "off");
    EXPECT_EQ(report["valid"], true);
    EXPECT_EQ(report["accel"]["rebuilds"], 0) << "loading is left out";
    EXPECT_EQ(report["accel"]["triangles"], 34) << "five walls and two boxes";
    EXPECT_GT(report["memory"]["device_bytes"], 0);
    EXPECT_LT(report["memory"]["transient_bytes"],
              report["memory"]["transient_bytes_without_aliasing"]);
}

TEST(Report, NamesNodesAsTheContractDoesAndTheirSumIsTheFrame) {
    const Json report = reportOf({"--frames", "5", "--warmup", "1"});
    std::set<std::string> names;
    double sum = 0.0;
    for (const Json& node : report["nodes"]) {
        const std::string name = node["name"];
        EXPECT_EQ(name.find('/'), std::string::npos) << name;
        EXPECT_TRUE(names.insert(name).second) << name << " twice";
        sum += node["gpu_ms"]["mean"].get<double>();
    }
    for (const char* name : {"gbuffer", "sphere_direct", "shadow", "photon_trace",
                             "irradiance_grid", "gather", "upsample", "composite"})
        EXPECT_TRUE(names.contains(name)) << name;
    const double frame = report["frame_ms"]["mean"];
    EXPECT_NEAR(sum, frame, 0.1 * frame);
    EXPECT_LE(report["frame_ms"]["min"], report["frame_ms"]["median"]);
    EXPECT_LE(report["frame_ms"]["median"], report["frame_ms"]["p95"]);
    EXPECT_LE(report["frame_ms"]["p95"], report["frame_ms"]["max"]);
}

TEST(Report, AccountsForAllEmittedPower) {
    for (const char* pipeline : {"full", "thesis"}) {
        const Json photons = reportOf({"--pipeline", pipeline})["photons"];
        EXPECT_EQ(photons["paths"], std::string(pipeline) == "full" ? 2500 : 1000);
        EXPECT_GT(photons["stored"], 100);
        for (size_t c = 0; c < 3; ++c) {
            const double emitted = photons["emitted_watts"][c];
            EXPECT_NEAR(emitted, 1000.0, 0.1);
            double found = 0.0;
            for (const char* key :
                 {"absorbed_watts", "escaped_watts", "in_flight_watts", "roulette_watts"})
                found += photons[key][c].get<double>();
            EXPECT_NEAR(found, emitted, 1e-4 * emitted) << pipeline << " " << c;
        }
    }
}

TEST(Report, SaysWhatTheFrameWasMadeWith) {
    const Json plain = reportOf()["settings"];
    EXPECT_EQ(plain["photons"], 2500);
    EXPECT_EQ(plain["gather"], "final");
    EXPECT_EQ(plain["radius"], 1.0);
    EXPECT_EQ(plain["max_bounces"], 8);
    EXPECT_EQ(plain["gather_divisor"], 8);
    const Json tiles = reportOf({"--gather", "tiles"})["settings"];
    EXPECT_EQ(tiles["photons"], 1000);
    EXPECT_EQ(tiles["gather_divisor"], 2);
    EXPECT_EQ(plain["seed"], 1);
    EXPECT_EQ(reportOf({"--pipeline", "thesis"})["settings"]["max_bounces"], 1);
    const Json fine = reportOf({"--quality", "fine", "--photons", "500"})["settings"];
    EXPECT_EQ(fine["photons"], 500) << "an option overrides the preset";
    EXPECT_EQ(fine["gather_divisor"], 4);
    EXPECT_EQ(reportOf({"--pipeline", "thesis", "--quality", "fine"})["settings"]["photons"], 1000)
        << "presets are of full";
}

TEST(Graph, IsWrittenAsDotAndAsJson) {
    const ScratchFolder folder;
    ASSERT_EQ(render("cornell", folder / "a.png", {"--graph", folder / "a.dot"}).code, 0);
    const std::string dot = textOf(folder / "a.dot");
    EXPECT_EQ(dot.rfind("digraph", 0), 0u);
    EXPECT_NE(dot.find("photon_trace"), std::string::npos);
    EXPECT_EQ(dot.back(), '\n');
    ASSERT_EQ(render("cornell", folder / "a.png", {"--graph", folder / "a.json"}).code, 0);
    const Json graph = jsonOf(folder / "a.json");
    ASSERT_TRUE(graph.is_object());
    EXPECT_NE(graph.dump().find("photon_trace"), std::string::npos);
    EXPECT_EQ(folder.files(), 3u);
}

TEST(Trace, IsChromesFormat) {
    const ScratchFolder folder;
    ASSERT_EQ(render("cornell", folder / "a.png",
                     {"--frames", "2", "--retrace", "all", "--trace", folder / "t.json"})
                  .code,
              0);
    const Json trace = jsonOf(folder / "t.json");
    ASSERT_TRUE(trace["traceEvents"].is_array());
    double end = 0.0;
    int frames = 0;
    for (const Json& event : trace["traceEvents"]) {
        ASSERT_TRUE(event.contains("name") && event.contains("ph") && event.contains("pid"));
        if (event["ph"] != "X" || event["tid"] != 1) continue;
        EXPECT_GE(event["ts"].get<double>(), end - 1e-6) << "nodes run one after the other";
        end = event["ts"].get<double>() + event["dur"].get<double>();
        frames += event["name"] == "gbuffer" ? 1 : 0;
    }
    EXPECT_EQ(frames, 2);
}

}  // namespace
}  // namespace lampyris::test
