/// \file The truth that frames are measured against: path tracing on the CPU.
///   in   SceneSnapshot, a camera, settings      out   linear radiance and its parts
/// No sampling and no traversal is shared with the GPU's code. Rays go through pixel centres.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include "core/image.h"
#include "core/result.h"
#include "scene/snapshot.h"

namespace lampyris::reference {

enum class Transport : uint8_t {
    Diffuse,  ///< GGX at the seen surface in direct light, Lambertian bounces: what the GPU does
    Full,     ///< GGX at every bounce
};

constexpr uint32_t kAllBounces = 0xffffffffu;
constexpr uint32_t kMostSamplesPerPixel = 1u << 19u;

struct Settings {
    uint32_t width = 1280, height = 720;
    uint32_t samplesPerPixel = 64;      ///< at most; 0 leaves light out
    float maxError = 0.0f;              ///< stops once Rendered::relativeError is no more; 0: never
    uint32_t maxBounces = kAllBounces;  ///< 0 is direct light alone
    Transport transport = Transport::Diffuse;
    bool smoothIndirect = false;  ///< see smooth_indirect.h
    uint32_t seed = 1;
    uint32_t threads = 0;  ///< 0: as many as there are cores. The bytes are the same for any.
};

/// What a render gives. Radiance in W/(m² sr), irradiance in W/m² without albedo; background is 0.
struct Rendered {
    core::Image final;     ///< direct + indirect + the surface's own glow, lights' discs before it
    core::Image direct;    ///< from the sphere lights, diffuse and GGX
    core::Image indirect;  ///< all other light, that of emissive surfaces included
    core::Image irradianceDirect, irradianceIndirect;
    core::Image albedo;            ///< base colour · (1 − metallic)
    core::Image normal, position;  ///< world space, metres; shading normal
    core::Image depth;             ///< metres along the camera's axis, one channel
    core::Image error;             ///< standard error of direct + indirect, before any smoothing

    double relativeError = 0.0;  ///< root of the mean square of error ÷ mean of direct + indirect
    uint32_t samplesPerPixel = 0;  ///< taken
    uint64_t rays = 0;             ///< traced, shadow rays included
    double seconds = 0.0;          ///< of tracing, without building the BVH

    /// By the name that `--output-node` takes; null where there is none.
    [[nodiscard]] const core::Image* image(std::string_view name) const;
};

/// The names that Rendered::image knows.
constexpr std::array<std::string_view, 10> kImageNames{"final",
                                                       "direct",
                                                       "indirect",
                                                       "irradiance_direct",
                                                       "irradiance_indirect",
                                                       "albedo",
                                                       "normal",
                                                       "position",
                                                       "depth",
                                                       "error"};

/// Whether an image of that name shows light, so that it needs samples.
[[nodiscard]] bool showsLight(std::string_view name);

/// Called now and then, from any one thread at a time: samples taken, and those asked for, of all
/// pixels together. False stops the render.
using ProgressFunction = std::function<bool(uint64_t done, uint64_t total)>;

/// A scene that is ready to be rendered: what its renders share, whatever their cameras.
class BuiltScene {
 public:
    /// Errors: a scene that memory does not hold.
    static core::Result<BuiltScene> build(const scene::SceneSnapshot& snapshot);
    ~BuiltScene();
    BuiltScene(BuiltScene&&) noexcept;
    BuiltScene& operator=(BuiltScene&&) noexcept;

    /// As the function of that name.
    [[nodiscard]] core::Result<Rendered> render(const scene::SnapshotCamera& camera,
                                                const Settings& settings,
                                                const ProgressFunction& progress = {}) const;

 private:
    struct Parts;
    explicit BuiltScene(std::unique_ptr<const Parts> parts);
    std::unique_ptr<const Parts> parts_;
};

/// Same arguments, same bytes. Errors: a picture or scene that memory does not hold; stopped.
core::Result<Rendered> render(const scene::SceneSnapshot& snapshot,
                              const scene::SnapshotCamera& camera, const Settings& settings,
                              const ProgressFunction& progress = {});

}  // namespace lampyris::reference
