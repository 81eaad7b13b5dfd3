// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_REMEDY_WORDS_H
#define HTLOOPS_REMEDY_WORDS_H

#include "mend/mended_soup.h"
#include "read/soup_diagnosis.h"

#include <string>
#include <vector>

namespace htloops {

/// which options would make a refused soup fit, found out by trying: "--repair mends this"; or that
/// none would. `given` are the remedies that have been applied to no avail.
std::string
words_on_remedy(const Soup& soup, const std::vector<Defect>& defects, const Remedies& given);

} // namespace htloops

#endif // HTLOOPS_REMEDY_WORDS_H
