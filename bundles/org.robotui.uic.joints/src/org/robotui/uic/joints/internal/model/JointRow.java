package org.robotui.uic.joints.internal.model;

import java.util.OptionalInt;
import org.robotui.api.port.SourceId;
import org.robotui.data.joint.JointState.Joint;

/**
 * A joint, at one moment.
 *
 * @param source which port it comes from
 * @param joint name and newest values, SI units, NaN where unknown
 * @param unit of its position
 * @param span from where to where it moves
 * @param ageSeconds how old the values are
 * @param stale true where it stopped coming
 * @param fields how the robot's message calls its values
 * @param index in the robot's message, where it is there
 */
public record JointRow(SourceId source, Joint joint, JointUnit unit, Span span, double ageSeconds, boolean stale,
    Fields fields, OptionalInt index) {
  /** How the values of the joint with an index are called. */
  public enum Fields {
    /** As in {@code position[3]}. */
    ARRAYS,
    /** As in {@code joints[3].position}. */
    RECORDS;

    String path(String field, int at) {
      return this == ARRAYS ? field + "[" + at + "]" : "joints[" + at + "]." + field;
    }
  }

  /** What identifies it, so that it stays selected while others come and go. */
  public String key() {
    return source + " " + joint.name();
  }

  /** Where the position lies within the span, 0 to 1, or NaN. */
  public double share() {
    return span.share(joint.position());
  }
}
