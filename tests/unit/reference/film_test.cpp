#include "reference/film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/small_scenes.h"

namespace lampyris::reference {
namespace {

const PixelRays kCamera(test::lookFrom({0, 0, 1}, {0, 0, 0}), 1, 1);

Settings plain() {
    return {};
}

Pixel white() {
    Pixel pixel;
    pixel.surface.emplace();
    pixel.surface->albedo = glm::vec3(math::kPi);  // radiance is irradiance
    pixel.surface->emission = glm::vec3(0.5f);
    pixel.depthMetres = 3.0f;
    return pixel;
}

LightSplit light(float direct, float indirect, float gloss = 0.0f) {
    LightSplit split;
    split.irradianceDirect = glm::vec3(direct);
    split.irradianceIndirect = glm::vec3(indirect);
    split.specularDirect = glm::vec3(gloss);
    return split;
}

TEST(Film, DevelopsTheMeanOfItsSamples) {
    Film film(1, 1, 2);
    film.setGuide(0, white());
    film.add(0, 0, light(1.0f, 10.0f, 100.0f));
    film.add(0, 1, light(3.0f, 30.0f, 300.0f));
    const Rendered r = film.develop(2, kCamera, plain());
    EXPECT_NEAR(r.irradianceDirect.values[0], 2.0f, 1e-5f);
    EXPECT_NEAR(r.irradianceIndirect.values[1], 20.0f, 1e-5f);
    EXPECT_NEAR(r.direct.values[2], 202.0f, 1e-4f);
    EXPECT_NEAR(r.indirect.values[2], 20.0f, 1e-5f);
    EXPECT_NEAR(r.final.values[0], 222.5f, 1e-4f) << "with the surface's own glow";
    EXPECT_EQ(r.depth.values[0], 3.0f);
    EXPECT_EQ(r.samplesPerPixel, 2u);
}

TEST(Film, DrawsTheDiscInPlaceOfWhatIsBehindIt) {
    Film film(1, 1, 1);
    Pixel pixel = white();
    pixel.disc = glm::vec3(7.0f);
    film.setGuide(0, pixel);
    film.add(0, 0, light(1.0f, 1.0f));
    const Rendered r = film.develop(1, kCamera, plain());
    EXPECT_EQ(r.final.values[0], 7.0f);
    EXPECT_NEAR(r.direct.values[0], 1.0f, 1e-6f);
}

TEST(Film, ErrorOfIndependentSamplesIsThatOfTheirMean) {
    std::mt19937 random(4);
    std::normal_distribution<float> noise(5.0f, 2.0f);
    constexpr uint32_t kSamples = 50;  // not a multiple of the sequences
    constexpr size_t kPixels = 4000;
    Film film(kPixels, 1, kSequences);
    double squares = 0.0, estimates = 0.0;
    for (size_t pixel = 0; pixel < kPixels; ++pixel) {
        film.setGuide(pixel, white());
        double mean = 0.0;
        for (uint32_t i = 0; i < kSamples; ++i) {
            const float value = noise(random);
            mean += static_cast<double>(value) / kSamples;
            film.add(pixel, i % kSequences, light(value, 0.0f));
        }
        squares += (mean - 5.0) * (mean - 5.0) / kPixels;
        const auto error = static_cast<double>(film.standardError(pixel, kSamples).x);
        estimates += error * error / kPixels;
    }
    EXPECT_NEAR(estimates, 4.0 / kSamples, 0.05 * 4.0 / kSamples);
    EXPECT_NEAR(squares / estimates, 1.0, 0.1);
    EXPECT_NEAR(film.relativeError(kSamples), 2.0 / std::sqrt(kSamples) / 5.0, 0.003);
}

TEST(Film, NoErrorIsKnownOfOneSequenceOrNone) {
    Film film(1, 1, 1);
    film.setGuide(0, white());
    EXPECT_EQ(film.relativeError(0), 0.0);
    film.add(0, 0, light(1.0f, 0.0f));
    film.add(0, 0, light(2.0f, 0.0f));
    EXPECT_EQ(film.standardError(0, 2), glm::vec3(0.0f));
    EXPECT_EQ(film.develop(0, kCamera, plain()).samplesPerPixel, 0u);
}

}  // namespace
}  // namespace lampyris::reference
