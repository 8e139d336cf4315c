// Small scenes of other programs for tests.
#pragma once

#include <fstream>
#include <string>

#include "core/io/foreign/mjcf/read_mjcf.h"
#include "core/io/foreign/urdf.h"
#include "core/io/read_model.h"
#include "support/temporary_folder.h"

namespace trivet::test {

inline void write_text(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

inline Model no_mesh(const std::string& path) { return read_model(path); }

/// Reads a text as a scene of that format.
inline ForeignScene scene_of_mjcf(const std::string& text, const ForeignOptions& options = {}) {
  const TemporaryFolder folder;
  write_text(folder.file("scene.xml"), text);
  return read_mjcf(folder.file("scene.xml"), options, no_mesh);
}
inline ForeignScene scene_of_urdf(const std::string& text, const ForeignOptions& options = {}) {
  const TemporaryFolder folder;
  write_text(folder.file("scene.urdf"), text);
  return read_urdf(folder.file("scene.urdf"), options, no_mesh);
}

inline const ForeignBody* find_body(const ForeignScene& scene, const std::string& name) {
  for (const ForeignBody& body : scene.bodies)
    if (body.name == name) return &body;
  return nullptr;
}

/// Every rule of poses and masses that MuJoCo 2.2.2 knows, too.
inline const char* const kFrames = R"(<mujoco>
  <compiler angle="degree" eulerseq="zyx"/>
  <default>
    <geom density="500"/>
    <default class="part">
      <geom type="box" size="0.1 0.2 0.3"/>
      <joint type="hinge" axis="0 0 1"/>
      <default class="seen"><geom contype="0" conaffinity="0" mass="0.25"/></default>
    </default>
  </default>
  <asset>
    <mesh name="wedge" vertex="0 0 0  1 0 0  0 1 0  0 0 1" scale="0.2 0.4 -0.6" refpos="0.1 0.2 0.3" refquat="1 1 0 0"/>
  </asset>
  <worldbody>
    <geom name="ground" type="plane" size="5 5 0.1"/>
    <body name="turned" pos="1 2 3" euler="30 20 10" childclass="part">
      <joint name="hinge" pos="0.1 0 0" ref="15"/>
      <geom name="inherited"/>
      <geom name="drawn" class="seen" type="sphere" size="0.3" pos="0.1 0 0"/>
      <geom name="capsule" type="capsule" size="0.05" fromto="0 0 0 0.3 0.4 0"/>
      <body name="axes" pos="0 0 1" xyaxes="0 1 0 -1 0.5 0">
        <joint name="slide" type="slide" axis="1 1 0"/>
        <geom type="cylinder" size="0.1 0.2" zaxis="1 1 0"/>
        <geom type="ellipsoid" size="0.1 0.2 0.3" axisangle="1 0 0 90" pos="0.3 0 0"/>
        <body name="ball" pos="0 1 0" zaxis="0 1 -1"><joint type="ball"/><geom type="sphere" size="0.2"/></body>
      </body>
    </body>
    <body name="loose" pos="1 0 5" quat="2 0 0 2">
      <freejoint/>
      <geom type="mesh" mesh="wedge" pos="0.1 0.2 0.3"/>
      <body name="welded" pos="0 0 0.5" euler="0 90 0"><geom type="box" size="0.05 0.1 0.15"/></body>
    </body>
    <body name="given" pos="-1 0 0.5">
      <freejoint/>
      <inertial pos="0.01 0.02 0.03" quat="1 0.2 0 0" mass="2" diaginertia="0.02 0.03 0.04"/>
      <geom type="box" size="0.1 0.1 0.1"/>
    </body>
  </worldbody>
  <keyframe>
    <key name="home" qpos="60 0.3 1 1 0 0 0.5 0.25 2 0.5 0.5 0.5 0.5 -1 0 1 1 0 0 0"/>
  </keyframe>
</mujoco>
)";

}  // namespace trivet::test
