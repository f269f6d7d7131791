package org.robotui.api.host;

import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;

/**
 * How a port of a robot interface is doing, at one moment.
 *
 * @param port the port
 * @param kind what passes through
 * @param typeName its type
 * @param wanted true where a view is connected
 * @param count values since the start
 * @param rateHz values per second over the last seconds
 * @param ageSeconds age of the newest value, NaN before the first
 * @param stale true where the newest value is older than its rate lets expect
 * @param dropped values lost, or dropped for slow consumers
 * @param problem a sentence for users, empty where there is none
 * @param value a short text of the newest value, empty before the first
 * @param delivery what the robot's software promises of its delivery, a sentence for users; empty where it says nothing
 */
public record PortStatus(
    SourceId port,
    PortKind kind,
    String typeName,
    boolean wanted,
    long count,
    double rateHz,
    double ageSeconds,
    boolean stale,
    long dropped,
    String problem,
    String value,
    String delivery) {
  /**
   * Of a port of whose delivery nothing is said.
   *
   * @param port the port
   * @param kind what passes through
   * @param typeName its type
   * @param wanted true where a view is connected
   * @param count values since the start
   * @param rateHz values per second over the last seconds
   * @param ageSeconds age of the newest value, NaN before the first
   * @param stale true where the newest value is older than its rate lets expect
   * @param dropped values lost, or dropped for slow consumers
   * @param problem a sentence for users, empty where there is none
   * @param value a short text of the newest value, empty before the first
   */
  public PortStatus(SourceId port, PortKind kind, String typeName, boolean wanted, long count, double rateHz,
      double ageSeconds, boolean stale, long dropped, String problem, String value) {
    this(port, kind, typeName, wanted, count, rateHz, ageSeconds, stale, dropped, problem, value, "");
  }
}
