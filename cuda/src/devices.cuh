// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_CUDA_DEVICES_CUH
#define HTL_CUDA_DEVICES_CUH

namespace htl_cuda {

/// the number of a device on which the solver runs; the current one for a negative number. Throws
/// `No_device_exception` if there is none of that number, or if it lacks what the solver needs.
int usable_device(int number);

} // namespace htl_cuda

#endif // HTL_CUDA_DEVICES_CUH
