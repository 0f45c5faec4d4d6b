// `lampyris view`: the game scene in a window, until Escape or the window manager closes it.
#include <memory>

#include "command.h"
#include "live_budget.h"
#include "view/viewer.h"

namespace lampyris::sandbox {
namespace {

constexpr const char* kDefaultScene = "courtyard";

core::Result<void> checkFiles(const ViewOptions& options) {
    TRY_VOID(checkOutputs(options));
    for (const auto& path : {options.flicker, options.settings, options.record})
        TRY_VOID(checkTarget(path));
    if (!options.screenshots.empty()) TRY_VOID(checkTarget(options.screenshots / "screenshot.png"));
    return {};
}

core::Result<void> checkView(const ViewOptions& options) {
    TRY_VOID(checkCall(options));
    TRY_VOID(checkBudget(options, options.budgetMilliseconds));
    if (options.budgetMilliseconds && !(options.record.empty() && options.replay.empty()))
        return core::error("--budget-ms goes by the clock; --record and --replay must not");
    if (!options.record.empty() && !options.replay.empty())
        return core::error("--record and --replay: a replay has no inputs of its own to record");
    return checkDistinct({options.output, options.report, options.graph, options.trace,
                          options.flicker, options.settings, options.record, options.replay});
}

/// A record replayed must give the same bytes.
bool isRepeatable(const ViewOptions& options) {
    return !options.record.empty() || !options.replay.empty();
}

core::Result<void> viewScene(const ViewOptions& options) {
    TRY_VOID(checkFiles(options));
    view::ViewState state;
    if (!options.settings.empty()) TRY_VOID(view::readState(options.settings, state));
    const graph::Extent size = options.size ? *options.size : state.size.value_or(sizeOf(options));
    TRY(ShaderWatch shaders, ShaderWatch::create(options.shaders));
    TRY(window::Window window,
        window::Window::create({"lampyris: " + options.scene, size.width, size.height}));
    TRY(const std::unique_ptr<FrameLoop> loop,
        FrameLoop::open(options, {.presentable = true, .repeatable = isRepeatable(options)}));
    TRY(window::Presenter presenter,
        window::Presenter::create(loop->device(), window, window::Encoding::Display));
    return view::Viewer(options, window, *loop, presenter, shaders).run();
}

void addFileOptions(CLI::App& app, ViewOptions& o) {
    app.add_option("--flicker", o.flicker,
                   "write how much each frame differs from the last; prints flicker and lag")
        ->type_name("FILE.csv");
    app.add_option("--settings", o.settings,
                   "settings, camera and panels: read at the start, written at the end")
        ->type_name("FILE.json");
    app.add_option("--record", o.record, "write all that the user does")->type_name("FILE");
    app.add_option("--replay", o.replay, "do what was recorded, then end")->type_name("FILE");
    app.add_option("--render-scale", o.renderScale,
                   "picture pixels a window pixel, an axis (1; on a CPU without --size, 0.25)")
        ->check(finite(view::kLeastRenderScale, 1.0));
    app.add_option("--budget-ms", o.budgetMilliseconds,
                   "keep indirect light at so many device milliseconds: gives up paths, radius, "
                   "rays and resolution as need be")
        ->check(finite(0.01, 1e6));
    app.add_option("--shaders", o.shaders,
                   "reload shaders when their files change (those that the program was built "
                   "from); off: do not")
        ->type_name("FOLDER|off");
    app.add_option("--screenshots", o.screenshots, "where F12 puts them (here)")
        ->type_name("FOLDER");
}

}  // namespace

void addView(CLI::App& program, Command& called) {
    auto* app = program.add_subcommand(
        "view",
        "Frames in a window, with panels over them; see sandbox/view/README.md for the keys");
    const auto options = std::make_shared<ViewOptions>();
    options->scene = kDefaultScene;
    app->add_option("scene", options->scene,
                    "a built-in name, or a .gltf or .glb file (courtyard)");
    addFrameOptions(*app, *options);
    addPictureOptions(*app, *options);
    addFileOptions(*app, *options);
    app->add_flag("--overlay,!--no-overlay", options->overlay, "panels at the start (on; F1)");
    app->callback([app, options, &called] {
        for (const CLI::Option* option : app->get_options())
            if (option->count() > 0) options->given.insert(option->get_name());
        called.check = [options] { return checkView(*options); };
        called.run = [options] { return viewScene(*options); };
    });
}

}  // namespace lampyris::sandbox
