#include "view/given_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "overlay/setting_list.h"

namespace lampyris::sandbox::view {

void overrideBy(const ViewOptions& options, ViewState& state) {
    const photon_gi::Settings asked = settingsOf(options);
    const photon_gi::Settings usual = settingsOf(Options{});
    const bool preset = options.given.count("--quality") + options.given.count("--pipeline") +
                            options.given.count("--gather") >
                        0;
    if (preset) state.settings = asked;  // these say what all others begin with
    for (const overlay::SettingInfo& info : overlay::settingList()) {
        std::string option = fmt::format("--{}", info.name);
        std::replace(option.begin(), option.end(), ' ', '-');
        const bool given = options.given.count(option) > 0;
        const auto take = [&](auto field) {
            if (given || asked.*field != usual.*field) state.settings.*field = asked.*field;
        };
        std::visit(take, info.field);
    }
    if (options.given.count("--exposure") > 0)
        state.display.exposureEv = options.display.exposureEv;
    if (options.given.count("--tonemap") > 0) state.display.tonemap = options.display.tonemap;
    if (options.given.count("--overlay") > 0) state.overlay = options.overlay;
    if (options.given.count("--camera") > 0) state.cameraToWorld.reset();
    if (options.renderScale) state.renderScale = *options.renderScale;
}

}  // namespace lampyris::sandbox::view
