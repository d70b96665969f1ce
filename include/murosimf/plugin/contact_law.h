/// contact_law.h - for plug-ins with a law of contact with the ground (`registries.contacts`) or between bodies
/// (`registries.body_contacts`): force and linearisation of contacts.
#pragma once

#include "murosimf/collision/contact_laws/body_contact_law.h"
#include "murosimf/collision/contact_laws/contact_law.h"
#include "murosimf/collision/contact_laws/contact_law_parts.h"
#include "murosimf/plugin/interface.h"
