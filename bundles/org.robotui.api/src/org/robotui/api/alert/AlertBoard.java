package org.robotui.api.alert;

import java.time.Instant;
import java.util.List;
import java.util.Optional;

/**
 * The alerts of a RUIC, as users see them and what they do with them. What is muted and the history are kept from one
 * run to the next. Safe for all threads; never blocks.
 */
public interface AlertBoard {
  /**
   * What is on or was not acknowledged yet.
   *
   * @return those that wait for somebody first, then those that last, each with the newest first
   */
  List<Alert> alerts();

  /**
   * Says that somebody has seen an alert: it is not heard any more until it begins anew, and is listed only while it
   * lasts.
   *
   * @param alert which; one that is not listed is left as it is
   */
  void acknowledge(AlertId alert);

  /**
   * Keeps one alert from being heard for a time, also when it begins anew meanwhile. It is listed all the same. As many
   * can be muted as are listed; beyond that, the one is heard again that is not listed and would be heard soonest.
   *
   * @param alert which
   * @param until when it is heard again; {@link Instant#MAX} for when somebody says so; empty for now
   */
  void mute(AlertId alert, Optional<Instant> until);

  /**
   * Keeps all from being heard for a time.
   *
   * @param until as of {@link #mute}
   */
  void muteAll(Optional<Instant> until);

  /**
   * Until when none is heard.
   *
   * @return a moment that has not come yet, or empty where they are heard
   */
  Optional<Instant> allMutedUntil();

  /**
   * What happened to the alerts, also in earlier runs: some hundreds of events. What flutters is in it every ten
   * seconds.
   *
   * @return the newest first
   */
  List<AlertEvent> history();
}
