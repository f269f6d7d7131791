package org.robotui.rtps;

import java.nio.ByteBuffer;

/**
 * What a participant says of one of its writers or readers.
 *
 * @param guid which one
 * @param kind whether it writes or reads
 * @param topic the name of its topic as it is on the wire, such as {@code rt/chatter}
 * @param type the name of its type as it is on the wire, such as {@code std_msgs::msg::dds_::String_}
 * @param qos what it offers or requests
 * @param userData bytes of its application, read-only; ROS 2 puts {@code typehash=RIHS01_...;} there
 * @param locators where it hears; nothing: where its participant hears
 * @param wantsInlineQos whether a reader wants the QoS with each sample
 */
public record EndpointInfo(Guid guid, EndpointKind kind, String topic, String type, Qos qos, ByteBuffer userData,
    Locators locators, boolean wantsInlineQos) {

  /** Copies the bytes. */
  public EndpointInfo {
    userData = UserBytes.copy(userData);
  }

  /**
   * The bytes of its application.
   *
   * @return a view of its own for each call
   */
  @Override
  public ByteBuffer userData() {
    return userData.duplicate();
  }

  /**
   * Its participant.
   *
   * @return the GUID of the participant that it belongs to
   */
  public Guid participant() {
    return guid.participant();
  }

  /**
   * Whether its topic has instances that keys tell apart.
   *
   * @return true with keys; topics of ROS 2 have none
   */
  public boolean keyed() {
    return guid.entity().keyed();
  }
}
