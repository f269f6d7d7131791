package org.robotui.message.tf;

import java.util.Objects;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.message.ros.geometry_msgs.Transform;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.std_msgs.Header;

/**
 * Where a child frame is in its parent frame at a time.
 *
 * @param parent the parent frame, without leading slash
 * @param child the child frame, without leading slash
 * @param stampNanos the time, nanoseconds of the sender's clock
 * @param parentFromChild the transform, as sent: its rotation may be no rotation
 */
public record FrameTransform(String parent, String child, long stampNanos, RigidTransform parentFromChild) {

  /** Strips leading slashes, which frames had in the old tf. */
  public FrameTransform {
    parent = withoutSlash(parent);
    child = withoutSlash(child);
    Objects.requireNonNull(parentFromChild, "parentFromChild");
  }

  /**
   * The name of a frame as libraries of both generations of ROS use it.
   *
   * @param frame as sent
   * @return without leading slashes
   */
  public static String withoutSlash(String frame) {
    int start = 0;
    while (start < frame.length() && frame.charAt(start) == '/') {
      start++;
    }
    return frame.substring(start);
  }

  /**
   * Reads a message.
   *
   * @param message the message
   * @return what it says
   */
  public static FrameTransform of(TransformStamped message) {
    return new FrameTransform(message.header().frameId(), message.childFrameId(), message.header().stamp(),
        rigid(message.transform()));
  }

  /**
   * Makes a message.
   *
   * @return the message, with sequence number 0
   */
  public TransformStamped toMessage() {
    return new TransformStamped(new Header(0, stampNanos, parent), child, message(parentFromChild));
  }

  private static RigidTransform rigid(Transform message) {
    var t = message.translation();
    var r = message.rotation();
    return new RigidTransform(new Vector3(t.x(), t.y(), t.z()), new Quaternion(r.x(), r.y(), r.z(), r.w()));
  }

  private static Transform message(RigidTransform transform) {
    Vector3 t = transform.translation();
    Quaternion r = transform.rotation();
    return new Transform(
        new org.robotui.message.ros.geometry_msgs.Vector3(t.x(), t.y(), t.z()),
        new org.robotui.message.ros.geometry_msgs.Quaternion(r.x(), r.y(), r.z(), r.w()));
  }
}
