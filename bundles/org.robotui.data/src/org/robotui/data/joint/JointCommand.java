package org.robotui.data.joint;

import java.util.List;
import java.util.Set;
import org.robotui.data.Delivery;
import org.robotui.data.Late;
import org.robotui.data.command.Motion;
import org.robotui.data.command.MotionLimits;
import org.robotui.data.internal.Check;

/**
 * What joints shall do. It holds until it expires; then, and for joints that it does not name, the robot's control
 * holds.
 *
 * @param joints one entry a joint; none is: command nothing any more
 */
@Delivery(late = Late.NONE)
public record JointCommand(List<Joint> joints) implements Motion<JointCommand> {
  /** All joints are let go: the robot's control holds them where they are. */
  public static final JointCommand ZERO = new JointCommand(List.of());

  /**
   * One joint.
   *
   * @param name its name in the robot's model
   * @param reference numbers that are not meant by the modes may be anything finite
   * @param modes what of the reference is meant
   */
  public record Joint(String name, JointControl.Reference reference, Set<JointMode> modes) {
    /**
     * Checks that all numbers are finite.
     *
     * @param name its name
     * @param reference the numbers
     * @param modes what of them is meant
     */
    public Joint {
      modes = Set.copyOf(modes);
      Check.finite(reference.position(), name + " position");
      Check.finite(reference.velocity(), name + " velocity");
      Check.finite(reference.effort(), name + " effort");
      Check.finite(reference.stiffness(), name + " stiffness");
      Check.finite(reference.damping(), name + " damping");
    }

    private Joint within(MotionLimits limits) {
      // Which joints slide is for the robot's control to know, which has a limit for each: here the looser of both
      // holds.
      double limit = Math.max(limits.linear(), limits.angular());
      double velocity = Math.clamp(reference.velocity(), -limit, limit);
      return velocity == reference.velocity() ? this
          : new Joint(name, new JointControl.Reference(reference.position(), velocity,
              reference.effort(), reference.stiffness(), reference.damping()), modes);
    }
  }

  /**
   * Copies the list.
   *
   * @param joints one entry a joint
   */
  public JointCommand {
    joints = List.copyOf(joints);
  }

  /**
   * Keep a position.
   *
   * @param joint its name
   * @param position radians or metres
   * @return the command
   */
  public static Joint position(String joint, double position) {
    return new Joint(joint, new JointControl.Reference(position, 0, 0, 0, 0), Set.of(JointMode.POSITION));
  }

  @Override
  public JointCommand stopped() {
    return ZERO;
  }

  @Override
  public JointCommand within(MotionLimits limits) {
    return new JointCommand(joints.stream().map(j -> j.within(limits)).toList());
  }
}
