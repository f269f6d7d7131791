package org.robotui.rtps.internal.discovery;

import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.Locators;
import org.robotui.rtps.ParticipantInfo;

/** About how much memory what peers say of themselves takes, in bytes. */
final class Weight {

  private static final int OBJECTS = 400;

  private static final int LOCATOR = 48;

  private static final int PARTITION = 64;

  private Weight() {}

  static long of(ParticipantInfo info) {
    return 2L * OBJECTS + 2L * info.name().length() + info.userData().remaining() + locators(info.metatraffic())
        + locators(info.userTraffic());
  }

  static long of(EndpointInfo info) {
    long partitions = info.qos().partitions().stream().mapToLong(name -> PARTITION + 2L * name.length()).sum();
    return OBJECTS + 2L * (info.topic().length() + info.type().length()) + info.userData().remaining()
        + locators(info.locators()) + partitions;
  }

  private static long locators(Locators places) {
    return (long) LOCATOR * (places.unicast().size() + places.multicast().size());
  }
}
