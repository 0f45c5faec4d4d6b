#include "assets/gltf.h"

#include <algorithm>
#include <exception>

#include "assets/gltf_check.h"
#include "assets/gltf_source.h"
#include "core/file.h"

namespace lampyris::assets {
namespace {

/// The typed view of a checked document. It is written out from what was checked, so that tinygltf
/// cannot read it in another way; bytes are kept from it.
core::Result<tinygltf::Model> parseDocument(Json json, const GltfContext& context) {
    json.erase("buffers");
    json.erase("images");
    const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    tinygltf::TinyGLTF parser;
    tinygltf::Model document;
    std::string error;
    std::string warning;
    if (parser.LoadASCIIFromString(&document, &error, &warning, text.c_str(),
                                   static_cast<unsigned>(text.size()), ""))
        return document;
    std::replace(error.begin(), error.end(), '\n', ' ');
    return context.error("", "{}", error);
}

/// Extensions that a file can be drawn without, for one line of warning.
void warnOfIgnored(GltfContext& context, const std::vector<std::string>& used) {
    std::string ignored;
    for (const std::string& name : used)
        if (!understands(name)) ignored += (ignored.empty() ? "" : ", ") + name;
    if (!ignored.empty()) context.warn("", "is drawn without {}", ignored);
}

core::Result<Model> readModel(std::span<const uint8_t> bytes,
                              const std::optional<std::filesystem::path>& folder,
                              GltfContext& context) {
    TRY(GltfContainer container, openContainer(bytes, context));
    TRY_VOID(checkHeader(container.json, context));
    TRY(std::vector<GltfBuffer> buffers, readBuffers(container, folder, context));
    TRY_VOID(checkDocument(container.json, buffers, context));
    Json images = Json::object();
    images["images"] = container.json.value("images", Json::array());
    TRY(tinygltf::Model document, parseDocument(std::move(container.json), context));
    warnOfIgnored(context, document.extensionsUsed);

    GltfSource source{std::move(document), std::move(images), std::move(buffers), folder, context};
    Model model;
    model.name = std::filesystem::path(context.name()).filename().string();
    TRY(const auto needs, readMaterials(source, model));
    TRY(const auto primitives, readMeshes(source, needs, model));
    TRY_VOID(readNodes(source, primitives, model));
    TRY_VOID(readSkins(source, model));
    readAnimations(source, model);
    return model;
}

/// What `body` gives, or an error for an exception: memory ran out, or a library threw.
template <typename Body>
core::Result<Model> withoutExceptions(const std::string& name, const Body& body) {
    try {
        return body();
    } catch (const std::exception& exception) {
        return core::error("{}: cannot be read: {}", name, exception.what());
    }
}

}  // namespace

core::Result<Model> parseGltf(std::span<const uint8_t> bytes, const std::string& name,
                              const std::optional<std::filesystem::path>& baseDirectory,
                              const GltfLimits& limits) {
    return withoutExceptions(name, [&]() -> core::Result<Model> {
        GltfContext context(name, limits);
        return readModel(bytes, baseDirectory, context);
    });
}

core::Result<Model> loadGltf(const std::filesystem::path& path, const GltfLimits& limits) {
    return withoutExceptions(path.string(), [&]() -> core::Result<Model> {
        TRY(const std::vector<uint8_t> bytes, core::readFile(path));
        return parseGltf(bytes, path.string(), path.parent_path(), limits);
    });
}

}  // namespace lampyris::assets
