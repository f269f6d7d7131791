package org.robotui.xbot.internal;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.robotui.xbot.JointReference;

/** Writes references as the supervisor reads them. */
public final class References {
  private final Layout layout;
  private final int size;
  private final ByteBuffer bytes;

  /** Room for all joints there can be. */
  public References(Layout layout) {
    this.layout = layout;
    this.size = layout.size("JointCommand");
    this.bytes = ByteBuffer.allocateDirect(size * layout.number("joints")).order(ByteOrder.LITTLE_ENDIAN);
  }

  /**
   * Writes those of some joints; all others are told nothing.
   *
   * @param references of joints below the count
   * @param joints how many the robot has
   * @return the bytes, valid until the next call
   */
  public ByteBuffer write(List<JointReference> references, int joints) {
    for (int i = 0; i < joints * size; i++) {
      bytes.put(i, (byte) 0);
    }
    references.forEach(this::write);
    return bytes;
  }

  private void write(JointReference joint) {
    int base = joint.joint() * size;
    bytes.putDouble(base + at("position"), joint.reference().position());
    bytes.putDouble(base + at("velocity"), joint.reference().velocity());
    bytes.putDouble(base + at("effort"), joint.reference().effort());
    bytes.putDouble(base + at("stiffness"), joint.reference().stiffness());
    bytes.putDouble(base + at("damping"), joint.reference().damping());
    bytes.put(base + at("mode"), (byte) joint.mode());
  }

  private int at(String field) {
    return layout.offset("JointCommand", field);
  }
}
