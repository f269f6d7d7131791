package org.robotui.data.joint;

import java.util.List;
import org.robotui.data.Conflation;
import org.robotui.data.Delivery;
import org.robotui.data.Keyed;
import org.robotui.data.Late;
import org.robotui.data.internal.Merge;

/**
 * Joints by name. A quantity that the robot does not report is empty.
 *
 * @param joints one entry a joint
 */
@Delivery(conflation = Conflation.KEYED, late = Late.ALL_KEYS)
public record JointState(List<Joint> joints) implements Keyed<JointState> {
  /**
   * One joint.
   *
   * @param name its name in the robot's model
   * @param position radians or metres, NaN where unknown
   * @param velocity radians or metres per second, NaN where unknown
   * @param effort newton metres or newton, NaN where unknown
   */
  public record Joint(String name, double position, double velocity, double effort) {}

  /**
   * Copies the list.
   *
   * @param joints one entry a joint
   */
  public JointState {
    joints = List.copyOf(joints);
  }

  @Override
  public JointState over(JointState older) {
    return new JointState(Merge.byKey(older.joints, joints, Joint::name));
  }

  @Override
  public int keys() {
    return joints.size();
  }

  @Override
  public JointState last(int most) {
    return new JointState(Merge.last(joints, most));
  }
}
