package org.robotui.ros2;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.robotui.rtps.Durability;
import org.robotui.rtps.History;
import org.robotui.rtps.Liveliness;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Reliability;

/** The qualities of service that ROS 2 has names for, and sentences about them. */
public final class QosProfiles {

  /** What programs use that say nothing else: reliable, volatile, ten messages. */
  public static final Qos DEFAULT = Qos.reliable(10);

  /** Data of sensors: best effort, volatile, five messages. */
  public static final Qos SENSOR_DATA = Qos.bestEffort(5);

  /** Requests and replies: reliable, volatile, ten messages. */
  public static final Qos SERVICES = Qos.reliable(10);

  /** Requests and replies about parameters: reliable, volatile, a thousand messages. */
  public static final Qos PARAMETERS = Qos.reliable(1000);

  /** Changes of parameters: reliable, volatile, a thousand messages. */
  public static final Qos PARAMETER_EVENTS = Qos.reliable(1000);

  /** The log: reliable, late readers get what is at most ten seconds old. */
  public static final Qos LOG = Qos.reliable(1000).with(Durability.TRANSIENT_LOCAL)
      .withTimes(Qos.INFINITE, Duration.ofSeconds(10));

  /** Simulated time: best effort, the newest. */
  public static final Qos CLOCK = Qos.bestEffort(1);

  /** What late readers get as well, such as maps, descriptions and fixed transforms: reliable, the newest. */
  public static final Qos LATCHED = Qos.reliable(1).with(Durability.TRANSIENT_LOCAL);

  /** Fixed transforms: as {@link #LATCHED}. */
  public static final Qos TF_STATIC = LATCHED;

  /** Transforms: reliable, volatile, a hundred messages. */
  public static final Qos TF = Qos.reliable(100);

  /** Commands of motion: reliable, and only the newest is ever sent again, so that nothing late is. */
  public static final Qos COMMANDS = Qos.reliable(1);

  private QosProfiles() {}

  /**
   * A quality in words.
   *
   * @param qos what is offered or requested
   * @return such as {@code reliable, volatile, keeps the last 10}
   */
  public static String sentence(Qos qos) {
    List<String> words = new ArrayList<>();
    words.add(qos.reliability() == Reliability.RELIABLE ? "reliable" : "best effort");
    words.add(qos.durability() == Durability.VOLATILE ? "volatile" : "kept for late subscribers");
    words.add(qos.history() == History.KEEP_ALL ? "keeps all" : "keeps the last " + qos.depth());
    bound(words, "a message at least every ", qos.deadline());
    bound(words, "of use for ", qos.lifespan());
    if (qos.liveliness() != Liveliness.AUTOMATIC || !Qos.infinite(qos.livelinessLease())) {
      bound(words, "alive if it says so within ", qos.livelinessLease());
    }
    return String.join(", ", words);
  }

  private static void bound(List<String> words, String what, Duration time) {
    if (!Qos.infinite(time)) {
      words.add(what + time.toMillis() + " ms");
    }
  }
}
