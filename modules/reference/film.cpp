#include "reference/film.h"

#include <cmath>

#include "reference/smooth_indirect.h"

namespace lampyris::reference {
namespace {

float mean(const glm::vec3& rgb) {
    return (rgb.x + rgb.y + rgb.z) / 3.0f;
}

void put(core::Image& image, size_t pixel, const glm::vec3& value) {
    for (uint32_t c = 0; c < 3; ++c) image.values[3 * pixel + c] = value[static_cast<int>(c)];
}

glm::vec3 get(const core::Image& image, size_t pixel) {
    return {image.values[3 * pixel], image.values[3 * pixel + 1], image.values[3 * pixel + 2]};
}

/// Samples that sequence `s` of `sequences` got of `samples` in turn.
double samplesOf(uint32_t s, uint32_t sequences, uint32_t samples) {
    const uint32_t each = samples / sequences;
    return static_cast<double>(s < samples % sequences ? each + 1 : each);
}

/// Variance of the mean of all samples, from the sums of independent sequences.
template <typename SumOf>
double varianceOfMean(uint32_t sequences, uint32_t samples, const SumOf& sumOf) {
    if (sequences < 2 || samples < sequences) return 0.0;
    double total = 0.0;
    for (uint32_t s = 0; s < sequences; ++s) total += sumOf(s);
    const double average = total / samples;
    double spread = 0.0;
    for (uint32_t s = 0; s < sequences; ++s) {
        const double n = samplesOf(s, sequences, samples);
        const double off = sumOf(s) / n - average;
        spread += n / samples * off * off;
    }
    return spread / (sequences - 1);
}

}  // namespace

Film::Film(uint32_t width, uint32_t height, uint32_t sequences)
    : width_(width),
      height_(height),
      sequences_(sequences),
      sums_(size_t{width} * height),
      guides_(size_t{width} * height) {}

void Film::setGuide(size_t pixel, const Pixel& seen) {
    PixelGuide& guide = guides_[pixel];
    guide.hasDisc = seen.disc.has_value();
    guide.disc = seen.disc.value_or(glm::vec3(0.0f));
    if (!seen.surface) return;
    guide.surface = true;
    guide.albedo = seen.surface->albedo;
    guide.normal = seen.surface->shading;
    guide.position = seen.surface->position;
    guide.emission = seen.surface->emission;
    guide.depthMetres = seen.depthMetres;
    guide.instance = seen.instance;
}

void Film::add(size_t pixel, uint32_t sequence, const LightSplit& light) {
    PixelSums& sums = sums_[pixel];
    sums.light.irradianceDirect += light.irradianceDirect;
    sums.light.specularDirect += light.specularDirect;
    sums.light.irradianceIndirect += light.irradianceIndirect;
    sums.light.specularIndirect += light.specularIndirect;
    sums.radiance[sequence] +=
        guides_[pixel].albedo / math::kPi * (light.irradianceDirect + light.irradianceIndirect) +
        light.specularDirect + light.specularIndirect;
    sums.indirect[sequence] += mean(light.irradianceIndirect);
}

glm::vec3 Film::standardError(size_t pixel, uint32_t samples) const {
    glm::vec3 error(0.0f);
    for (int c = 0; c < 3; ++c)
        error[c] = static_cast<float>(
            std::sqrt(varianceOfMean(sequences_, samples, [&](uint32_t s) -> double {
                return sums_[pixel].radiance[s][c];
            })));
    return error;
}

float Film::indirectVariance(size_t pixel, uint32_t samples) const {
    return static_cast<float>(varianceOfMean(
        sequences_, samples, [&](uint32_t s) -> double { return sums_[pixel].indirect[s]; }));
}

double Film::relativeError(uint32_t samples) const {
    double square = 0.0, total = 0.0;
    for (size_t i = 0; i < sums_.size(); ++i) {
        const glm::dvec3 error(standardError(i, samples));
        square += glm::dot(error, error) / 3.0;
        for (uint32_t s = 0; s < sequences_; ++s) total += mean(sums_[i].radiance[s]);
    }
    const auto pixels = static_cast<double>(sums_.size());
    const double average = samples > 0 ? total / samples / pixels : 0.0;
    return average > 0.0 ? std::sqrt(square / pixels) / average : 0.0;
}

core::Image Film::irradianceIndirect(uint32_t samples) const {
    core::Image image(width_, height_, 3);
    const float share = samples > 0 ? 1.0f / static_cast<float>(samples) : 0.0f;
    for (size_t i = 0; i < sums_.size(); ++i)
        put(image, i, sums_[i].light.irradianceIndirect * share);
    return image;
}

core::Image Film::smoothed(const core::Image& irradiance, uint32_t samples, const PixelRays& camera,
                           uint32_t threads) const {
    std::vector<SmoothGuide> guides(guides_.size());
    for (size_t i = 0; i < guides.size(); ++i) {
        const PixelGuide& g = guides_[i];
        guides[i] = {
            g.position, g.normal, g.depthMetres * camera.footprint(), indirectVariance(i, samples),
            g.instance, g.surface};
    }
    return smoothIndirect(irradiance, guides, threads);
}

Rendered Film::develop(uint32_t samples, const PixelRays& camera, const Settings& settings) const {
    Rendered out;
    for (core::Image* image : {&out.final, &out.direct, &out.indirect, &out.irradianceDirect,
                               &out.albedo, &out.normal, &out.position, &out.error})
        *image = core::Image(width_, height_, 3);
    out.depth = core::Image(width_, height_, 1);
    out.irradianceIndirect = irradianceIndirect(samples);
    if (settings.smoothIndirect)
        out.irradianceIndirect =
            smoothed(out.irradianceIndirect, samples, camera, settings.threads);
    const float share = samples > 0 ? 1.0f / static_cast<float>(samples) : 0.0f;
    for (size_t i = 0; i < sums_.size(); ++i) {
        const LightSplit& light = sums_[i].light;
        const PixelGuide& guide = guides_[i];
        const glm::vec3 matt = guide.albedo / math::kPi;
        const glm::vec3 irradiance = light.irradianceDirect * share;
        const glm::vec3 direct = matt * irradiance + light.specularDirect * share;
        const glm::vec3 indirect =
            matt * get(out.irradianceIndirect, i) + light.specularIndirect * share;
        put(out.irradianceDirect, i, irradiance);
        put(out.direct, i, direct);
        put(out.indirect, i, indirect);
        put(out.final, i, guide.hasDisc ? guide.disc : direct + indirect + guide.emission);
        put(out.albedo, i, guide.albedo);
        put(out.normal, i, guide.normal);
        put(out.position, i, guide.position);
        put(out.error, i, standardError(i, samples));
        out.depth.values[i] = guide.depthMetres;
    }
    out.relativeError = relativeError(samples);
    out.samplesPerPixel = samples;
    return out;
}

}  // namespace lampyris::reference
