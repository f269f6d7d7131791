package org.robotui.core.internal.time;

import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Acts where the stamps of one robot interface jumped back, and says so. A recording that is repeated says it once, and
 * logs the rest.
 */
public final class TimeNotices implements StampWatch.Ear {
  private static final Logger LOG = LoggerFactory.getLogger(TimeNotices.class);
  private static final double MINUTE = 60;
  private static final double HOUR = 3600;
  private static final double DAY = 86_400;

  private final String component;
  private final Runnable jump;
  private final Consumer<String> notice;
  private final AtomicBoolean said = new AtomicBoolean();

  /**
   * For a robot interface.
   *
   * @param component its id
   * @param jump has all that belongs to the time before forgotten
   * @param notice tells the user a sentence
   */
  public TimeNotices(String component, Runnable jump, Consumer<String> notice) {
    this.component = component;
    this.jump = jump;
    this.notice = notice;
  }

  @Override
  public void jumpedBack(double seconds) {
    jump.run();
    String what = "the stamps of all that " + component + " sends jumped back by " + span(seconds)
        + ", as when a recording begins anew: transforms and what views had collected before were forgotten";
    LOG.info("{}", what);
    if (!said.getAndSet(true)) {
      notice.accept(what);
    }
  }

  @Override
  public void disagree(List<String> fallen, List<String> goingOn, double seconds) {
    notice.accept("of " + component + " the stamps of " + and(fallen) + " jumped back by " + span(seconds)
        + " while those of " + and(goingOn)
        + " go on: what is drawn by them may lie in a wrong place. If a recording began anew, use 'Reset' of the map or the scene");
  }

  private static String and(List<String> names) {
    return names.size() == 1 ? names.getFirst()
        : String.join(", ", names.subList(0, names.size() - 1)) + " and " + names.getLast();
  }

  private static String span(double seconds) {
    if (seconds < 2 * MINUTE) {
      return String.format(Locale.ROOT, "%.1f s", seconds);
    }
    if (seconds < 2 * HOUR) {
      return String.format(Locale.ROOT, "%.0f minutes", seconds / MINUTE);
    }
    return seconds < 2 * DAY ? String.format(Locale.ROOT, "%.0f hours", seconds / HOUR)
        : String.format(Locale.ROOT, "%.0f days", seconds / DAY);
  }
}
