/// \file The reference image: read from a file, or rendered by the CPU reference.
#pragma once

#include "thesis/study.h"

namespace lampyris::sandbox::thesis {

/// The call's --reference; or what a former run left in the folder; or the mean of two renders of
/// half the samples each, all bounces, indirect light smoothed along surfaces, kept in the folder.
/// How far the halves are from each other stands in `about`. Errors: a file of another size, or one
/// that is no EXR.
core::Result<Truth> findTruth(const Study& study, const std::string& scene);

}  // namespace lampyris::sandbox::thesis
