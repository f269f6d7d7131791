package org.robotui.rfic.player.internal.convert;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointMode;
import org.robotui.data.joint.JointModel;
import org.robotui.data.joint.JointState;
import org.robotui.player.interfaces.Actarray;

/** Joints of rows of actuators. Player's have numbers: their names are made of the device's. */
public final class Joints {
  private static final int LINEAR = 1;

  private Joints() {}

  public static String name(String device, int index) {
    return device.replace(':', '_') + "_" + index;
  }

  /** What drives them is a current, which is no effort. */
  public static JointState state(Actarray.State m, String device) {
    return new JointState(IntStream.range(0, m.actuators().size()).mapToObj(i -> {
      Actarray.Actuator a = m.actuators().get(i);
      return new JointState.Joint(name(device, i), a.position(), a.speed(), Double.NaN);
    }).toList());
  }

  /** The bounds of an arm's joints, in one chain. */
  public static JointModel model(Actarray.Geometry m, String device) {
    List<JointModel.Joint> joints = new ArrayList<>();
    for (int i = 0; i < m.actuators().size(); i++) {
      Actarray.Link link = m.actuators().get(i);
      JointModel.Type type = link.type() == LINEAR ? JointModel.Type.PRISMATIC : JointModel.Type.REVOLUTE;
      double speed = link.speed() > 0 ? link.speed() : Double.POSITIVE_INFINITY;
      joints.add(new JointModel.Joint(name(device, i), i, type, Math.min(link.min(), link.max()),
          Math.max(link.min(), link.max()), speed,
          Double.POSITIVE_INFINITY));
    }
    return new JointModel(joints,
        List.of(new JointModel.Chain(device, joints.stream().map(JointModel.Joint::name).toList())));
  }

  /**
   * How the joints are driven.
   *
   * @param m what they are at
   * @param device their device
   * @param targets where we sent joints, by their numbers
   */
  public static JointControl control(Actarray.State m, String device, Map<Integer, Double> targets) {
    return new JointControl(IntStream.range(0, m.actuators().size()).mapToObj(i -> {
      Actarray.Actuator a = m.actuators().get(i);
      Optional<Double> target = Optional.ofNullable(targets.get(i));
      JointControl.Measured measured = new JointControl.Measured(a.position(), Double.NaN, a.speed(), Double.NaN,
          Double.NaN, Double.NaN, Double.NaN);
      JointControl.Reference reference = new JointControl.Reference(target.orElse((double) a.position()), 0, 0, 0, 0);
      return new JointControl.Joint(name(device, i), measured, reference, Set.of(JointMode.POSITION),
          target.isPresent() ? JointControl.Source.COMMANDED : JointControl.Source.HOLDING,
          target.isPresent() ? "robotui" : "", 0, 0, 0);
    }).toList());
  }

  /** The number of a commanded joint. */
  public static int index(JointCommand.Joint joint, String device, int joints) {
    return IntStream.range(0, joints).filter(i -> name(device, i).equals(joint.name())).findFirst().orElseThrow(
        () -> new IllegalArgumentException(
            device + " has no joint '" + joint.name() + "', but " + joints + " from " + name(device, 0)));
  }
}
