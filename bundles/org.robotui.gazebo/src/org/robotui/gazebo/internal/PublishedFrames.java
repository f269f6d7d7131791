package org.robotui.gazebo.internal;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/** Makes the parts of what is published; where all count, with a number. For the thread of the loop. */
final class PublishedFrames {
  private final String address;
  private final boolean counted;
  private final Map<String, Long> numbers = new HashMap<>();

  PublishedFrames(String address, boolean counted) {
    this.address = address;
    this.counted = counted;
  }

  Frames of(String topic, String type, byte[] payload) {
    return counted ? Frames.of(topic, address, payload, type, counted(topic))
        : Frames.of(topic, address, payload, type);
  }

  /** When it was published, in milliseconds of a clock of this machine, and the how manieth it is of its topic. */
  private byte[] counted(String topic) {
    long number = numbers.merge(topic, 1L, Long::sum) - 1;
    return ByteBuffer.allocate(2 * Long.BYTES).order(ByteOrder.nativeOrder())
        .putLong(TimeUnit.NANOSECONDS.toMillis(System.nanoTime())).putLong(number).array();
  }
}
