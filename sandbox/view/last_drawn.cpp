#include "view/last_drawn.h"

namespace lampyris::sandbox::view {

void LastDrawn::drew(const photon_gi::Settings& asked, const photon_gi::Settings& given) {
    asked_ = asked;
    given_ = given;
}

std::optional<photon_gi::Settings> LastDrawn::insteadOf(const photon_gi::Settings& asked,
                                                        const photon_gi::Settings& given) {
    if (asked != asked_) return asked_;
    if (given == given_ || asked_ == given_) return std::nullopt;
    asked_ = given_;  // once: these are asked for from now on
    return asked_;
}

}  // namespace lampyris::sandbox::view
