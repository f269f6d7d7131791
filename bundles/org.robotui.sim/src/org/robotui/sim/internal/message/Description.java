package org.robotui.sim.internal.message;

import java.util.Locale;
import org.robotui.geometry.Quaternion;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.sim.internal.model.RobotModel;
import org.robotui.sim.internal.robot.Head;

/**
 * What the robot is made of, as URDF: solids only, so that nobody needs files for it. Links are named as the frames
 * are, with the robot's namespace, and fixed joints are the static transforms.
 */
final class Description {
  private static final String DARK = "dark";
  private static final String LIGHT = "light";
  private static final String ACCENT = "accent";
  private static final String GLASS = "glass";

  private final Frames frames;
  private final RobotModel robot;
  private final StringBuilder text = new StringBuilder(8192);

  private Description(Frames frames, RobotModel robot) {
    this.frames = frames;
    this.robot = robot;
  }

  /** @param fixed where the sensors sit */
  static String of(Frames frames, RobotModel robot, TFMessage fixed) {
    return new Description(frames, robot).write(fixed);
  }

  private String write(TFMessage fixed) {
    text.append("<?xml version=\"1.0\"?>\n<robot name=\"").append(robot.name()).append("\">\n");
    material(DARK, "0.20 0.22 0.25 1");
    material(LIGHT, "0.85 0.87 0.89 1");
    material(ACCENT, "0.16 0.48 0.78 1");
    material(GLASS, "0.05 0.07 0.10 1");
    if (robot.head()) {
      tower();
    } else {
      disc();
    }
    wheel(frames.leftWheel(), "left_wheel_joint", 1);
    wheel(frames.rightWheel(), "right_wheel_joint", -1);
    if (robot.head()) {
      head();
    }
    for (TransformStamped transform : fixed.transforms()) {
      sensor(transform.childFrameId());
      joint(transform);
    }
    return text.append("</robot>\n").toString();
  }

  /** A round chassis with a ring of sonars and a deck, and a mast for head, lidar and camera. */
  private void tower() {
    open(frames.base());
    inertial(18, 0.2, 0.6, 0.6, 0.55);
    cylinder(robot.radius(), 0.14, 0, 0, 0.12, DARK);
    cylinder(0.205, 0.06, 0, 0, 0.22, GLASS);
    cylinder(robot.radius(), 0.02, 0, 0, 0.26, LIGHT);
    box(0.06, 0.10, 0.51, -0.08, 0, 0.525, LIGHT);
    box(0.20, 0.05, 0.02, 0.01, 0, 0.40, LIGHT);
    box(0.24, 0.05, 0.02, 0.03, 0, 0.59, LIGHT);
    box(0.13, 0.06, 0.02, -0.04, 0, 0.77, LIGHT);
    box(0.08, 0.04, 0.02, -0.13, 0, 0.68, LIGHT);
    collision();
    close();
  }

  /** A flat disc close to the floor, with a post for camera and antenna. */
  private void disc() {
    open(frames.base());
    inertial(3.5, 0.05, 0.03, 0.03, 0.05);
    cylinder(robot.radius(), 0.08, 0, 0, 0.06, DARK);
    cylinder(robot.radius() * 0.92, 0.01, 0, 0, 0.105, LIGHT);
    cylinder(0.05, 0.012, -0.04, 0, 0.111, ACCENT);
    box(0.03, 0.08, 0.12, robot.lens().forward() - 0.03, 0, 0.17, LIGHT);
    box(0.02, 0.02, 0.12, -0.6 * robot.radius(), 0, 0.17, LIGHT);
    collision();
    close();
  }

  private void collision() {
    add("<collision><origin xyz=\"0 0 %s\"/><geometry><cylinder radius=\"%s\" length=\"%s\"/></geometry></collision>",
        robot.height() / 2, robot.radius(), robot.height());
  }

  private void wheel(String link, String joint, int side) {
    open(link);
    inertial(1, 0, 0.003, 0.005, 0.003);
    add("<visual><origin rpy=\"%s 0 0\"/><geometry><cylinder radius=\"%s\" length=\"0.04\"/></geometry><material name=\"%s\"/></visual>",
        Math.PI / 2, robot.wheels().radius(), GLASS);
    box(1.2 * robot.wheels().radius(), 0.042, 0.02, 0, 0, 0, ACCENT);
    close();
    add("<joint name=\"%s\" type=\"continuous\"><parent link=\"%s\"/><child link=\"%s\"/><origin xyz=\"0 %s %s\"/><axis xyz=\"0 1 0\"/></joint>",
        joint, frames.base(), link, side * robot.wheels().track() / 2, robot.wheels().radius());
  }

  private void head() {
    open(frames.pan());
    cylinder(0.045, 0.04, 0, 0, 0, DARK);
    close();
    open(frames.tilt());
    box(0.10, 0.17, 0.08, 0, 0, 0.01, ACCENT);
    cylinderForward(0.022, 0.02, 0.05, 0.045, 0.01);
    cylinderForward(0.022, 0.02, 0.05, -0.045, 0.01);
    close();
    turning("pan_joint", frames.base(), frames.pan(), Head.HEIGHT, "0 0 1", 1.2);
    turning("tilt_joint", frames.pan(), frames.tilt(), Head.NECK, "0 1 0", 0.6);
  }

  private void turning(String joint, String parent, String child, double height, String axis, double reach) {
    add("<joint name=\"%s\" type=\"revolute\"><parent link=\"%s\"/><child link=\"%s\"/><origin xyz=\"0 0 %s\"/><axis xyz=\"%s\"/>"
        + "<limit lower=\"%s\" upper=\"%s\" effort=\"2\" velocity=\"1.5\"/></joint>", joint, parent, child, height,
        axis, -reach, reach);
  }

  private void sensor(String link) {
    open(link);
    if (link.equals(frames.laser())) {
      cylinder(0.04, 0.06, 0, 0, 0, GLASS);
    } else if (link.equals(frames.lidar())) {
      cylinder(0.05, 0.08, 0, 0, 0, GLASS);
    } else if (link.equals(frames.camera())) {
      box(0.03, 0.12, 0.04, -0.015, 0, 0, DARK);
    } else if (link.equals(frames.satellites())) {
      cylinder(0.04, 0.02, 0, 0, 0, LIGHT);
    } else if (link.startsWith(frames.sonars())) {
      cylinderForward(0.016, 0.01, 0, 0, 0);
    }
    close();
  }

  private void joint(TransformStamped transform) {
    var t = transform.transform().translation();
    var q = transform.transform().rotation();
    Quaternion turn = new Quaternion(q.x(), q.y(), q.z(), q.w());
    add("<joint name=\"%s_joint\" type=\"fixed\"><parent link=\"%s\"/><child link=\"%s\"/><origin xyz=\"%s %s %s\" rpy=\"%s %s %s\"/></joint>",
        transform.childFrameId(), transform.header().frameId(), transform.childFrameId(), t.x(), t.y(), t.z(),
        turn.roll(), turn.pitch(), turn.yaw());
  }

  private void material(String name, String rgba) {
    add("<material name=\"%s\"><color rgba=\"%s\"/></material>", name, rgba);
  }

  private void open(String link) {
    add("<link name=\"%s\">", link);
  }

  private void close() {
    add("</link>");
  }

  private void inertial(double mass, double height, double ixx, double iyy, double izz) {
    add("<inertial><origin xyz=\"0 0 %s\"/><mass value=\"%s\"/><inertia ixx=\"%s\" iyy=\"%s\" izz=\"%s\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>",
        height, mass, ixx, iyy, izz);
  }

  private void cylinder(double radius, double length, double x, double y, double z, String material) {
    add("<visual><origin xyz=\"%s %s %s\"/><geometry><cylinder radius=\"%s\" length=\"%s\"/></geometry><material name=\"%s\"/></visual>",
        x, y, z, radius, length, material);
  }

  private void cylinderForward(double radius, double length, double x, double y, double z) {
    add("<visual><origin xyz=\"%s %s %s\" rpy=\"0 %s 0\"/><geometry><cylinder radius=\"%s\" length=\"%s\"/></geometry><material name=\"%s\"/></visual>",
        x, y, z, Math.PI / 2, radius, length, LIGHT);
  }

  private void box(double length, double width, double height, double x, double y, double z, String material) {
    add("<visual><origin xyz=\"%s %s %s\"/><geometry><box size=\"%s %s %s\"/></geometry><material name=\"%s\"/></visual>",
        x, y, z, length, width, height, material);
  }

  private void add(String line, Object... values) {
    text.append("  ").append(String.format(Locale.ROOT, line, values)).append('\n');
  }
}
