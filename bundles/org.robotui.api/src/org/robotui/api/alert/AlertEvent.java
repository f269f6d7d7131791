package org.robotui.api.alert;

import java.time.Instant;

/**
 * Something that happened to an alert.
 *
 * @param time when, by this machine's clock
 * @param id which alert; one without a name stands for all of the RUIC
 * @param kind what
 * @param source what it was seen at where it began, else empty
 * @param value what was seen there where it began, and until when it is muted where it was, as an {@link Instant}; else
 * empty
 * @param by who did it, for users; empty where nobody did
 */
public record AlertEvent(Instant time, AlertId id, Kind kind, String source, String value, String by) {
  /** What happens to alerts. */
  public enum Kind {
    /** Its condition came to hold. */
    BEGAN,
    /** Its condition holds no more. */
    ENDED,
    /** Somebody has said to have seen it. */
    ACKNOWLEDGED,
    /** Somebody does not want to hear it. */
    MUTED,
    /** Somebody wants to hear it again. */
    UNMUTED
  }
}
