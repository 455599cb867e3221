// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core.h"
#include "errors.h"

PYBIND11_MODULE(core, module) {
    module.doc() = "Kernel of the NMGS Workbench without CAD: arrays in, arrays out.";
    nmgs::bindings::register_errors();
    nmgs::bindings::bind_blocking(module);
    nmgs::bindings::bind_plc(module);
    nmgs::bindings::bind_formats(module);
    nmgs::bindings::bind_convert(module);
    nmgs::bindings::bind_mesh(module);
    nmgs::bindings::bind_quality(module);
}
