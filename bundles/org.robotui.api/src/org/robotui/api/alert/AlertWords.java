package org.robotui.api.alert;

import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * What is said of alerts, the same in windows and terminals. Immutable.
 *
 * @param zone the user's
 */
public record AlertWords(ZoneId zone) {
  private static final DateTimeFormatter SECOND = DateTimeFormatter.ofPattern("HH:mm:ss", Locale.ROOT);
  private static final DateTimeFormatter MINUTE = DateTimeFormatter.ofPattern("HH:mm", Locale.ROOT);
  private static final DateTimeFormatter DAY_SECOND = DateTimeFormatter.ofPattern("MM-dd HH:mm:ss", Locale.ROOT);
  private static final DateTimeFormatter DAY = DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm", Locale.ROOT);

  /**
   * When an alert began.
   *
   * @param alert the alert
   * @return a time of day to the second
   */
  public String since(Alert alert) {
    return SECOND.format(alert.since().atZone(zone));
  }

  /**
   * How an alert is doing.
   *
   * @param alert the alert
   * @return for example {@code on, muted until 12:10, 3 times}; {@code acknowledged}; {@code over}
   */
  public String state(Alert alert) {
    List<String> words = new ArrayList<>();
    words.add(!alert.lasting() ? "over" : alert.acknowledged() ? "acknowledged" : "on");
    alert.mutedUntil().map(this::muted).ifPresent(words::add);
    if (alert.times() > 1) {
      words.add(alert.times() + " times");
    }
    return String.join(", ", words);
  }

  /**
   * That something is not heard.
   *
   * @param until as of {@link AlertBoard#mute}
   * @return for example {@code muted until 12:10}, with the day where that is more than half a day away
   */
  public String muted(Instant until) {
    if (until.equals(Instant.MAX)) {
      return "muted";
    }
    LocalDateTime end = LocalDateTime.ofInstant(until, zone);
    boolean near = until.isBefore(Instant.now().plusSeconds(12 * 3600));
    return "muted until " + (near ? MINUTE : DAY).format(end);
  }

  /**
   * What happened.
   *
   * @param event an event
   * @return for example {@code began: 0.18}, {@code acknowledged}, {@code muted until 12:10}
   */
  public String what(AlertEvent event) {
    return switch (event.kind()) {
      case BEGAN -> event.value().isEmpty() ? "began" : "began: " + event.value();
      case ENDED -> "over";
      case ACKNOWLEDGED -> "acknowledged";
      case MUTED -> mutedUntil(event.value());
      case UNMUTED -> "unmuted";
    };
  }

  private String mutedUntil(String instant) {
    try {
      return muted(Instant.parse(instant));
    } catch (DateTimeException e) {
      return "muted";
    }
  }

  /**
   * When something happened.
   *
   * @param time the moment
   * @return a time of day to the second, with month and day where that is another one
   */
  public String time(Instant time) {
    LocalDateTime then = LocalDateTime.ofInstant(time, zone);
    boolean today = then.toLocalDate().equals(LocalDateTime.ofInstant(Instant.now(), zone).toLocalDate());
    return (today ? SECOND : DAY_SECOND).format(then);
  }
}
