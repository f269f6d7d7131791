package org.robotui.uic.sound.internal;

import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.util.Optional;
import org.robotui.api.config.Settings;

/** Until when the settings keep alerts from being heard. */
final class Mute {
  private Mute() {}

  /**
   * Until when all are muted.
   *
   * @return a moment, also one that has passed; {@link Instant#MAX} for good; empty where they say nothing
   * @throws IllegalArgumentException where the time cannot be read
   */
  static Optional<Instant> until(Settings settings) {
    if (settings.flag(SoundType.MUTED)) {
      return Optional.of(Instant.MAX);
    }
    return settings.has(SoundType.MUTED_UNTIL) ? Optional.of(time(settings.text(SoundType.MUTED_UNTIL)))
        : Optional.empty();
  }

  /** Reads a time; without a zone it is the user's. */
  static Instant time(String text) {
    try {
      return text.endsWith("Z") ? Instant.parse(text)
          : LocalDateTime.parse(text).atZone(ZoneId.systemDefault()).toInstant();
    } catch (DateTimeException e) {
      throw new IllegalArgumentException(
          SoundType.MUTED_UNTIL + ": '" + text + "' is no time; write for example 2026-11-21T18:00, or with Z for UTC",
          e);
    }
  }
}
