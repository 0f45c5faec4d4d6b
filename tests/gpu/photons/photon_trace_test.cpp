#include "photons/photon_trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "glm/gtc/packing.hpp"
#include "support/frame_test.h"
#include "support/scene_frame.h"

namespace lampyris::photons {
namespace {

struct Traced {
    std::vector<shared::PackedPhoton> photons;
    std::vector<uint32_t> offsets;
    PathSplit split;
};

class PhotonTrace : public test::FrameTest {
 protected:
    static Traced trace(const scene::SceneSnapshot& snapshot, uint32_t paths,
                        const TraceSettings& settings) {
        test::SceneFrame on(device(), snapshot);
        Traced traced;
        traced.split = splitPaths(listEmitters(snapshot.lights, on.scene.emitters()), paths);
        const auto list = addPhotonTrace(on.frame, on.handles, on.tree, traced.split,
                                         {0, traced.split.paths}, settings, on.counters);
        const auto result = on.run({list.photons, list.pathOffsets});
        traced.photons = test::valuesOf<shared::PackedPhoton>(result.buffers[0]);
        traced.offsets = test::valuesOf<uint32_t>(result.buffers[1]);
        return traced;
    }

    static glm::vec3 positionOf(const shared::PackedPhoton& photon) {
        return {std::bit_cast<float>(photon.positionPower.x),
                std::bit_cast<float>(photon.positionPower.y),
                std::bit_cast<float>(photon.positionPower.z)};
    }
    static uint32_t bounceOf(const shared::PackedPhoton& photon) {
        return photon.powerDirection.x >> 16;
    }
    /// Octahedral, as lib/pack.glsl packs it.
    static glm::vec3 unpackDirection(uint32_t bits) {
        const glm::vec2 e = glm::unpackSnorm2x16(bits);
        glm::vec3 v(e, 1.0f - std::abs(e.x) - std::abs(e.y));
        const float fold = std::max(-v.z, 0.0f);
        v.x += v.x >= 0.0f ? -fold : fold;
        v.y += v.y >= 0.0f ? -fold : fold;
        return glm::normalize(v);
    }
    /// Whether a triangle of the photon's instance has its place and its normal.
    static bool liesOnATriangle(const scene::SceneSnapshot& snapshot,
                                const shared::PackedPhoton& photon) {
        const auto& instance = snapshot.instances[photon.powerDirection.z];
        const auto& mesh = *snapshot.meshes[instance.mesh].value;
        const glm::vec3 normal = unpackDirection(photon.powerDirection.w);
        for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            std::array<glm::vec3, 3> v;
            for (size_t k = 0; k < 3; ++k)
                v[k] =
                    instance.objectToWorld * glm::vec4(mesh.positions[mesh.indices[i + k]], 1.0f);
            const glm::vec3 own = glm::normalize(glm::cross(v[1] - v[0], v[2] - v[0]));
            const bool onPlane = std::abs(glm::dot(positionOf(photon) - v[0], own)) < 1e-3f;
            if (onPlane && glm::dot(own, normal) > 0.999f) return true;
        }
        return false;
    }
    static float redOf(const shared::PackedPhoton& photon) {
        return glm::unpackHalf2x16(photon.positionPower.w).x;
    }
};

TEST_F(PhotonTrace, StoresPhotonsByPathAndThenByBounceOnSurfaces) {
    const auto snapshot = test::builtinSnapshot("two_rooms");
    const TraceSettings settings{5, true, 3, 20000};
    const Traced traced = trace(snapshot, 1500, settings);
    const uint32_t stored = traced.offsets[traced.split.paths];
    ASSERT_GT(stored, 1500u);
    for (uint32_t path = 0; path < traced.split.paths; ++path) {
        const uint32_t count = traced.offsets[path + 1] - traced.offsets[path];
        ASSERT_LE(count, 5u);
        for (uint32_t i = 0; i < count; ++i) {
            const auto& photon = traced.photons[traced.offsets[path] + i];
            ASSERT_EQ(bounceOf(photon), i + 1);  // the first hit is direct light and is not stored
            const glm::vec3 p = positionOf(photon);
            ASSERT_TRUE(glm::all(glm::greaterThanEqual(p, snapshot.boundsWorld.lower - 1e-3f)));
            ASSERT_TRUE(glm::all(glm::lessThanEqual(p, snapshot.boundsWorld.upper + 1e-3f)));
            ASSERT_LT(photon.powerDirection.z, snapshot.instances.size());
            ASSERT_TRUE(liesOnATriangle(snapshot, photon));
        }
    }
}

TEST_F(PhotonTrace, WithoutRoulettePowerFallsByTheAlbedoAtEveryBounce) {
    scene::SceneSnapshot snapshot;
    test::addInstance(snapshot, test::uvSphere(1.0f, 48, 24), test::lambertian(glm::vec3(0.5f)));
    test::addLight(snapshot, {0, 0, 0}, 0.1f, 64.0f);
    const Traced traced = trace(snapshot, 64, {6, false, 1, 64 * 6});
    ASSERT_EQ(traced.offsets[64], 64u * 6u);
    for (uint32_t i = 0; i < 64 * 6; ++i) {
        const auto& photon = traced.photons[i];
        EXPECT_FLOAT_EQ(redOf(photon) * traced.split.powerScale,
                        std::pow(0.5f, static_cast<float>(bounceOf(photon))));
    }
}

TEST_F(PhotonTrace, EmissiveSurfacesStoreTheirFirstHitAndEmitTheirPower) {
    scene::SceneSnapshot snapshot;
    test::addInstance(snapshot, test::quad({-5, 0, 5}, {5, 0, 5}, {5, 0, -5}, {-5, 0, -5}),
                      test::lambertian(glm::vec3(0.0f)));
    auto glow = test::lambertian(glm::vec3(0.0f));
    glow.emissiveRadiance = glm::vec3(2.0f, 1.0f, 0.5f);
    // One square metre, facing down, and nothing on its back.
    test::addInstance(
        snapshot,
        test::quad({-0.5f, 1, -0.5f}, {0.5f, 1, -0.5f}, {0.5f, 1, 0.5f}, {-0.5f, 1, 0.5f}), glow);
    const Traced traced = trace(snapshot, 4000, {1, true, 1, 8000});
    ASSERT_TRUE(traced.split.anySurface);
    const uint32_t stored = traced.offsets[4000];
    ASSERT_GT(stored, 3000u);
    double power = 0.0;
    for (uint32_t i = 0; i < stored; ++i) {
        ASSERT_EQ(bounceOf(traced.photons[i]), 0u);
        ASSERT_NEAR(positionOf(traced.photons[i]).y, 0.0f, 1e-4f);
        power += static_cast<double>(redOf(traced.photons[i]) * traced.split.powerScale);
    }
    // π·L·A leaves the panel; the floor is wide enough to take nearly all of it.
    EXPECT_GT(power, 0.95 * M_PI * 2.0);
    EXPECT_LE(power, 1.001 * M_PI * 2.0);
}

TEST_F(PhotonTrace, SpotsEmitOnlyInTheirCone) {
    scene::SceneSnapshot snapshot;
    test::addInstance(snapshot, test::uvSphere(2.0f, 64, 32), test::lambertian(glm::vec3(0.5f)));
    test::addLight(snapshot, {0, 0, 0}, 0.01f, 10.0f);
    snapshot.lights[0].directionWorld = {0, -1, 0};
    snapshot.lights[0].cosOuterCone = 0.8f;
    snapshot.lights[0].cosInnerCone = 0.9f;
    auto wanted = request(16, 16, test::lookFrom({0, 0, 0.5f}, {0, -1, 0}));
    wanted.settings.photonPaths = 20000;
    const auto drawn = render(snapshot, wanted, "final");
    // Φ · ((1 − cosInner) + (cosInner − cosOuter)/3) / 2
    EXPECT_NEAR(drawn.report.energy.emitted.x, 10.0 * (0.1 + 0.1 / 3.0) / 2.0, 0.01);
    wanted.settings.pipeline = photon_gi::Pipeline::Direct;
    const auto up = render(snapshot, request(8, 8, test::lookFrom({0, 0, 0}, {0, 1, 0.01f}, 40.0f)),
                           "irradiance_direct");
    for (size_t i = 0; i < up.image.values.size(); i += up.image.channels)
        EXPECT_EQ(up.image.values[i], 0.0f);
}

}  // namespace
}  // namespace lampyris::photons
