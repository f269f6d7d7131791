package org.robotui.rtps;

import java.time.Duration;
import java.util.List;

/**
 * What a writer offers and a reader requests.
 *
 * @param reliability whether lost samples are sent again
 * @param durability what a late reader gets
 * @param history what is kept
 * @param depth how many samples are kept with {@link History#KEEP_LAST}, at least 1
 * @param deadline how long it takes at most until the next sample; {@link #INFINITE} for any time
 * @param lifespan how long a sample is of use; {@link #INFINITE} for ever
 * @param liveliness who says that a writer is alive
 * @param livelinessLease how long a writer is alive that nobody speaks for; {@link #INFINITE} for ever
 * @param ownership whether several writers may write one instance
 * @param partitions names or patterns ({@code *}, {@code ?}); without any, the one without a name
 * @param representations the encoding that a writer uses, as the first one; all that a reader accepts; at least one
 */
public record Qos(Reliability reliability, Durability durability, History history, int depth, Duration deadline,
    Duration lifespan, Liveliness liveliness, Duration livelinessLease, Ownership ownership, List<String> partitions,
    List<DataRepresentation> representations) {

  /** No bound: the longest time that can be written on the wire. */
  public static final Duration INFINITE = Duration.ofSeconds(Integer.MAX_VALUE, 999_999_999);

  /** Copies the lists and checks the bounds. */
  public Qos {
    partitions = List.copyOf(partitions);
    representations = List.copyOf(representations);
    if (depth < 1 || representations.isEmpty()) {
      throw new IllegalArgumentException("a depth of " + depth + " with " + representations);
    }
    deadline = bounded(deadline);
    lifespan = bounded(lifespan);
    livelinessLease = bounded(livelinessLease);
  }

  private static Duration bounded(Duration time) {
    if (time.isNegative()) {
      throw new IllegalArgumentException("a time of " + time);
    }
    return infinite(time) ? INFINITE : time;
  }

  /**
   * What the specification has for an endpoint of which nothing is said: best effort, volatile, the newest sample.
   *
   * @return the default
   */
  public static Qos standard() {
    return new Qos(Reliability.BEST_EFFORT, Durability.VOLATILE, History.KEEP_LAST, 1, INFINITE, INFINITE,
        Liveliness.AUTOMATIC, INFINITE, Ownership.SHARED, List.of(), List.of(DataRepresentation.XCDR1));
  }

  /**
   * What ROS 2 uses unless it is told otherwise, with another depth.
   *
   * @param depth how many samples are kept
   * @return reliable, volatile
   */
  public static Qos reliable(int depth) {
    return standard().with(Reliability.RELIABLE).withDepth(depth);
  }

  /**
   * What ROS 2 uses for data of sensors.
   *
   * @param depth how many samples are kept
   * @return best effort, volatile
   */
  public static Qos bestEffort(int depth) {
    return standard().withDepth(depth);
  }

  /**
   * Why a writer and a reader do not match.
   *
   * @param offered by the writer
   * @param requested by the reader
   * @return one sentence for each reason, for a person to read; none if they match
   */
  public static List<String> mismatch(Qos offered, Qos requested) {
    return new QosMatch(offered, requested).reasons();
  }

  /**
   * Whether a time has no bound.
   *
   * @param time a time
   * @return true for {@link #INFINITE} and beyond
   */
  public static boolean infinite(Duration time) {
    return time.getSeconds() >= Integer.MAX_VALUE;
  }

  /**
   * The same with another reliability.
   *
   * @param value whether lost samples are sent again
   * @return the changed QoS
   */
  public Qos with(Reliability value) {
    return new Qos(value, durability, history, depth, deadline, lifespan, liveliness, livelinessLease, ownership,
        partitions, representations);
  }

  /**
   * The same with another durability.
   *
   * @param value what a late reader gets
   * @return the changed QoS
   */
  public Qos with(Durability value) {
    return new Qos(reliability, value, history, depth, deadline, lifespan, liveliness, livelinessLease, ownership,
        partitions, representations);
  }

  /**
   * The same, of which all samples are kept.
   *
   * @return the changed QoS
   */
  public Qos keepAll() {
    return new Qos(reliability, durability, History.KEEP_ALL, depth, deadline, lifespan, liveliness, livelinessLease,
        ownership, partitions, representations);
  }

  /**
   * The same, of which the newest samples are kept.
   *
   * @param samples how many, at least 1
   * @return the changed QoS
   */
  public Qos withDepth(int samples) {
    return new Qos(reliability, durability, History.KEEP_LAST, samples, deadline, lifespan, liveliness,
        livelinessLease, ownership, partitions, representations);
  }

  /**
   * The same with other times for samples.
   *
   * @param untilNext how long it takes at most until the next sample
   * @param ofUse how long a sample is of use
   * @return the changed QoS
   */
  public Qos withTimes(Duration untilNext, Duration ofUse) {
    return new Qos(reliability, durability, history, depth, untilNext, ofUse, liveliness, livelinessLease, ownership,
        partitions, representations);
  }

  /**
   * The same with another liveliness.
   *
   * @param who says that a writer is alive
   * @param lease how long a writer is alive that nobody speaks for
   * @return the changed QoS
   */
  public Qos with(Liveliness who, Duration lease) {
    return new Qos(reliability, durability, history, depth, deadline, lifespan, who, lease, ownership, partitions,
        representations);
  }

  /**
   * The same with another ownership.
   *
   * @param value whether several writers may write one instance
   * @return the changed QoS
   */
  public Qos with(Ownership value) {
    return new Qos(reliability, durability, history, depth, deadline, lifespan, liveliness, livelinessLease, value,
        partitions, representations);
  }

  /**
   * The same in other partitions.
   *
   * @param names their names or patterns
   * @return the changed QoS
   */
  public Qos withPartitions(List<String> names) {
    return new Qos(reliability, durability, history, depth, deadline, lifespan, liveliness, livelinessLease,
        ownership, names, representations);
  }

  /**
   * The same with other encodings.
   *
   * @param encodings what a writer uses, or all that a reader accepts
   * @return the changed QoS
   */
  public Qos withRepresentations(List<DataRepresentation> encodings) {
    return new Qos(reliability, durability, history, depth, deadline, lifespan, liveliness, livelinessLease,
        ownership, partitions, encodings);
  }
}
