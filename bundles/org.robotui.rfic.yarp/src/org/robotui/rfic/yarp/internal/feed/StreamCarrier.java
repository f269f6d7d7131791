package org.robotui.rfic.yarp.internal.feed;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.robotui.yarp.wire.YarpCarrier;

/** By which carrier a port of the robot says its messages. */
public enum StreamCarrier {
  /** Nothing is acknowledged. */
  FAST_TCP,
  /** Each message is acknowledged. */
  TCP,
  /** Datagrams to our port. */
  UDP,
  /** Datagrams to a group. */
  MCAST,
  /** Pictures as JPEG files, for which we connect to the port. */
  MJPEG;

  /** What users write for it. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** What users may write. */
  public static List<String> words() {
    return Arrays.stream(values()).map(StreamCarrier::word).toList();
  }

  /** What a word stands for. */
  public static StreamCarrier of(String word) {
    return valueOf(word.toUpperCase(Locale.ROOT));
  }

  /** What a port is told; where it is told nothing because it has pictures, and where it has none, the usual one. */
  YarpCarrier told() {
    return this == MJPEG ? YarpCarrier.FAST_TCP : YarpCarrier.valueOf(name());
  }
}
