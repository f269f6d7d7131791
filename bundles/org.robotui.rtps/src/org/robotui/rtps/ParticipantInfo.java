package org.robotui.rtps;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.OptionalInt;

/**
 * What a participant says of itself.
 *
 * @param guid which one
 * @param vendor who made its library
 * @param version what it speaks
 * @param name its name; may be empty
 * @param domain its domain, if it says so
 * @param lease how long it is taken to be there when it is not heard
 * @param builtInEndpoints one bit for each endpoint of discovery and the like that it has
 * @param metatraffic where its endpoints of discovery hear
 * @param userTraffic where its endpoints hear that say nothing of their own
 * @param userData bytes of its application, read-only; ROS 2 puts {@code enclave=/;} there
 */
public record ParticipantInfo(Guid guid, VendorId vendor, ProtocolVersion version, String name, OptionalInt domain,
    Duration lease, int builtInEndpoints, Locators metatraffic, Locators userTraffic, ByteBuffer userData) {

  /** Copies the bytes. */
  public ParticipantInfo {
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
}
