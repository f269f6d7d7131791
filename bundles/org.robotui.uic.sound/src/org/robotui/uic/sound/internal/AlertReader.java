package org.robotui.uic.sound.internal;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.condition.Condition;
import org.robotui.condition.TimedCondition;
import org.robotui.uic.sound.internal.alert.AlertConfig;
import org.robotui.uic.sound.internal.tone.Sound;

/** Reads alerts out of settings. */
final class AlertReader {
  private static final double NANOS = 1e9;

  private AlertReader() {}

  /**
   * Reads all.
   *
   * @throws IllegalArgumentException where one cannot be read; the message says which, what is wrong and what to write
   */
  static List<AlertConfig> read(Settings settings) {
    if (settings.has(SoundType.MUTED_UNTIL)) {
      Mute.time(settings.text(SoundType.MUTED_UNTIL));
    }
    List<AlertConfig> alerts = new ArrayList<>();
    for (Object item : settings.list(SoundType.ALERTS)) {
      alerts.add(read((Settings) item, alerts));
    }
    return alerts;
  }

  private static AlertConfig read(Settings item, List<AlertConfig> before) {
    int number = before.size() + 1;
    String said = item.has(SoundType.NAME) ? item.text(SoundType.NAME) : item.text(SoundType.WHEN);
    // They are told apart, muted and acknowledged by their names.
    String name = before.stream().anyMatch(other -> other.name().equals(said)) ? said + " (" + number + ")" : said;
    try {
      TimedCondition timed = TimedCondition.parse(item.text(SoundType.WHEN), item.number(SoundType.HYSTERESIS));
      Condition condition = timed.condition();
      if (condition.momentary() && item.number(SoundType.FOR) > 0) {
        throw new IllegalArgumentException(
            "what is over as soon as it happens does not last; leave out '" + SoundType.FOR + "'");
      }
      if (timed.forNanos() > 0 && item.number(SoundType.FOR) > 0) {
        throw new IllegalArgumentException(
            "'" + SoundType.FOR + "' is said twice; leave it out of '" + SoundType.WHEN + "', or here");
      }
      return new AlertConfig(name, item.text(SoundType.WHEN), condition, Sound.parse(item.placed(SoundType.SOUND)),
          item.number(SoundType.VOLUME), words(item, name),
          timed.forNanos() + nanos(item, SoundType.FOR), nanos(item, SoundType.REPEAT), item.flag(SoundType.MUTED),
          script(item));
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException("alert " + number + " (" + name + "): " + e.getMessage(), e);
    }
  }

  private static Optional<Path> script(Settings item) {
    return item.has(SoundType.SCRIPT)
        ? Optional.of(item.placed(SoundType.SCRIPT)).map(written -> written.resolve(written.value().toString()))
        : Optional.empty();
  }

  private static String words(Settings item, String name) {
    String own = item.has(SoundType.WORDS) ? item.text(SoundType.WORDS) : name;
    return item.flag(SoundType.SPEECH) ? own : "";
  }

  private static long nanos(Settings item, String setting) {
    return Math.round(item.number(setting) * NANOS);
  }
}
