// `lampyris compare`: how far a picture is from its reference, and where.
#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <utility>

#include "command.h"
#include "core/image_io.h"
#include "evaluation/comparison.h"
#include "options.h"

namespace lampyris::sandbox {
namespace {

using evaluation::Picture;

struct CompareOptions {
    std::filesystem::path image, reference, map;
    core::DisplayTransform display;
};

bool isExr(const std::filesystem::path& path) {
    return path.extension() == ".exr";
}

core::Result<Picture> readPicture(const std::filesystem::path& path,
                                  const core::DisplayTransform& display) {
    if (isExr(path)) {
        TRY(const core::Image image, core::readExr(path));
        return evaluation::fromLinear(path.string(), image, display);
    }
    if (path.extension() != ".png")
        return core::error("{}: the file's name must end in .png or .exr", path.string());
    TRY(core::DisplayImage image, core::readPng(path));
    return evaluation::fromDisplay(path.string(), std::move(image));
}

core::Result<std::array<Picture, 2>> readBoth(const CompareOptions& o) {
    TRY(Picture image, readPicture(o.image, o.display));
    TRY(Picture reference, readPicture(o.reference, o.display));
    // A PNG's light is exposed and cut off at white; an EXR's beside it must be so too.
    if (isExr(o.image) != isExr(o.reference)) {
        image = evaluation::fromDisplay(image.name, std::move(image.display));
        reference = evaluation::fromDisplay(reference.name, std::move(reference.display));
    }
    return std::array{std::move(image), std::move(reference)};
}

core::Result<void> checkMap(const std::filesystem::path& map) {
    if (map.empty() || map.extension() == ".png") return {};
    return core::error("--map {}: the file must end in .png", map.string());
}

core::Result<void> compare(const CompareOptions& o) {
    TRY_VOID(checkTarget(o.map));
    TRY(const auto pictures, readBoth(o));
    TRY(const auto comparison, evaluation::compare(pictures[0], pictures[1]));
    if (!o.map.empty()) TRY_VOID(core::writePng(o.map, evaluation::drawMaps(comparison)));
    for (const evaluation::Figure& figure : evaluation::figuresOf(comparison))
        fmt::print("{} {:.6g}\n", figure.name, figure.value);
    return {};
}

}  // namespace

void addCompare(CLI::App& program, Command& called) {
    auto* app = program.add_subcommand("compare", "How far a picture is from its reference");
    const auto options = std::make_shared<CompareOptions>();
    app->add_option("A", options->image, "the picture, a .png or .exr file")->required();
    app->add_option("B", options->reference, "its reference, of the same size")->required();
    app->add_option("--map", options->map,
                    "write where they differ: squares, SSIM and FLIP from left to right")
        ->type_name("OUT.png");
    addDisplayOptions(*app, options->display);
    app->footer(
        "--exposure and --tonemap act on EXR files. relMSE is of linear light without exposure\n"
        "where both files are EXR, else of the light that display values stand for.");
    app->callback([options, &called] {
        called.check = [options] { return checkMap(options->map); };
        called.run = [options] { return compare(*options); };
    });
}

}  // namespace lampyris::sandbox
