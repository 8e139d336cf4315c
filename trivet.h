// All of Trivet that programs embed, without pictures: link trivet::ops.
//
//   scene.add(object)                  a name, a Model, its Shape      core/scene, core/model
//   perform(scene, operation), put()   the operations                  ops/operations/perform.h
//   arrange(scene, arrangement)        places by relations             ops/arrange/arrange.h
//   check_scene(scene)                 judge a scene from its poses    ops/check/check.h
//   stability(scene)                   does it stand as a whole?       ops/stability/stability.h
//   read_layout(), run_layout()        layouts as files                ops/files/layout
//   Session                            undo, redo and a journal        ops/session/session.h
//
// Geometry alone is trivet::geometry: core/contact/first_contact.h and
// core/exact/interpenetration.h.
#pragma once

#include "core/contact/first_contact.h"
#include "core/exact/interpenetration.h"
#include "core/model/exported_floats.h"
#include "core/model/model.h"
#include "core/scene/scene.h"
#include "core/scene/transaction.h"
#include "ops/arrange/arrange.h"
#include "ops/check/check.h"
#include "ops/files/layout/layout.h"
#include "ops/files/layout/run.h"
#include "ops/files/report/report.h"
#include "ops/files/report/scene_file.h"
#include "ops/operations/live_move.h"
#include "ops/operations/perform.h"
#include "ops/session/restore.h"
#include "ops/session/session.h"
#include "ops/stability/stability.h"
