// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_MODELS_H
#define PARALLEL_ASPECTS_URDF_MODELS_H

#include "parallel_aspects/urdf/mechanism.h"

/// The shipped robots, without a file: urdf/NAME.urdf and config/robots/NAME.yaml as they were when the
/// library was built. docs/robots.md says where their dimensions come from.
namespace parallel_aspects::models {

SharedMechanism bipod();           ///< T2, two struts
SharedMechanism five_bar();        ///< T2, the five-bar of Chablat and Wenger
SharedMechanism three_prr();       ///< SE2, three sliders
SharedMechanism three_rpr();       ///< SE2, three struts
SharedMechanism three_rrr();       ///< SE2, three cranks
SharedMechanism delta();           ///< T3, the Delta
SharedMechanism linear_delta();    ///< T3, three sliders
SharedMechanism agile_eye();       ///< SO3, the Agile Eye
SharedMechanism spherical_3rrr();  ///< SO3, three spherical cranks
SharedMechanism hexa();            ///< SE3, six cranks
SharedMechanism six_pus();         ///< SE3, six sliders
SharedMechanism stewart();         ///< SE3, the Stewart platform, six struts

}  // namespace parallel_aspects::models

#endif  // PARALLEL_ASPECTS_URDF_MODELS_H
