package org.robotui.urdf;

/** Texts that tests read. */
public final class Samples {
  /** A column that turns, a slide on it, a finger that mimics the slide, and a free cube. */
  public static final String ARM = """
      <?xml version="1.0"?>
      <robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
        <material name="blue"><color rgba="0 0 1 0.5"/></material>
        <link name="base">
          <inertial><origin xyz="0 0 0.1"/><mass value="4"/><inertia ixx="1" iyy="2" izz="3"/></inertial>
          <visual><geometry><cylinder radius="0.1" length="0.2"/></geometry><material name="blue"/></visual>
          <visual name="plate"><origin xyz="0 0 -0.1" rpy="0 0 1.5707963267948966"/><geometry><box size="1 2 0.1"/></geometry></visual>
          <collision><geometry><sphere radius="0.3"/></geometry></collision>
        </link>
        <link name="column"/>
        <link name="slide"><visual><geometry><mesh filename="package://parts/slide.stl" scale="0.001 0.001 0.001"/></geometry></visual></link>
        <link name="finger"/>
        <link name="cube"/>
        <joint name="lift" type="prismatic">
          <parent link="column"/><child link="slide"/><origin xyz="0 0 1"/><axis xyz="0 0 2"/>
          <limit lower="0" upper="0.5" effort="100" velocity="0.2"/>
        </joint>
        <joint name="turn" type="continuous"><parent link="base"/><child link="column"/><origin xyz="0 0 0.5"/><axis xyz="0 0 1"/></joint>
        <joint name="grip" type="prismatic"><parent link="slide"/><child link="finger"/><axis xyz="1 0 0"/><mimic joint="lift" multiplier="-2" offset="0.1"/></joint>
        <joint name="free" type="floating"><parent link="base"/><child link="cube"/></joint>
        <transmission name="ignored"/>
      </robot>
      """;

  /** Groups of the arm. */
  public static final String SEMANTICS = """
      <robot name="arm">
        <group name="all"><group name="column"/><joint name="grip"/></group>
        <group name="column"><chain base_link="base" tip_link="slide"/></group>
        <group_state name="up" group="column"><joint name="lift" value="0.4"/></group_state>
        <disable_collisions link1="base" link2="column" reason="Adjacent"/>
        <group name="odd"><joint name="none"/></group>
      </robot>
      """;

  private Samples() {}
}
