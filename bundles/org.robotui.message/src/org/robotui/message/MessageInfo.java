package org.robotui.message;

import java.util.Objects;

/**
 * The identity of a message type, as ROS peers exchange it in their connection headers.
 *
 * @param type the type's full name, such as {@code sensor_msgs/LaserScan}, or {@code *} for any type
 * @param md5 the MD5 sum of the definition as ROS computes it (32 hex digits), or {@code *} for any
 * @param definition the full text of the definition with all its dependencies; empty if it is not known
 */
public record MessageInfo(String type, String md5, String definition) {

  /** The wildcard ROS uses for "any type" and "any MD5 sum". */
  public static final String ANY = "*";

  /** Checks that nothing is missing. */
  public MessageInfo {
    Objects.requireNonNull(type, "type");
    Objects.requireNonNull(md5, "md5");
    Objects.requireNonNull(definition, "definition");
  }

  /**
   * The identity that accepts every message.
   *
   * @return type and MD5 sum {@code *}, without a definition
   */
  public static MessageInfo any() {
    return new MessageInfo(ANY, ANY, "");
  }

  /**
   * Whether a peer that announces the given MD5 sum speaks this type.
   *
   * @param peerMd5 the peer's MD5 sum
   * @return true if the sums are equal or one of them is the wildcard
   */
  public boolean accepts(String peerMd5) {
    return ANY.equals(md5) || ANY.equals(peerMd5) || md5.equals(peerMd5);
  }
}
