package org.robotui.uic.jointcontrol.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.robotui.api.port.SourceId;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointControl.Measured;
import org.robotui.data.joint.JointControl.Reference;
import org.robotui.data.joint.JointControl.Source;
import org.robotui.data.joint.JointMode;
import org.robotui.data.joint.JointModel;
import org.robotui.data.joint.JointModel.Type;
import org.robotui.testkit.FakeUicContext;

/** Robots for tests and for people to look at. */
public final class Robots {
  public static final Set<JointMode> POSITION = Set.of(JointMode.POSITION);
  public static final Set<JointMode> IMPEDANCE = Set.of(JointMode.POSITION, JointMode.STIFFNESS, JointMode.DAMPING);

  private static final SourceId CONTROL = new SourceId("base", "control");
  private static final SourceId MODEL = new SourceId("base", "model");
  private static final double[] ARM = {0.31, -0.72, 1.2, -2.1, 0.02, 1.57, 0.79};

  private Robots() {}

  /** An arm with a gripper: turning joints, a sliding one, one without limits, and one in no chain. */
  public static JointModel armModel() {
    List<JointModel.Joint> joints = new ArrayList<>();
    IntStream.rangeClosed(1, 7)
        .forEach(i -> joints.add(new JointModel.Joint("arm_" + i, i, Type.REVOLUTE, -2.6, 2.6, 2.1, i < 5 ? 87 : 12)));
    joints.add(new JointModel.Joint("finger", 8, Type.PRISMATIC, 0, 0.04, 0.1, 60));
    joints.add(new JointModel.Joint("turntable", 9, Type.REVOLUTE, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY,
        1.5, 40));
    return new JointModel(joints, List.of(
        new JointModel.Chain("arm", IntStream.rangeClosed(1, 7).mapToObj(i -> "arm_" + i).toList()),
        new JointModel.Chain("gripper", List.of("finger"))));
  }

  /** The arm, well driven. */
  public static JointControl arm() {
    return arm(Source.COMMANDED, "communication");
  }

  /** The arm with one source and owner. */
  public static JointControl arm(Source source, String owner) {
    List<JointControl.Joint> joints = new ArrayList<>();
    IntStream.rangeClosed(1, 7).forEach(i -> joints.add(joint("arm_" + i, ARM[i - 1], ARM[i - 1] + 0.004, 0.03 * i,
        -3.2 * i, i < 5 ? IMPEDANCE : POSITION, source, owner)));
    joints.add(joint("finger", 0.0213, 0.0215, 0, 11.5, POSITION, source, owner));
    joints.add(joint("turntable", 1.9, 1.9, 0, 0.4, POSITION, source, owner));
    return new JointControl(joints);
  }

  /** A joint that is well. */
  public static JointControl.Joint joint(String name, double measured, double commanded, double velocity, double effort,
      Set<JointMode> modes,
      Source source, String owner) {
    return new JointControl.Joint(name, new Measured(measured, measured + 0.001, velocity, velocity, effort, 41, 38),
        new Reference(commanded, 0, 0, 120, 4), modes, source, owner, 0, 0, 0);
  }

  /** The arm, of which each joint has another trouble. */
  public static JointControl troubled() {
    List<JointControl.Joint> joints = new ArrayList<>(arm().joints());
    joints.set(1, with(joints.get(1), Source.HOLDING, "homing", 0, 17, 0));
    joints.set(2, with(joints.get(2), Source.SAFE, "homing", 0, 0, 3));
    joints.set(3, with(joints.get(3), Source.SAFE, "homing", 0x24, 0, 0));
    joints.set(4, joint("arm_5", 2.59, 2.6, 0.2, 11.9, IMPEDANCE, Source.COMMANDED, "sine"));
    joints.set(5, joint("arm_6", Double.NaN, 1.57, Double.NaN, Double.NaN, POSITION, Source.COMMANDED, "sine"));
    joints.set(6, with(joints.get(6), Source.FREE, "", 0, 0, 0));
    return new JointControl(joints);
  }

  private static JointControl.Joint with(JointControl.Joint j, Source source, String owner, long faults, long clamped,
      long rejected) {
    return new JointControl.Joint(j.name(), j.measured(), j.reference(), j.modes(), source, owner, faults, clamped,
        rejected);
  }

  /** A humanoid of thirty joints in five chains. */
  public static JointModel humanoidModel() {
    List<JointModel.Chain> chains =
        List.of(chain("left_arm", "L", 7), chain("right_arm", "R", 7), chain("torso", "WaistJ", 3),
            chain("left_leg", "LLeg", 6), chain("right_leg", "RLeg", 6));
    List<JointModel.Joint> joints = new ArrayList<>();
    chains.forEach(chain -> chain.joints()
        .forEach(name -> joints.add(new JointModel.Joint(name, joints.size() + 1, Type.REVOLUTE, -1.5, 2, 5.7, 55))));
    joints.add(new JointModel.Joint("neck", 30, Type.REVOLUTE, -1, 1, 3, 4));
    return new JointModel(joints, chains);
  }

  private static JointModel.Chain chain(String name, String prefix, int count) {
    return new JointModel.Chain(name, IntStream.rangeClosed(1, count).mapToObj(i -> prefix + i).toList());
  }

  /** The humanoid while it homes. */
  public static JointControl humanoid() {
    List<JointModel.Joint> joints = humanoidModel().joints();
    return new JointControl(IntStream.range(0, joints.size())
        .mapToObj(i -> joint(joints.get(i).name(), Math.sin(i * 0.7), Math.sin(i * 0.7) * 0.97,
            0.4 * Math.cos(i), 20 * Math.sin(i * 1.3), IMPEDANCE, Source.COMMANDED, "homing"))
        .toList());
  }

  /** Puts a robot into the inputs. */
  public static void put(FakeUicContext context, JointModel model, JointControl control) {
    context.input(JointControlPorts.MODEL).put(MODEL, model, 0, Optional.empty());
    context.input(JointControlPorts.CONTROL).put(CONTROL, control, 0, Optional.empty());
  }
}
