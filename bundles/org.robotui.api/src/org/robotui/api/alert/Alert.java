package org.robotui.api.alert;

import java.time.Instant;
import java.util.Optional;

/**
 * An alert that is on, or that is over but was not acknowledged yet.
 *
 * @param id which
 * @param condition when it is due, as configured
 * @param source what it was seen at, for example {@code battery.charge}
 * @param value what was seen there last, for example {@code 0.18}
 * @param since when it began the last time, by this machine's clock
 * @param times how often it began since it was acknowledged, at least 1
 * @param lasting whether its condition holds
 * @param acknowledged whether somebody has said to have seen it; it is not heard then
 * @param mutedUntil until when it is not heard, {@link Instant#MAX} where nothing ends that; empty or in the past where
 * it is heard
 */
public record Alert(
    AlertId id, String condition, String source, String value, Instant since, int times, boolean lasting,
    boolean acknowledged,
    Optional<Instant> mutedUntil) {
  /**
   * Whether it waits for somebody.
   *
   * @return false once it was acknowledged
   */
  public boolean isNew() {
    return !acknowledged;
  }
}
