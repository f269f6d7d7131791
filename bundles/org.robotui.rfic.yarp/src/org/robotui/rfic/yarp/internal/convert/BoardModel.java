package org.robotui.rfic.yarp.internal.convert;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointModel;
import org.robotui.data.joint.JointMode;
import org.robotui.data.joint.JointState;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.YarpValue;

/**
 * The joints of a control board, and what becomes of what it says. Those that turn are told in degrees, those that
 * slide in metres.
 *
 * @param chain the name of the board
 * @param joints in the board's order
 */
public record BoardModel(String chain, List<JointModel.Joint> joints) {
  private static final int EXTENDED = 22;
  private static final int VELOCITY = 2;
  private static final int MOTOR_POSITION = 6;
  private static final int MOTOR_VELOCITY = 8;
  private static final int TORQUE = 12;
  private static final int MODES = 18;

  /** With a list of its own. */
  public BoardModel {
    joints = List.copyOf(joints);
  }

  /** Joints of which nothing is known but how many there are. */
  public static BoardModel unknown(String chain, int count) {
    return new BoardModel(chain,
        IntStream.range(0, count)
            .mapToObj(i -> new JointModel.Joint(chain + "_" + i, i, JointModel.Type.REVOLUTE,
                Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY,
                Double.POSITIVE_INFINITY))
            .toList());
  }

  /** As views take it. */
  public JointModel model() {
    return new JointModel(joints,
        List.of(new JointModel.Chain(chain, joints.stream().map(JointModel.Joint::name).toList())));
  }

  /** The number of a joint. */
  public OptionalInt index(String joint) {
    return IntStream.range(0, joints.size()).filter(i -> joints.get(i).name().equals(joint)).findFirst();
  }

  /** A number of the board in SI units. */
  public double si(int joint, double said) {
    return turns(joint) ? Math.toRadians(said) : said;
  }

  /** A number in SI units as the board takes it. */
  public double said(int joint, double si) {
    return turns(joint) ? Math.toDegrees(si) : si;
  }

  private boolean turns(int joint) {
    return joints.get(joint).type() == JointModel.Type.REVOLUTE;
  }

  /** How many joints a message is about. */
  public static int count(Bottle m) {
    return isExtended(m) ? m.get(0).items().size() : m.size();
  }

  private static boolean isExtended(Bottle m) {
    return m.get(0) instanceof Bottle;
  }

  /** Positions, and where the message is the extended one velocities and efforts. */
  public JointState state(Bottle m) {
    Columns columns = new Columns(m);
    List<JointState.Joint> all = new ArrayList<>();
    for (int i = 0; i < joints.size(); i++) {
      all.add(new JointState.Joint(joints.get(i).name(), si(i, columns.position(i)),
          si(i, columns.value(VELOCITY, i)), columns.value(TORQUE, i)));
    }
    return new JointState(all);
  }

  /** How the joints are driven; targets are where we sent them. */
  public JointControl control(Bottle m, Map<Integer, Double> targets) {
    Columns columns = new Columns(m);
    List<JointControl.Joint> all = new ArrayList<>();
    for (int i = 0; i < joints.size(); i++) {
      double position = si(i, columns.position(i));
      Double target = targets.get(i);
      JointControl.Measured measured = new JointControl.Measured(position, si(i, columns.value(MOTOR_POSITION, i)),
          si(i, columns.value(VELOCITY, i)), si(i, columns.value(MOTOR_VELOCITY, i)), columns.value(TORQUE, i),
          Double.NaN, Double.NaN);
      String mode = columns.mode(i);
      all.add(new JointControl.Joint(joints.get(i).name(), measured,
          new JointControl.Reference(target == null ? position : target, 0, 0, 0, 0), drivenBy(mode),
          target != null ? JointControl.Source.COMMANDED
              : mode.equals("hwfa") ? JointControl.Source.SAFE : JointControl.Source.FREE,
          target != null ? "robotui" : "", 0, 0, 0));
    }
    return new JointControl(all);
  }

  private static Set<JointMode> drivenBy(String mode) {
    return switch (mode) {
      case "vel", "veld" -> Set.of(JointMode.VELOCITY);
      case "torq" -> Set.of(JointMode.EFFORT);
      case "idl", "hwfa" -> Set.of();
      default -> Set.of(JointMode.POSITION);
    };
  }

  /** The words of control modes, in the order of the joints; empty where the message has none. */
  public static List<String> modes(Bottle m) {
    Bottle modes = m.size() == EXTENDED ? m.get(MODES).items() : Bottle.of();
    Function<YarpValue, String> word = value -> new YarpValue.Vocab((int) value.number()).word();
    return modes.values().stream().map(word).toList();
  }

  /** What a message says, column by column. */
  private final class Columns {
    private final Bottle m;
    private final List<String> modes;

    Columns(Bottle m) {
      this.m = m;
      this.modes = BoardModel.modes(m);
      if (count(m) != joints.size() || isExtended(m) && m.size() != EXTENDED) {
        throw new IllegalArgumentException(
            chain + " has " + joints.size() + " joints, and a message is about " + count(m));
      }
    }

    double position(int joint) {
      double position = isExtended(m) ? value(0, joint) : m.get(joint).number();
      if (!Double.isFinite(position)) {
        throw new IllegalArgumentException(joints.get(joint).name() + " is at " + position);
      }
      return position;
    }

    double value(int column, int joint) {
      return isExtended(m) && m.get(column + 1).text().equals("ok") ? m.get(column).items().get(joint).number()
          : Double.NaN;
    }

    String mode(int joint) {
      return joint < modes.size() ? modes.get(joint) : "";
    }
  }
}
